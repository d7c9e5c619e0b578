"""The numbers that the service's pages draw beside waveforms: noise curves, and terms of the post-Newtonian baseline.

    python docs/explorer_data.py          # writes service/bnserve_service/pages/data; a test says when that is needed

A server has neither bilby's tables nor numba, which the baseline's module is made with, and browsers have no Python.
"""

from __future__ import annotations

import json
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np

from bnserve_protocol import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS
from bnserve_surrogate.baseline import FREEZING_END, FREEZING_START, FROZEN_AMPLITUDE, _phase_terms

DATA = Path(__file__).parents[1] / "service" / "bnserve_service" / "pages" / "data"
CURVES = {
    "aligo": ("Advanced LIGO", "aLIGO_ZERO_DET_high_P_psd.txt", "design, zero detuning, high power: LIGO-T0900288"),
    "et": ("Einstein Telescope", "ET_D_psd.txt", "configuration D, one detector: Hild et al. 2011, arXiv:1012.0908"),
    "ce": ("Cosmic Explorer", "CE_psd.txt", "40 km: LIGO-P1600143"),
}
"""Name, file of bilby's tables (MIT licence, surrogate/bnserve_surrogate/data/LICENSE.bilby), origin."""
POINTS = 320
"""Of each curve: drawn, they are the table; SNRs with them are those of the table to 0.3 %."""
LOWEST, HIGHEST = 1.0, 8192.0
"""Hz."""


def noise_curves() -> dict[str, Any]:
    """Amplitude spectral densities in 1/sqrt(Hz), at frequencies that are evenly spaced in their logarithm."""
    curves = []
    for key, (name, table, source) in CURVES.items():
        frequencies, density = np.loadtxt(str(files("bilby.gw.detector") / "noise_curves" / table), unpack=True)
        chosen = np.geomspace(max(LOWEST, frequencies[0]), min(HIGHEST, frequencies[-1]), POINTS)
        asd = np.exp(0.5 * np.interp(np.log(chosen), np.log(frequencies), np.log(density)))
        curves.append({"key": key, "name": name, "source": source, "frequencies": _digits(chosen), "asd": _digits(asd)})
    return {"source": "tables of bilby, MIT licence", "curves": curves}


def baseline_terms() -> dict[str, Any]:
    """The point-mass terms of the baseline's phase, and the constants that belong to it."""
    names = [name for name in vars(_phase_terms) if name.startswith("PHASE_")]
    return {
        "source": "bnserve_surrogate.baseline",
        "solar_mass_seconds": SOLAR_MASS_SECONDS,
        "megaparsec_seconds": MEGAPARSEC_SECONDS,
        "freezing": [FREEZING_START, FREEZING_END, FROZEN_AMPLITUDE],
        "terms": {name: getattr(_phase_terms, name) for name in names},
    }


def documents() -> dict[Path, str]:
    """Every file and what is to stand in it."""
    return {DATA / "noise.json": _text(noise_curves()), DATA / "baseline.json": _text(baseline_terms())}


def _text(document: dict[str, Any]) -> str:
    return json.dumps(document, separators=(",", ":")) + "\n"


def _digits(values: np.ndarray) -> list[float]:
    return [float(f"{value:.5g}") for value in values]


if __name__ == "__main__":
    for path, text in documents().items():
        path.write_text(text, encoding="utf-8")
        print(f"{path.name}: {len(text):,} bytes")
