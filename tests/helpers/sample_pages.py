"""Sample solutions for the tests of pages: one with everything on it, one that tries to break out."""

from __future__ import annotations

from solver.derivation import CheckStatus, Status
from solver.document.model import CheckRow, Document, Work, WorkAnswer, WorkStep

SHORT = r"\begin{bmatrix} 1 \end{bmatrix}"
TALL = r"\begin{bmatrix} 1 \\ 2 \\ 3 \\ 4 \\ 5 \\ 6 \end{bmatrix}"


def matrix(rows: int, columns: int, entry: str) -> str:
    body = r" \\ ".join(" & ".join(entry for _ in range(columns)) for _ in range(rows))
    return rf"\begin{{bmatrix}} {body} \end{{bmatrix}}"


def worded(title: str, markdown: str, *steps: WorkStep) -> WorkStep:
    return WorkStep("sample", title, markdown, steps)


STEPS = (
    worded(
        "Form the matrix $sI - A$",
        f"Subtract $A$ from $s$ times the identity.\n\n$$\nsI - A = {matrix(3, 3, 's + 1')}\n$$\n\n"
        f"A short one, $x = {SHORT}$, and a tall one:\n\n$$\nv = {TALL}\n$$",
        worded("A smaller step", "Cofactor by cofactor: $\\det(sI - A) = s^{2} + 3s + 2$."),
        worded(
            "A second one",
            "Row operation $R_{2} \\leftarrow R_{2} - 2R_{1}$:\n\n$$\n"
            r"\left[\begin{array}{cc|c} 1 & 2 & 3 \\ 4 & 5 & \end{array}\right]" + "\n$$",
        ),
    ),
    worded(
        "A wide one",
        f"It scrolls in its box:\n\n$$\n\\Phi(t) = {matrix(6, 6, '2 e^{-t} - e^{-2 t} + 3')}\n$$\n\n"
        r"And one in a line, $e^{At} = \alpha_{0}(t) I + \alpha_{1}(t) A + \alpha_{2}(t) A^{2} + \alpha_{3}(t) A^{3}$.",
    ),
)
CHECKS = (
    CheckRow(
        "3 equalities of step 1",
        "numpy.linalg.det, random points",
        r"2.5 \cdot 10^{-15}",
        "10^{-9}",
        CheckStatus.PASSED,
    ),
    CheckRow(r"$\Phi(t) = e^{At}$ at several $t$", "scipy.linalg.expm", "0.25", "10^{-9}", CheckStatus.FAILED),
    CheckRow(
        "the spectrum of $A - BK$", "numpy.linalg.eigvals", "", "", CheckStatus.SKIPPED, "it has the parameter $a$"
    ),
)


def answer(name: str, symbol: str, tex: str, doc: str) -> WorkAnswer:
    return WorkAnswer(name, symbol, tex, doc, "", f"{symbol} = {tex}")


def part(letter: str, status: Status, **changes: object) -> Work:
    values: dict[str, object] = {
        "id": letter,
        "task": "state_transition_matrix",
        "method": "laplace",
        "title": "State transition matrix",
        "method_title": "Inverse Laplace transform",
        "source": "Lecture note, section 1.13",
        "marks": "3.5",
        "question": r"Find the state transition matrix $\Phi(t) = e^{At}$ of $\dot{x} = Ax$.",
        "given": "",
        "again": False,
        "steps": STEPS,
        "answers": (answer("Phi", r"\Phi(t)", matrix(2, 2, "2 e^{-t} - e^{-2 t}"), "in `t`"),),
        "rows": CHECKS[:1],
        "status": status,
        "reason": "",
    }
    return Work(**(values | changes))  # type: ignore[arg-type]


def sample() -> Document:
    """Return a solution with a part of every status, substeps, wide matrices and all kinds of check."""
    parts = (
        part("a", Status.VERIFIED),
        part("b", Status.FAILED, rows=CHECKS, reason=r"The residual of $\Phi(t) = e^{At}$ is too large."),
        part("c", Status.UNSOLVED, method="modal", method_title="Modal matrix", answers=(), rows=(), marks="1",
             reason=r"The matrix $A$ is defective: the eigenvalue $\lambda = -1$ has one eigenvector."),
    )  # fmt: skip
    given = f"$$\nA = {matrix(2, 2, '-1')}, \\qquad B = {matrix(2, 1, '0')}\n$$"
    return Document("Sample with everything", "Lecture note, 1.16", "Let $x(0) = x_0$.", given, parts)


ATTACK = "</script></title></style><img src=x onerror=alert(1)><svg/onload=alert(1)>"


def hostile() -> Document:
    """Return a solution whose every text tries to become markup."""
    math = rf"Text {ATTACK} and $\text{{{ATTACK}}}$, $\href{{javascript:alert(1)}}{{x}}$, $\unicode{{x3c}}b$."
    link = "[a](javascript:alert(1)) ![i](https://example.org/x.png) <b onclick=alert(1)>b</b>"
    texts = math + "\n\n" + link
    bad = part(
        "a", Status.FAILED, title=ATTACK, method_title=ATTACK, source=ATTACK, marks=ATTACK, question=texts, given=texts,
        steps=(worded(ATTACK, texts, worded(ATTACK, texts)),), reason=texts,
        answers=(answer("Phi", ATTACK, rf"\text{{{ATTACK}}}", ATTACK),),
        rows=(CheckRow(texts, ATTACK, ATTACK, ATTACK, CheckStatus.SKIPPED, texts),),
    )  # fmt: skip
    return Document(ATTACK, ATTACK, texts, texts, (bad, bad))
