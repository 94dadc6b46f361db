"""Errors that are planted in templates, and the small problems on whose pages they show."""

A = [[0, 1], [-2, -3]]
PLANT = {"A": [[1, 0, -1], [1, 2, 1], [2, 2, 3]], "B": [1, 0, 1]}
PROBLEMS = {
    "polynomial": {"system": {"matrix": [[1, 2, 0], [3, 1, 1], [0, 2, 5]]}, "find": {"a": "characteristic_polynomial"}},
    "companion": {"system": {"A": [[0, 1, 0], [0, 0, 1], [-6, -11, -6]]}, "find": {"a": "stability"}},
    "placement": {
        "system": PLANT,
        "find": {
            method: {"task": "pole_placement", "method": method, "poles": [-1, "-1 ± 2j"]}
            for method in ("coefficient_matching", "bass_gura", "canonical_form", "ackermann")
        },
    },
    "specified": {
        "system": {"A": [[0, -1], [-3, -2]], "B": [0, 1]},
        "find": {"a": {"task": "pole_placement", "settling_time": 2, "peak_time": 1}},
    },
    "transition": {
        "system": {"A": A},
        "find": {
            method: {"task": "state_transition_matrix", "method": method}
            for method in ("laplace", "modal", "cayley_hamilton", "power_series")
        },
    },
    "hidden": {
        "system": {"A": [[1, 0], [0, -2]], "B": [0, 1], "C": [0, 1]},
        "find": {"a": "controllability", "b": "observability"},
    },
    "reached": {"system": {"A": A, "B": [0, 1]}, "find": {"a": "controllability"}},
    "circuit": {
        "system": {"A": [[0, "1/C"], ["-1/L", 0]], "B": [0, "1/L"], "C": [1, 0]},
        "find": {"a": "controllability"},
    },
    "coordinates": {
        "system": {"A": A, "B": [0, 1], "C": [1, 0]},
        "find": {"a": {"task": "similarity_transformation", "T": [[1, 1], [1, 2]]}},
    },
    "three_states": {
        "system": {"A": [[0, 1, 0], [0, 0, 1], [-6, -11, -6]]},
        "find": {"a": {"task": "similarity_transformation", "T": [[1, 1, 1], [-1, -2, -3], [1, 4, 9]]}},
    },
    "transfer": {
        "system": {"A": A, "B": [0, 1], "C": [1, 0]},
        "find": {"a": {"task": "transfer_function", "method": "faddeev_leverrier"}},
    },
    "regulator": {
        "system": {"A": [[0, 1], [0, 0]], "B": [0, 1]},
        "find": {
            method: {"task": "lqr", "method": method, "Q": [[1, 0], [0, 1]], "R": 1}
            for method in ("riccati", "hamiltonian")
        },
    },
    "closed": {
        "system": {"A": [[0, 1], [0, 0]], "B": [0, 1]},
        "find": {"a": {"task": "eigenstructure", "gain": [2, 3]}},
    },
    "location": {"system": {"A": [[0, 1], [-1, -3]]}, "find": {"a": {"task": "stability", "method": "eigenvalues"}}},
    "hurwitz": {
        "system": {"polynomial": "s^3 + 2s^2 + 3s + 1"},
        "find": {"a": {"task": "routh_hurwitz", "method": "hurwitz_determinants"}},
    },
    "start": {
        "system": {"A": [[0, 1], [0, 0]], "B": [0, 1]},
        "find": {"a": {"task": "lqr", "Q": [[1, 0], [0, 1]], "R": 1, "initial_state": [1, 2]}},
    },
    "convolved": {
        "system": {"A": A, "B": [0, 1], "C": [1, 0]},
        "find": {"a": {"task": "response", "method": "convolution", "kind": "zero_state", "input": "1"}},
    },
    "roots": {"system": {"A": [[0, 1], [-1, -3]]}, "find": {"a": "eigenstructure"}},
    "separated": {
        "system": {"A": [[0, 1], [-2, -3]], "B": [0, 1], "C": [1, 0]},
        "find": {"a": {"task": "observer_feedback", "gain": [4, 2], "observer_gain": [5, 6]}},
    },
    "final": {
        "system": {"A": A, "B": [0, 1], "C": [1, 0]},
        "find": {"a": {"task": "response", "kind": "zero_state", "input": "1"}},
    },
}
"""Small problems in whose pages errors are planted."""

PLANTED = {
    "the sign in the left side of a macro": (
        "polynomial",
        "lemmas/determinant",
        ' I - A", v.pencil',
        ' I + A", v.pencil',
    ),
    "the value of a macro": ("polynomial", "lemmas/determinant", "v.pencil) }}", "2 * v.pencil) }}"),
    "the prefix of a claim": (
        "polynomial",
        "lemmas/determinant",
        '{{ eq("\\\\det(" ~ v.x|tex ~ " I - A)", c.stated.left,',
        '{{ eq("2\\\\det(" ~ v.x|tex ~ " I - A)", c.stated.left,',
    ),
    "the prefix of another claim": ("closed", "lemmas/closed_loop", 'claim(c.loop, "A - B"', 'claim(c.loop, "A + B"'),
    "a line further down": (
        *("polynomial", "lemmas/arithmetic/determinants", 'else "", c.value.right) }}'),
        'else "", 2 * c.value.right) }}',
    ),
    "a factor before a determinant": (
        *("polynomial", "lemmas/determinant", '{{ eq("\\\\det(" ~ v.x|tex ~ " I - A)", c.value.right) }}\n{% endif %}'),
        '{{ eq("2\\\\det(" ~ v.x|tex ~ " I - A)", c.value.right) }}\n{% endif %}',
    ),
    "a factor before the determinant of a companion matrix": (
        *("companion", "lemmas/determinant", '{{ eq("\\\\det(" ~ v.x|tex ~ " I - A)", c.value'),
        '{{ eq("2\\\\det(" ~ v.x|tex ~ " I - A)", c.value',
    ),
    "the trace for the determinant": (
        *("coordinates", "similarity_transformation/similarity_transformation", '"\\\\det T"'),
        '"\\\\operatorname{tr} T"',
    ),
    "an inverse left out": (
        *("coordinates", "lemmas/arithmetic/inverses", 'eq(v.name ~ "^{-1}", c.stated'),
        "eq(v.name, c.stated",
    ),
    "an adjugate": (
        *("three_states", "lemmas/arithmetic/inverses", '\\\\operatorname{adj}" ~ v.name'),
        '\\\\operatorname{adj}2" ~ v.name',
    ),
    "the order of a product": (
        *("coordinates", "similarity_transformation/similarity_transformation", '{{ claim(c.AT, "AT") }}'),
        '{{ claim(c.AT, "TA") }}',
    ),
    "the transformation turned round": (
        *("coordinates", "similarity_transformation/similarity_transformation", '"T^{-1}AT", v.inverted'),
        '"TAT^{-1}", v.inverted',
    ),
    "an answer under its own name": (
        "placement",
        "lemmas/placement",
        "{{ claim(c.polynomial, hat) }}",
        "{{ eq(hat, 2) }}",
    ),
    "the determinant of a matrix of the step": (
        *("placement", "lemmas/placement", '{{ eq("\\\\det " ~ matrix(v)'),
        '{{ eq("\\\\operatorname{tr} " ~ matrix(v)',
    ),
    "two traces for a determinant": (
        *("placement", "lemmas/placement", '{{ eq("\\\\det " ~ matrix(v)'),
        '{{ eq("2\\\\operatorname{tr} " ~ matrix(v)',
    ),
    "the matrix of the coefficients": (
        "placement",
        "lemmas/placement_methods",
        '(matrix(v) ~ "W")',
        '("W" ~ matrix(v))',
    ),
    "a power in a row of names": (
        *("placement", "lemmas/placement_methods", '("q " ~ (A(v) ~ ("^{" ~ i ~ "}" if i > 1'),
        '("q " ~ (A(v) ~ ("^{" ~ i + 1 ~ "}" if i > 1',
    ),
    "an inverse that is none": (
        "placement",
        "lemmas/placement_methods",
        '"P^{-1}", c.inverse.right',
        '"P", c.inverse.right',
    ),
    "the rows of a transformation": (
        "placement",
        "lemmas/placement_methods",
        '{{ eq("P", v.P) }}',
        '{{ eq("P", v.P.T) }}',
    ),
    "the closed loop": ("placement", "lemmas/placement", 'plant(v) ~ " - " ~ product', 'plant(v) ~ " + " ~ product'),
    "a time for another": (
        "specified",
        "lemmas/second_order",
        '"\\\\frac{\\\\pi}{" ~ sym.peak_time',
        '"\\\\frac{\\\\pi}{" ~ sym.settling_time',
    ),
    "the band of a settling time": (
        *("specified", "lemmas/second_order", '"\\\\frac{" ~ v.band ~ "}{" ~ sym.settling_time'),
        '"\\\\frac{" ~ v.band + 1 ~ "}{" ~ sym.settling_time',
    ),
    "the sign under a root": (
        "specified",
        "lemmas/second_order",
        '(" ~ z ~ "\\\\omega_{n})^{2} + ',
        '(" ~ z ~ "\\\\omega_{n})^{2} - ',
    ),
    "a quotient turned round": (
        "specified",
        "lemmas/second_order",
        '"\\\\frac{" ~ z ~ "\\\\omega_{n}}{\\\\omega_{n}}"',
        '"\\\\frac{\\\\omega_{n}}{" ~ z ~ "\\\\omega_{n}}"',
    ),
    "the adjugate of a pencil": (
        "transition",
        "lemmas/resolvent",
        '{{ eq("\\\\operatorname{adj}(" ~ v.x|tex ~ " I - A)"',
        '{{ eq("\\\\operatorname{adj}(" ~ v.x|tex ~ " I + A)"',
    ),
    "a quotient of two formulas": (
        "transition",
        "lemmas/resolvent",
        '"\\\\frac{\\\\operatorname{adj}(" ~ v.x|tex ~ " I - A)}{\\\\det("',
        '"\\\\frac{\\\\operatorname{adj}(" ~ v.x|tex ~ " I - A)}{2\\\\det("',
    ),
    "a resolvent": ("transition", "lemmas/resolvent", '" I - A)^{-1}", c.expansion', '" I + A)^{-1}", c.expansion'),
    "a modal matrix": ("transition", "state_transition_matrix/modal", "v.modal) }}", "v.modal.T) }}"),
    "the answer at its end": (
        "transition",
        "state_transition_matrix/modal",
        "{{ eq(Phi, c.Phi.right) }}",
        "{{ eq(Phi, c.Phi.right.T) }}",
    ),
    "a coefficient of Cayley and Hamilton": (
        "transition",
        "state_transition_matrix/cayley_hamilton",
        'loop.index0 ~ "}", a) }}',
        'loop.index0 ~ "}", -a) }}',
    ),
    "a row of equations": (
        "transition",
        "state_transition_matrix/cayley_hamilton",
        "{{ align(v.equations) }}",
        "{{ align([[1, 2]]) }}",
    ),
    "a power of a matrix": (
        "transition",
        "state_transition_matrix/power_series",
        '"A^{" ~ (loop.index + 1)',
        '"A^{" ~ (loop.index + 2)',
    ),
    "a polynomial in a matrix": (
        "transition",
        "state_transition_matrix/cayley_hamilton",
        'else "e^{At}", v.polynomial',
        'else "e^{2At}", v.polynomial',
    ),
    "a determinant with a capacitance C": (
        "circuit",
        "lemmas/rank_test",
        '"\\\\det " ~ symbol',
        '"2\\\\det " ~ symbol',
    ),
    "a relation of numbers": ("hidden", "lemmas/rank_test", 'v.r ~ " < " ~ v.n', 'v.r ~ " > " ~ v.n'),
    "a number in a chain with a relation": (
        "hidden",
        "lemmas/rank_test",
        '" < " ~ v.n ~ " = n"',
        '" < " ~ v.n + 1 ~ " = n"',
    ),
    "a rank": ("reached", "lemmas/rank_test", ', v.r, "n") }}', ', v.r + 1, "n") }}'),
    "a row of names": (
        "reached",
        "lemmas/rank_test",
        "{{ eq(v.names[loop.index], each.left",
        '{{ eq("A" ~ v.names[loop.index], each.left',
    ),
    "a zero in a line of text": (
        "hidden",
        "lemmas/hidden_part",
        "}}\\,{{ sym.controllability_matrix }} = 0$",
        "}}\\,{{ sym.controllability_matrix }} = 1$",
    ),
    "a basis under its name": (
        "hidden",
        "lemmas/hidden_part",
        "{{ eq(sym.hidden_states, v.N) }}",
        "{{ eq(sym.hidden_states, v.N + v.N.ones(*v.N.shape)) }}",
    ),
    "a matrix explained behind an equation": (
        "hidden",
        "lemmas/hidden_part",
        'note=",\\\\qquad H = " ~ (',
        'note=",\\\\qquad H = 2" ~ (',
    ),
    "a product with a hidden basis": (
        "hidden",
        "lemmas/hidden_part",
        'sym.hidden_states ~ " A", c.invariant',
        '"2" ~ sym.hidden_states ~ " A", c.invariant',
    ),
    "a sign of the real part": ("location", "lemmas/location", '" < " if each.position', '" > " if each.position'),
    "an approximation": (
        "location",
        "lemmas/location",
        '" \\\\approx " ~ near|tex',
        '" \\\\approx 2\\\\cdot " ~ near|tex',
    ),
    "a block matrix": ("regulator", "lemmas/hamiltonian", '~ " \\\\\\\\ -" ~ v.Q_name', '~ " \\\\\\\\ " ~ v.Q_name'),
    "the polynomial of a block matrix": ("regulator", "lemmas/hamiltonian", '"\\\\det(sI - H)"', '"\\\\det(sI - 2H)"'),
    "a polynomial of a matrix": ("regulator", "lemmas/hamiltonian", '"p(H)"', '"p(2H)"'),
    "what goes on behind a matrix": ("regulator", "lemmas/hamiltonian", 'note="P = "', 'note="P = 2"'),
    "a product of three": ("regulator", "lemmas/hamiltonian", '~ "R^{-1}" ~ v.Bt) }}', '~ "R^{-2}" ~ v.B) }}'),
    "the Riccati equation": ("regulator", "lemmas/riccati_equations", '~ " - P" ~ v.B', '~ " + P" ~ v.B'),
    "a coefficient of the numerator": (
        "transfer",
        "transfer_function/faddeev_leverrier",
        '"CN_{" ~ k ~ "}B"',
        '"2CN_{" ~ k ~ "}B"',
    ),
    "the numerator": (
        "transfer",
        "transfer_function/faddeev_leverrier",
        '"C\\\\operatorname{adj}("',
        '"2C\\\\operatorname{adj}("',
    ),
    "a determinant of Hurwitz": (
        "hurwitz",
        "routh_hurwitz/hurwitz_determinants",
        '{{ claim(each, "\\\\Delta_{" ~ loop.index ~ "}")',
        '{{ claim(each, "\\\\det H")',
    ),
    "a difference turned round": (
        "placement",
        "lemmas/placement_methods",
        '"(\\\\hat{a} - a)^{T}"',
        '"(a - \\\\hat{a})^{T}"',
    ),
    "a law of Bass and Gura": (
        "placement",
        "lemmas/placement_methods",
        '("(\\\\hat{a} - a)^{T}" ~ product)',
        '("(\\\\hat{a} + a)^{T}" ~ product)',
    ),
    "the loop with unknowns": (
        "placement",
        "lemmas/coefficient_matching",
        'A(v) ~ " + " ~ (gain',
        'A(v) ~ " - " ~ (gain',
    ),
    "the sign of a control law": ("regulator", "lemmas/regulator", '"-" ~ sym.K ~ "x"', 'sym.K ~ "x"'),
    "the state at the start": ("start", "lemmas/regulator", '"x(0)^{T}Px(0)")', '"x(0)^{T}x(0)")'),
    "the first matrix of a recursion": ("transfer", "lemmas/faddeev_leverrier", 'eq("AN_{"', 'eq("2AN_{"'),
    "a trace": ("transfer", "lemmas/faddeev_leverrier", '"\\\\operatorname{tr}(AN_{"', '"\\\\operatorname{tr}(2AN_{"'),
    "the product of modal matrices": (
        "transition",
        "state_transition_matrix/modal",
        '("V" ~ middle(v) ~ "V^{-1}")',
        '("V" ~ middle(v) ~ "V")',
    ),
    "exponentials of a diagonal": (
        "transition",
        "state_transition_matrix/modal",
        'else "e^{Jt}"',
        'else "e^{2Jt}"',
    ),
    "the final value theorem": ("final", "lemmas/response", "s\\\\,Y(s)", "Y(s)"),
    "an integrand": ("convolved", "lemmas/response_convolution", "\\\\Phi(t-\\\\tau)\\\\,B", "\\\\Phi(t)\\\\,B"),
    "the quadratic formula": ("roots", "lemmas/arithmetic/quadratics", "{b^{2}}{4} - c", "{b^{2}}{4} + c"),
    "both signs of a pair": ("specified", "lemmas/second_order", "\\\\pm j\\\\omega", "\\\\pm 2j\\\\omega"),
    "the matrix of the compensator": ("separated", "lemmas/output_feedback", '" I - F)"', '" I + F)"'),
}
"""Places and kinds of errors: the problem, the template, what stands there and what is planted."""
