"""Marks answers as a learning system does that reads QTI 2.1: another reader of what is written, for tests."""

from __future__ import annotations

from dataclasses import dataclass

from tests.papers.banks.qti_schema import QTI


@dataclass(frozen=True)
class Outcome:
    """What comes of an attempt: the score, None where a person gives it, and the texts of feedback that is shown."""

    score: float | None
    feedback: tuple[str, ...]


class Attempt:
    """An item with what was typed, by the identifiers of responses; what is no number where one is wanted is NULL."""

    def __init__(self, item, typed):
        self.item, self.values, self.right = item, {}, {}
        for each in item.iter(f"{QTI}responseDeclaration"):
            name, kind = each.get("identifier"), each.get("baseType")
            self.values[name] = read(typed.get(name, ""), kind)
            right = each.find(f"{QTI}correctResponse/{QTI}value")
            self.right[name] = None if right is None else read(right.text, kind)
        for each in item.iter(f"{QTI}outcomeDeclaration"):
            default = each.find(f"{QTI}defaultValue/{QTI}value")
            many = each.get("cardinality") == "multiple"
            found = read(default.text, each.get("baseType")) if default is not None else [] if many else None
            self.values[each.get("identifier")] = found

    def processed(self):
        """Return the outcome."""
        self.run(self.item.find(f"{QTI}responseProcessing"))
        shown = []
        for each in self.item.iter(f"{QTI}modalFeedback"):
            value = self.values[each.get("outcomeIdentifier")]
            held = each.get("identifier") in value if isinstance(value, list) else each.get("identifier") == value
            if held == (each.get("showHide") == "show"):
                shown.append("".join(each.itertext()))
        return Outcome(self.values["SCORE"], tuple(shown))

    def run(self, rules):
        """Carry rules out."""
        for rule in rules:
            if rule.tag == f"{QTI}setOutcomeValue":
                self.values[rule.get("identifier")] = self.value(rule[0])
            elif rule.tag == f"{QTI}responseCondition":
                self.choose(rule)

    def choose(self, condition):
        """Carry out the first branch whose condition is true; NULL is not."""
        for branch in condition:
            if branch.tag == f"{QTI}responseElse":
                return self.run(branch)
            if self.value(branch[0]) is True:
                return self.run(branch[1:])
        return None

    def value(self, node):
        """Return the value of an expression, None for NULL."""
        name = node.tag.removeprefix(QTI)
        if name == "variable":
            return self.values[node.get("identifier")]
        if name == "correct":
            return self.right[node.get("identifier")]
        if name == "baseValue":
            return read(node.text, node.get("baseType"))
        found = [self.value(each) for each in node]
        if name == "multiple":
            return [
                each for value in found if value is not None for each in (value if isinstance(value, list) else [value])
            ]
        if name == "and":
            return False if False in found else None if None in found else True
        return None if None in found else compared(name, node, found)


def compared(name, node, found):
    """Return the value of an expression whose operands are there."""
    if name == "sum":
        return sum(found)
    one, other = found
    if name == "match":
        return one == other
    if name == "equal":
        if node.get("toleranceMode") == "exact":
            return one == other
        low, high = map(float, node.get("tolerance").split())
        return other - low <= one <= other + high
    raise AssertionError(f"{name} is not known")


def read(text, kind):
    """Return a value of a type; nothing typed is NULL."""
    if not text or not text.strip():
        return None
    if kind != "float":
        return text
    try:
        return float(text)
    except ValueError:
        return None
