"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.frequency.axis import Angle, OnAxis, on_axis
from solver.exact.frequency.bode_forms import BodeForm, Corner, bode_form
from solver.exact.frequency.circle import OnCircle, on_circle
from solver.exact.frequency.crossings import Crossover, GainCrossovers, gain_crossovers
from solver.exact.frequency.encirclements import Arc, Encirclements, encirclements
from solver.exact.frequency.following import phase_crossings
from solver.exact.frequency.late_gains import CriticalGain, LateGains, late_gains
from solver.exact.frequency.margins import Margins, in_decibels, margins_of, phase_margin_of
from solver.exact.frequency.parametric_crossings import (
    ParametricAxis,
    ParametricCrossing,
    parametric_axis,
    parametric_gain_crossovers,
    parametric_real_axis,
)
from solver.exact.frequency.parametric_turns import ParametricTurns, PoleArc, TurnCase, parametric_turns
from solver.exact.frequency.real_axis import PhaseCrossovers, phase_crossovers
from solver.exact.frequency.resonance import (
    Bandwidth,
    Oscillations,
    Resonance,
    Sinusoid,
    bandwidth,
    oscillations,
    phase_function,
    resonance,
)
from solver.exact.frequency.shown_factors import shown_factor
from solver.exact.frequency.turned_phase import margin_in_turn
from solver.exact.frequency.with_parameters import (
    FactorOnAxis,
    ParametricFactors,
    decided_sign,
    parametric_bode_form,
    parametric_factors,
    with_corners_in_order,
)

__all__ = [
    "Angle",
    "Arc",
    "Bandwidth",
    "BodeForm",
    "Corner",
    "CriticalGain",
    "Crossover",
    "Encirclements",
    "FactorOnAxis",
    "GainCrossovers",
    "LateGains",
    "Margins",
    "OnAxis",
    "OnCircle",
    "Oscillations",
    "ParametricAxis",
    "ParametricCrossing",
    "ParametricFactors",
    "ParametricTurns",
    "PhaseCrossovers",
    "PoleArc",
    "Resonance",
    "Sinusoid",
    "TurnCase",
    "bandwidth",
    "bode_form",
    "decided_sign",
    "encirclements",
    "gain_crossovers",
    "in_decibels",
    "late_gains",
    "margin_in_turn",
    "margins_of",
    "on_axis",
    "on_circle",
    "oscillations",
    "parametric_axis",
    "parametric_bode_form",
    "parametric_factors",
    "parametric_gain_crossovers",
    "parametric_real_axis",
    "parametric_turns",
    "phase_crossings",
    "phase_crossovers",
    "phase_function",
    "phase_margin_of",
    "resonance",
    "shown_factor",
    "with_corners_in_order",
]
