"""Lemma: linear difference equations by the z-transform: transformed line by line, solved, and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient, total
from solver.stated.matrices import determinant
from solver.tasks.transforms.back_transform import Names
from solver.tasks.transforms.equation_question import capital
from solver.tasks.transforms.forward import transformed
from solver.tasks.transforms.sequence_back import by_fractions_over_z, of_image

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.tasks.transforms.difference_question import Question


@lemma("transformed_samples")
def by_z_transform(asked: Question) -> Derivation[dict[str, Expr]]:
    """The sequences by the names of the unknowns."""
    if not asked.at_rest and asked.moved:
        yield moved_step(asked)
    yield _shifts(asked)
    for name in asked.model.inputs:
        yield from _image(asked.inputs[name], asked.pieces[name], asked.names(name))
    for i, pieces in enumerate(asked.rests):
        if pieces:
            yield from _image(asked.operators.rows[i].rest, pieces, _rest_names(asked, i), rest=True)
    yield _equations(asked)
    yield _solved(asked)
    found: dict[str, Expr] = {}
    for name in asked.model.unknowns:
        names, image = asked.names(name), asked.images[name]
        if image == 0:
            yield Step("nothing", unclaimed="zero in the transform is zero at all samples", **names.told)
            found[name] = sp.S.Zero
        else:
            found[name], _ = yield from of_image(image, by_fractions_over_z, names)
    return found


def moved_step(asked: Question) -> Step:
    """The equations so many samples later that they hold from k = 0 on."""
    rows = [shown_row(asked, row) for row in asked.operators.rows]
    return Step("moved", unclaimed="the equations at another sample", rows=rows, by=asked.moved,
                start=given_values(asked))  # fmt: skip


def given_values(asked: Question) -> list[tuple[Symbol, int, Expr]]:
    """The values that the sequences begin with: name, sample, value."""
    return [(sp.Symbol(name), m, value) for (name, m), value in asked.start.items()]


def shown_row(asked: Question, row: exact.SampleRow) -> tuple[Any, Any]:
    """An equation with the unknowns on the left, the latest samples first."""
    model = asked.model

    def side(terms: Mapping[Any, Expr]) -> list[Any]:
        ordered = sorted(terms.items(), key=lambda each: (-each[0][1], str(each[0][0])))
        return [_scaled(c, model.symbol(jet)) for jet, c in ordered]

    right = [*side(row.inputs), *([row.rest] if row.rest != 0 else [])]
    return total(*side(row.unknowns)), total(*right) if right else sp.S.Zero


def _scaled(factor: Expr, what: Any) -> Any:
    return what if factor == 1 else factor * what if isinstance(what, sp.Symbol) else product(factor, what)


def _rest_names(asked: Question, i: int) -> Names:
    """What the rest of a row is called: by a letter that the equations leave free."""
    model = asked.model
    taken = {*model.unknowns, *model.inputs, *(str(each) for each in model.parameters)}
    letter = next((each for each in "rghvwpq" if not {each, each.upper()} & taken), "r")
    number = f"_{{{i + 1}}}" if len(asked.operators.rows) > 1 else ""
    return Names(f"{letter.upper()}{number}", f"{letter}{number}", asked.z, asked.k)


@lemma("transformed_samples")
def _image(f: Expr, pieces: tuple[exact.TransformPiece, ...], names: Names, *, rest: bool = False) -> Derivation[None]:
    """The transform of a sequence that acts, by the table and the rules."""
    k, z = names.t, names.s
    image = exact.sequence_transform(pieces, k, z)
    single = len(pieces) == 1 and pieces[0].delay == 0 and pieces[0].impulse == 0
    at_once = single and all(len(each.pairs(k, z)) == 1 for each in pieces[0].terms)
    if pieces and not at_once:
        yield from transformed(f, pieces, names)
    claims = {"U": Claim(names.transform(pieces[0].function), image, "from the table")} if at_once else {}
    yield Step("input", claims=claims, unclaimed="" if claims else "the terms added", image=image, function=f,
               at_once=at_once, rest=rest, **names.told)  # fmt: skip


def _shifts(asked: Question) -> Step:
    """The transform of each sample that occurs, with the values at the start put in."""
    z, rows, first = asked.z, [], asked.first_of_inputs()
    for names, values, table in (
        (asked.model.unknowns, asked.start, [row.unknowns for row in asked.operators.rows]),
        (asked.model.inputs, first, [row.inputs for row in asked.operators.rows]),
    ):
        jets = {jet for each in table for jet in each if jet[1] != 0}
        for name, q in sorted(jets, key=lambda jet: (names.index(jet[0]), -jet[1])):
            is_input = name in asked.model.inputs
            apart = sp.S.Zero if asked.at_rest or (is_input and q < 0) else exact.start_of_sample((name, q), values, z)
            rows.append((asked.model.symbol((name, q)), sp.Symbol(name), capital(name), q, apart,
                         asked.at_rest or (is_input and q < 0)))  # fmt: skip
    return Step("shifts", unclaimed="the rule for shifts", rows=rows, at_rest=asked.at_rest, z=z)


def _equations(asked: Question) -> Step:
    """P(z) Y = right side, row by row."""
    operators, z = asked.operators, asked.z
    P = operators.matrix(z)
    Y = [capital(name) for name in asked.model.unknowns]
    values = {x: asked.images[name] for x, name in zip(Y, asked.model.unknowns, strict=True)}
    claims, lines = {}, []
    for i in range(P.rows):
        left = [(P[i, j], x) for j, x in enumerate(Y) if P[i, j] != 0]
        forced = [each for each in asked.forced(i).values() if each != 0]
        rest = [asked.image_of(asked.rests[i])] if asked.rests[i] else []
        given = [*forced, *rest, *([asked.started[i]] if asked.started[i] != 0 else [])]
        right: Any = total(*given) if given else sp.S.Zero
        lines.append((total(*(_scaled(p, x) if p == 1 else product(p, x) for p, x in left)), right))
        claims[f"row{i + 1}"] = Claim(total(*(product(p, values[x]) for p, x in left)), right, "transformed equation")
    return Step("equations", claims=claims, lines=lines, unknowns=list(values.items()))


def _solved(asked: Question) -> Step:
    """The transforms of the unknowns: divided by P, of several equations by Cramer's rule."""
    z, P = asked.z, asked.operators.matrix(asked.z)
    several = len(asked.model.unknowns) > 1
    _, whole, powers = asked.cleared
    cleared = sp.ImmutableMatrix(P.rows, P.cols, lambda i, j: sp.expand(z ** powers[i] * P[i, j]))
    right = sp.Matrix([z**p * r for p, r in zip(powers, _right_sides(asked), strict=True)])
    claims: dict[str, Claim] = {}
    if several:
        claims["determinant"] = Claim(determinant(cleared), whole, "the determinant")
    lines = []
    for j, name in enumerate(asked.model.unknowns):
        image = asked.images[name]
        if several:
            changed = cleared.as_mutable()
            changed[:, j] = right
            stated = quotient(determinant(sp.ImmutableMatrix(changed)), whole)
        else:
            stated = quotient(right[0], whole)
        claims[f"Y{j + 1}"] = Claim(stated, image, "solved")
        lines.append((asked.names(name).image, stated, image))
    return Step("solved", claims=claims, lines=lines, several=several, cleared=max(powers), z=z)


def _right_sides(asked: Question) -> list[Expr]:
    """The right sides of the rows, everything added."""
    return [
        sp.Add(*asked.forced(i).values(), asked.image_of(asked.rests[i]), asked.started[i])
        for i in range(len(asked.operators.rows))
    ]
