"""Print how the corpus is marked: `python -m tests.classroom.corpus [WORD in the id ...]`."""

import os
import sys
from collections import Counter, defaultdict
from collections.abc import Sequence
from itertools import groupby
from multiprocessing import Pool

from tests.classroom.corpus.cases import Submission, submissions
from tests.classroom.corpus.marking import Outcome, outcomes

TRUTHS = ("right", "follows", "wrong", "slip", "ambiguous")
SAID = ("correct", "wrong", "not judged", "refused")


def main(words: Sequence[str]) -> int:
    """Print the table and what is marked otherwise than it is; return the exit code."""
    chosen = [each for each in submissions() if all(word in each.id for word in words)]
    slips = [slip for each in chosen for slip in each.slips()]
    problems = [list(each) for _, each in groupby(chosen, lambda each: each.problem.name)]
    with Pool(min(2, os.cpu_count() or 1)) as pool:
        found = [outcome for each in pool.imap(_marked, problems) for outcome in each]
    _table(found)
    positive = [each for each in found if each.false_positive]
    negative = [each for each in found if each.false_negative]
    right = sum(each.claim.truth in ("right", "follows") for each in found)
    for title, listed in (
        ("slips in the corpus", slips),
        ("false positives", positive),
        ("of several readings or none, but marked wrong", [each for each in found if each.guessed]),
        ("false negatives", negative),
    ):
        print(f"\n{title}: {len(listed)}", *listed, sep="\n  ")
    share = 100 * len(negative) / max(1, right)
    print(f"\n{len(chosen)} submissions, {len(found)} values, {right} of them right")
    print(f"false positives {len(positive)}, false negatives {len(negative)} ({share:.1f} %)")
    return 1 if slips or positive or negative else 0


def _marked(of_a_problem: list[Submission]) -> list[Outcome]:
    return [outcome for each in of_a_problem for outcome in outcomes(each)]


def _table(found: list[Outcome]) -> None:
    counts: dict[tuple[str, str], Counter[str]] = defaultdict(Counter)
    for each in found:
        counts[each.claim.truth, each.submission.kind][each.said] += 1
        counts[each.claim.truth, "all"][each.said] += 1
    print(f"{'truth':<10} {'form or mistake':<52} {'count':>5}", *(f"{each:>10}" for each in SAID))
    for (truth, kind), said in sorted(counts.items(), key=lambda item: (TRUTHS.index(item[0][0]), item[0][1])):
        print(f"{truth:<10} {kind:<52} {sum(said.values()):>5}", *(f"{said[each]:>10}" for each in SAID))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
