"""Print how the corpus is marked: `python -m tests.classroom.corpus [WORD in the id ...]`."""

import sys
from collections import Counter, defaultdict

from tests.classroom.corpus.cases import submissions
from tests.classroom.corpus.marking import Outcome, outcomes

TRUTHS = ("right", "follows", "wrong", "slip", "ambiguous")


def main(words: list[str]) -> int:
    """Print the table and what is marked otherwise than it is; return the exit code."""
    chosen = [each for each in submissions() if all(word in each.id for word in words)]
    slips = [slip for each in chosen for slip in each.slips()]
    found = [outcome for each in chosen for outcome in outcomes(each)]
    _table(found)
    positive = [each for each in found if each.false_positive]
    negative = [each for each in found if each.false_negative]
    right = sum(each.claim.truth in ("right", "follows") for each in found)
    for title, listed in (
        ("slips in the corpus", slips),
        ("false positives", positive),
        ("ambiguous, but marked wrong", [each for each in found if each.guessed]),
        ("false negatives", negative),
    ):
        print(f"\n{title}: {len(listed)}", *listed, sep="\n  ")
    print(f"\n{len(chosen)} submissions, {len(found)} values: {len(positive)} false positives, ", end="")
    print(f"{len(negative)} false negatives of {right} right ({100 * len(negative) / max(1, right):.1f} %)")
    return 1 if slips or positive or negative else 0


def _table(found: list[Outcome]) -> None:
    counts: dict[tuple[str, str], Counter[str]] = defaultdict(Counter)
    for each in found:
        counts[each.claim.truth, each.submission.kind][each.said] += 1
    print(f"{'truth':<10} {'form or mistake':<44} {'count':>5} {'correct':>8} {'wrong':>6} {'not judged':>11} {'refused':>8}")
    for (truth, kind), said in sorted(counts.items(), key=lambda item: (TRUTHS.index(item[0][0]), item[0][1])):
        numbers = [said[each] for each in ("correct", "wrong", "not judged", "refused")]
        print(f"{truth:<10} {kind:<44} {sum(numbers):>5} {numbers[0]:>8} {numbers[1]:>6} {numbers[2]:>11} {numbers[3]:>8}")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
