"""From the name in a configuration to a generator."""

from __future__ import annotations

import difflib
import inspect
from collections.abc import Callable
from types import MappingProxyType
from typing import Any

from bnserve_protocol import BnserveError
from bnserve_surrogate.training.data.generators._callable import CallableGenerator
from bnserve_surrogate.training.data.generators._interface import WaveformGenerator
from bnserve_surrogate.training.data.generators._lalsimulation import LALSimulationGenerator
from bnserve_surrogate.training.data.generators._teobresums import TEOBResumSPA
from bnserve_surrogate.training.errors import GeneratorUnknown

GENERATORS: MappingProxyType[str, Callable[..., WaveformGenerator]] = MappingProxyType(
    {
        "teobresums": TEOBResumSPA,
        "lalsimulation": LALSimulationGenerator,
        "callable": CallableGenerator.from_path,
    }
)
"""Constructors by configuration name. Options: ``teobresums`` (postadiabatic_dr, gravitomagnetic_tides),
``lalsimulation`` (approximant, total_mass), ``callable`` (path = "module:function", release)."""


def make_generator(name: str, **options: Any) -> WaveformGenerator:
    """Construct the generator called ``name`` with its options.

    Raises
    ------
    GeneratorUnknown
        No such generator (the nearest name is suggested), an option that it does not take, or a value that does not go.
    """
    if name not in GENERATORS:
        near = difflib.get_close_matches(name, GENERATORS, n=1)
        hint = f"Did you mean '{near[0]}'?" if near else f"Known: {', '.join(GENERATORS)}."
        raise GeneratorUnknown(f"Unknown waveform generator '{name}'. {hint}")
    constructor = GENERATORS[name]
    signature = inspect.signature(constructor)
    try:
        signature.bind(**options)
    except TypeError as error:
        known = ", ".join(signature.parameters)
        raise GeneratorUnknown(f"Options of the generator '{name}': {error}. It takes: {known}.") from error
    try:
        return constructor(**options)
    except BnserveError:
        raise
    except Exception as error:  # of options of a wrong type, or of a user's own class
        raise GeneratorUnknown(f"The generator '{name}' cannot be made with {options}: {error}.") from error
