"""Who is compared: script, environment, argument, and how the figures show them."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from benchmarks.workers import ROOT

SCRIPTS = ROOT / "benchmarks" / "peers"
OWN, GREY = "bnserve", "#7a8694"


class Entry(NamedTuple):
    """One peer in one figure.

    ``environment`` is the folder below ``$PEERS`` (empty: the interpreter that runs the benchmark); ``batches`` whether
    it computes several waveforms in one call.
    """

    name: str
    script: str
    environment: str
    argument: str
    colour: str
    marker: str
    batches: bool = False

    @property
    def path(self) -> Path:
        """Of the script."""
        return SCRIPTS / self.script


def candidates(f_min: float) -> tuple[Entry, ...]:
    """The peers of the figure from 5 Hz or from 15 Hz, slowest first."""
    at, from_5 = f"{f_min:g}", f_min < 15.0
    lal = [
        Entry("LAL SEOBNRv4T_surrogate", "lal_seobnrv4t_surrogate.py", "lalsuite", at, "#8c6d31", "v"),
        Entry("LAL SEOBNRv4_ROM_NRTidalv2", "lal_seobnrv4_rom_nrtidalv2.py", "lalsuite", at, "#bd9e39", "^"),
        Entry("LAL IMRPhenomD_NRTidalv2", "lal_imrphenomd_nrtidalv2.py", "lalsuite", at, "#cc79a7", "D"),
        Entry("LAL IMRPhenomXAS_NRTidalv3", "lal_imrphenomxas_nrtidalv3.py", "lalsuite", at, "#e69f00", "P"),
        Entry("LAL TaylorF2", "lal_taylorf2.py", "lalsuite", at, "#56b4e9", "X"),
    ]
    newest = Entry("mlgw_bns 2.0.1", "mlgw_bns_2.py", "mlgw_bns-2.0.1", "serve", "#b2182b", "h", batches=True)
    model = "default" if from_5 else "fast"
    return (
        Entry("TEOBResumSPA", "teobresums_spa.py", "teobresums", at, "#1b2733", "s"),
        *((newest,) if from_5 else ()),
        Entry(f"mlgw_bns 0.12.1 {model}", "mlgw_bns_0.py", "mlgw_bns-0.12.1", model, "#d55e00", "p"),
        *lal[(2 if from_5 else 0) :],
        Entry("ripple TaylorF2", "ripple_taylorf2.py", "ripple", at, "#009e73", "d", batches=True),
        Entry(f"{OWN} {model}", "bnserve_local.py", "", model, "#0072b2", "o", batches=True),
    )
