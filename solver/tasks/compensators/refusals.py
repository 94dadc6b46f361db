"""Why there is no ultimate gain, no reaction curve or no section: what kernels find, as reasons."""

from __future__ import annotations

from typing import Any

from solver.derivation import Unsolved


def no_ultimate_gain(why: str) -> Unsolved:
    """Return why no stable loop begins to oscillate."""
    match why:
        case "never_stable":
            return Unsolved("pid_tuning/never_stable")
        case "never_oscillates":
            return Unsolved("pid_tuning/never_oscillates")
        case "at_the_origin":
            return Unsolved("pid_tuning/at_the_origin")
    return Unsolved("pid_tuning/at_infinity")


def no_ultimate_gain_with_dead_time(why: str) -> Unsolved:
    """Return why a loop with a dead time does not begin to oscillate."""
    if why == "unstable":
        return Unsolved("pid_tuning/not_stable_at_first")
    return Unsolved("pid_tuning/never_oscillates")


def no_reaction_curve(why: str) -> Unsolved:
    """Return why the step response has no tangent that the rules are about."""
    match why:
        case "unstable":
            return Unsolved("pid_tuning/unstable")
        case "overshoots":
            return Unsolved("pid_tuning/overshoots")
        case "steepest_at_first":
            return Unsolved("pid_tuning/steepest_at_first")
        case "no_dead_time":
            return Unsolved("pid_tuning/no_dead_time")
    return Unsolved("pid_tuning/constant")


def no_lead(why: str, **values: Any) -> Unsolved:
    """Return why no lead section has the crossover."""
    match why:
        case "amplifies":
            return Unsolved("compensators/lead_amplifies", **values)
        case "too_much":
            return Unsolved("compensators/lead_too_much", **values)
        case "ninety":
            return Unsolved("compensators/lead_ninety", **values)
    return Unsolved("compensators/lead_too_little", **values)


def no_lag(why: str, **values: Any) -> Unsolved:
    """Return why no lag section has the crossover."""
    if why == "amplifies":
        return Unsolved("compensators/lag_amplifies", **values)
    return Unsolved("compensators/lag_phase", **values)


def not_both(why: str, **values: Any) -> Unsolved:
    """Return why no pair of sections has the margin."""
    match why:
        case "phase":
            return Unsolved("compensators/both_phase", **values)
        case "lag_not_needed":
            return Unsolved("compensators/both_lag_not_needed", **values)
    return Unsolved("compensators/both_lead_not_needed", **values)


def no_lead_on_locus(why: str, **values: Any) -> Unsolved:
    """Return why no lead section makes the point a pole."""
    match why:
        case "not_needed":
            return Unsolved("compensators/locus_not_needed", **values)
        case "backwards":
            return Unsolved("compensators/locus_backwards", **values)
    return Unsolved("compensators/locus_too_much", **values)
