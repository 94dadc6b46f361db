"""Steps, claims, answers and the registration of tasks; knows no topic."""

from solver.derivation.answer_equations import AnswerEquations, Equation, control_law, state_equations
from solver.derivation.answer_names import AnswerName
from solver.derivation.lemmas import Derivation, MistakenDerivation, lemma
from solver.derivation.mistakes import Attempt, Slip
from solver.derivation.options import Option, OptionKind, Options, Way, option
from solver.derivation.registry import Given, Method, Refusal, Task
from solver.derivation.steps import Answers, Check, CheckStatus, Claim, PartResult, Status, Step, Unsolved
from solver.derivation.topic import Topic

__all__ = [
    "AnswerEquations",
    "AnswerName",
    "Answers",
    "Attempt",
    "Check",
    "CheckStatus",
    "Claim",
    "Derivation",
    "Equation",
    "Given",
    "Method",
    "MistakenDerivation",
    "Option",
    "OptionKind",
    "Options",
    "PartResult",
    "Refusal",
    "Slip",
    "Status",
    "Step",
    "Task",
    "Topic",
    "Unsolved",
    "Way",
    "control_law",
    "lemma",
    "option",
    "state_equations",
]
