"""Written formulas as `Stated` ones: names replaced by their values, identities and zeros given their shapes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import sympy as sp

from solver.displayed.matrix_functions import function_of_matrix
from solver.displayed.names import VARIABLES, Names
from solver.displayed.scalars import FUNCTIONS, plain
from solver.displayed.shapes import (
    OF_A_MATRIX,
    SCALAR,
    Shape,
    complete,
    known,
    of_product,
    selections,
    shape_of,
)
from solver.displayed.statements import meaning_in, names_in
from solver.displayed.tree import Meaning, Unreadable, key_of
from solver.formula import latex
from solver.lazy import numeric
from solver.matrices import identity
from solver.render.symbols import named
from solver.stated import Stated
from solver.stated.algebra import difference, exponential, power, product, quotient, total
from solver.stated.calculus import derivative, integral, partial_derivative, value_at
from solver.stated.limits import limit
from solver.stated.lists import summation
from solver.stated.matrices import inverse, transpose
from solver.stated.transforms import inverse_laplace, inverse_z
from solver.words import Phrase


class Unknown(Exception):  # noqa: N818 - no error: a statement about something that has no value here
    """A formula has a name that stands for no value on the page: x, u, or what a law is written with."""


class Writer:
    """Turns what was read into a formula that the oracle evaluates."""

    def __init__(self, names: Names, values: Sequence[Any], known: Mapping[Any, Any] | None = None) -> None:
        self.names = names
        self.values = values
        self.known = known or {}

    def formula(self, meaning: Meaning, shape: Shape = None) -> Any:
        """Return the formula, as a matrix of a shape where its own is open. Raises Unknown, Unreadable."""
        handler: Callable[[Meaning, Shape], Any] | None = getattr(self, f"_{meaning.kind}", None)
        if handler is not None:
            found = handler(meaning, shape)
            return self.known.get(found, found) if isinstance(found, Stated) else found
        argument = self.formula(meaning.parts[0])
        if meaning.kind in FUNCTIONS:
            if argument in VARIABLES.values():  # Re λ < 0 is a condition
                raise Unknown(meaning.kind)
            if shape_of(argument) != SCALAR:
                return self._of_matrix(meaning.kind, argument)
            return FUNCTIONS[meaning.kind](plain(argument))
        if meaning.kind == "exp":
            return exponential(argument)
        return Stated(meaning.kind, (argument,))

    def _of_matrix(self, name: str, argument: Any) -> Any:
        found = function_of_matrix(name, argument)
        if found is None:
            raise Unreadable(Phrase("the function {name} of a matrix", name=name))
        return found

    def knows(self, meaning: Meaning) -> bool:
        """Whether every name in a formula stands for a value: laws are written with others."""
        if meaning.kind == "name":
            return meaning.text == "I" or meaning.text in VARIABLES or self.names.value(meaning.text) is not None
        if meaning.kind == "apply" and self.names.value(key_of(meaning)) is not None:
            return True
        return all(map(self.knows, meaning.parts))

    def shape(self, meaning: Meaning) -> Shape:
        """Return the shape of what was read; None where its place decides."""
        kind, parts = meaning.kind, meaning.parts
        is_identity = kind == "name" and meaning.text == "I" and self.names.value("I") is None
        if is_identity or kind == "unit_row" or (kind == "number" and meaning.text == 0):
            return None
        if kind == "sum":
            shapes = [self.shape(part) for part in parts]
            return next((s for s in shapes if s not in (None, SCALAR)), SCALAR if SCALAR in shapes else None)
        if kind == "product":
            return of_product([self.shape(part) for part in parts])
        if kind in ("minus", "power", "fraction", "adjugate", "transpose"):
            inner = self.shape(parts[0])
            return inner and (inner[::-1] if kind == "transpose" else inner)
        if kind == "matrix":
            heights, widths = self._sizes(meaning)
            return sum(heights), sum(widths)
        return SCALAR if kind in OF_A_MATRIX else shape_of(self.formula(meaning))

    def _value(self, meaning: Meaning, _: Shape) -> Any:
        value = self.values[meaning.text]
        if isinstance(value, list | tuple):
            raise Unreadable("a list within a formula")
        return value

    def _number(self, meaning: Meaning, shape: Shape) -> Any:
        if meaning.text == 0 and shape not in (None, SCALAR):
            return sp.ImmutableMatrix(sp.zeros(*known(shape)))
        return meaning.text

    def _name(self, meaning: Meaning, shape: Shape) -> Any:
        value = self.names.value(meaning.text)
        if value is None and meaning.text == "I":
            return identity(known(shape)[0])
        if value is None:
            value = VARIABLES.get(meaning.text)
        if value is None:
            raise Unknown(meaning.text)
        if isinstance(value, list | tuple | str | bool):
            raise Unreadable("a list within a formula")
        return value

    def _apply(self, meaning: Meaning, shape: Shape) -> Any:
        """Return f(x): the value of the name f(x), f with x for its variable, or a product with what is in brackets."""
        name, argument = meaning.parts
        function = self.names.value(f"{name.text}()")
        if function is not None:
            return self._of_function(function[0], function[1], self.formula(argument))
        if (known := self.names.value(key_of(meaning))) is not None:
            return known
        if argument.kind == "number":
            return self._at_number(self._name(name, None), argument.text)
        if argument.text in VARIABLES and argument.kind == "name" and self.names.value(argument.text) is None:
            return self._name(name, shape)  # x(t) where x stands for the function
        value = self.names.value(name.text)
        if isinstance(value, sp.Expr):
            for variable in (VARIABLES["s"], VARIABLES["z"], VARIABLES[r"\lambda"]):
                if variable in value.free_symbols:
                    return self._of_function(value, variable, self.formula(argument))
        return self._product(Meaning("product", meaning.parts), shape)

    def _at_number(self, body: Any, number: Any) -> Any:
        variable = next((VARIABLES[each] for each in ("t", "k") if VARIABLES[each] in numeric.free_symbols(body)), None)
        if variable is None:
            raise Unknown("a value at a number")
        return value_at(body, variable, number)

    def _of_function(self, body: Any, variable: Any, argument: Any) -> Any:
        if argument == sp.oo:
            raise Unreadable("a value at infinity")
        if argument == variable:
            return body
        if shape_of(argument) == SCALAR:
            return value_at(body, variable, argument)
        if isinstance(body, Stated) or not body.is_polynomial(variable):
            raise Unreadable("a function of a matrix")
        n = known(shape_of(argument))[0]
        terms = sp.Poly(body, variable).terms()
        return total(*(product(c, power(argument, i)) if i else c * identity(n) for (i,), c in terms))

    def _sum(self, meaning: Meaning, shape: Shape) -> Any:
        own = self.shape(meaning)
        shape = shape if own is None else own
        result: Any = None
        for part in meaning.parts:
            negative = part.kind == "minus"
            term = self.formula(part.parts[0] if negative else part, shape)
            if part.kind == "number" and shape not in (None, SCALAR):  # A² + 1 is A² + I
                term = product(part.text, identity(known(shape)[0]))
            if result is None:
                result = product(-1, term) if negative else term
            else:
                result = difference(result, term) if negative else total(result, term)
        return result

    def _minus(self, meaning: Meaning, shape: Shape) -> Any:
        return product(-1, self.formula(meaning.parts[0], shape))

    def _product(self, meaning: Meaning, shape: Shape) -> Any:
        shapes = [self.shape(part) for part in meaning.parts]
        if None in shapes and all(each in (None, SCALAR) for each in shapes):
            pairs = zip(meaning.parts, shapes, strict=True)
            return product(*(self.formula(part, own or shape) for part, own in pairs))
        factors = []
        for i, (part, own) in enumerate(zip(meaning.parts, shapes, strict=True)):
            others = (each for each in [*shapes[i + 1 :], *shapes[:i]] if each not in (None, SCALAR))
            size = known(next(others, None))[0] if own is None else 0  # an identity or zero beside a matrix
            factors.append(self.formula(part, own or (size, size)))
        return product(*factors)

    def _fraction(self, meaning: Meaning, shape: Shape) -> Any:
        above, below = meaning.parts
        return quotient(self.formula(above, shape), self.formula(below))

    def _transpose(self, meaning: Meaning, shape: Shape) -> Any:
        return transpose(self.formula(meaning.parts[0], shape and shape[::-1]))

    def _power(self, meaning: Meaning, shape: Shape) -> Any:
        base, exponent = meaning.parts
        if base == Meaning("name", text="e") and self.names.value("e") == sp.E:
            return exponential(self.formula(exponent))
        order = self.formula(exponent)
        body = self.formula(base, shape)
        return inverse(body) if order in (-1, product(-1, sp.Integer(1))) else power(body, plain(order))

    def _value_at(self, meaning: Meaning, shape: Shape) -> Any:
        body, variable, value = meaning.parts
        return value_at(self.formula(body, shape), VARIABLES.get(variable.text), self.formula(value))

    def _limit(self, meaning: Meaning, shape: Shape) -> Any:
        body, variable, value = meaning.parts
        return limit(self.formula(body, shape), VARIABLES.get(variable.text), self.formula(value))

    def _integral(self, meaning: Meaning, shape: Shape) -> Any:
        body, variable, lower, upper = meaning.parts
        if r"\infty" in names_in(lower):
            raise Unreadable("an integral without beginning")
        limits = [self.formula(lower), self.formula(upper)]
        return integral(self.formula(body, shape), VARIABLES.get(variable.text), *limits)

    def _summation(self, meaning: Meaning, shape: Shape) -> Any:
        body, variable, lower, upper = meaning.parts
        limits = [self.formula(lower), self.formula(upper)]
        if sp.oo in limits or variable.text not in VARIABLES:
            raise Unreadable("a sum without end")
        return summation(self.formula(body, shape), VARIABLES[variable.text], *limits)

    def _inverse_laplace(self, meaning: Meaning, _: Shape) -> Any:
        return inverse_laplace(self.formula(meaning.parts[0]), VARIABLES["s"], VARIABLES["t"])

    def _inverse_z(self, meaning: Meaning, _: Shape) -> Any:
        return inverse_z(self.formula(meaning.parts[0]), VARIABLES["z"], VARIABLES["k"])

    def _unit_row(self, _: Meaning, shape: Shape) -> Any:
        return identity(known(shape)[1])[-1, :]

    def _derivative(self, meaning: Meaning, _: Shape) -> Any:
        name, variable = meaning.parts
        return derivative(self.formula(Meaning("apply", (name, variable), name.text)), VARIABLES.get(variable.text))

    def _partial_derivative(self, meaning: Meaning, _: Shape) -> Any:
        function, variable = meaning.parts
        body = self.formula(function)
        own = (each for each in numeric.free_symbols(body) if meaning_in(latex(named(each.name))) == variable)
        x = self.values[variable.text] if variable.kind == "value" else next(own, None)
        return sp.Integer(0) if x is None else partial_derivative(body, x)

    def _sizes(self, meaning: Meaning, shape: Shape = None) -> tuple[list[int], list[int]]:
        """Return the heights of the rows and widths of the columns of a block matrix."""
        shapes = [[self.shape(cell) for cell in row.parts] for row in meaning.parts]
        if len({len(row) for row in shapes}) != 1:
            raise Unreadable("rows of different lengths")
        heights = [next((s[0] for s in row if s is not None), 0) for row in shapes]
        widths = [next((s[1] for s in column if s is not None), 0) for column in zip(*shapes, strict=True)]
        if shape is not None:
            complete(widths, shape[1])
        for i, row in enumerate(meaning.parts):
            for j, cell in enumerate(row.parts):
                if cell.kind == "name":  # an identity is square
                    heights[i], widths[j] = heights[i] or widths[j], widths[j] or heights[i]
        if shape is not None:
            complete(heights, shape[0])
        return [height or 1 for height in heights], [width or 1 for width in widths]

    def _matrix(self, meaning: Meaning, shape: Shape) -> Any:
        """Return a block matrix as Σ Eᵢ Mᵢⱼ Eⱼᵀ, with the columns Eᵢ of the identity that belong to a row of blocks."""
        heights, widths = self._sizes(meaning, shape)
        left, right = selections(tuple(heights)), selections(tuple(widths))
        cells = [
            (i, j, self.formula(cell, (heights[i], widths[j])))
            for i, row in enumerate(meaning.parts)
            for j, cell in enumerate(row.parts)
        ]
        return total(*(product(left[i], cell, right[j].T) for i, j, cell in cells))
