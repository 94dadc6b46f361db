"""Steps, claims, answers and the registration of tasks; knows no topic."""

from solver.derivation.options import (
    Channel,
    Choice,
    Expression,
    ExpressionList,
    Flag,
    Integer,
    MatrixOf,
    Names,
    Number,
    Option,
    OptionKind,
    Poles,
    TransferFunctionOption,
)
from solver.derivation.registry import AnswerName, Derivation, Given, Method, Task, lemma
from solver.derivation.steps import Answers, Check, CheckStatus, Claim, PartResult, Status, Step, Unsolved

__all__ = [
    "AnswerName",
    "Answers",
    "Channel",
    "Check",
    "CheckStatus",
    "Choice",
    "Claim",
    "Derivation",
    "Expression",
    "ExpressionList",
    "Flag",
    "Given",
    "Integer",
    "MatrixOf",
    "Method",
    "Names",
    "Number",
    "Option",
    "OptionKind",
    "PartResult",
    "Poles",
    "Status",
    "Step",
    "Task",
    "TransferFunctionOption",
    "Unsolved",
    "lemma",
]
