"""GWFish's Fisher errors with bnserve's waveform beside those with LAL's IMRPhenomD_NRTidalv2.

    PYTHONPATH=path/of/GWFish python tests/programs/gwfish_fisher.py http://127.0.0.1:8000

``tests/programs.sh gwfish`` starts the server. The run fails where comparable errors differ by more than a few per
cent, where signs are others, or where waveforms that were asked for together have other bits than alone.
"""

import logging
import os
import sys
import time
import warnings

import numpy as np
import pandas as pd

os.environ["BNSERVE_URL"] = sys.argv[1]
warnings.simplefilter("ignore")  # numpy's, on GWFish's behalf
logging.disable(logging.WARNING)

from GWFish.modules import detection, fishermatrix, waveforms  # noqa: E402  (after the warnings)

from bnserve_client import Model, OutOfDomain  # noqa: E402
from bnserve_client._chosen import chosen_model  # noqa: E402
from bnserve_client.gwfish import Waveform  # noqa: E402
from bnserve_client.gwfish._neighbours import Neighbours, _kept  # noqa: E402

LAL = "IMRPhenomD_NRTidalv2"
BINARY = {
    "chirp_mass": 1.2, "mass_ratio": 0.8, "luminosity_distance": 100.0, "theta_jn": 0.8, "ra": 2.0, "dec": 0.4,
    "psi": 1.0, "phase": 0.6, "geocent_time": 1187008882.0, "a_1": 0.03, "a_2": 0.02, "lambda_1": 400.0,
    "lambda_2": 600.0,
}  # fmt: skip
COMPARED = [name for name in BINARY if name not in ("a_2", "lambda_2")]
"""Of all 13 the errors of spins and tides are decided by small terms, in which models differ: LAL's has one tide."""
SPINNING = {"a_1": 0.3, "tilt_1": 1.2, "phi_12": 0.7, "a_2": 0.2, "tilt_2": 0.6, "phi_jl": 2.0}
MOST_APART = {"lambda_1": 0.2}
"""Of an error; 5 % of the others. (The tides of IMRPhenomXAS_NRTidalv3 and of TaylorF2 differ by as much.)"""


class Quadrupole(Waveform):
    """What LAL's has: (2, 2) alone."""

    modes = ((2, 2),)


CLASSES = {f"LAL's {LAL}": (LAL, waveforms.LALFD_Waveform), "bnserve, server": ("default", Quadrupole)}


def errors(network, binaries: pd.DataFrame, model: str, kind: type, names: list[str]) -> tuple[np.ndarray, np.ndarray]:
    """Signal-to-noise ratios and one-sigma errors, as users ask for them."""
    _, snr, found, _ = fishermatrix.compute_network_errors(
        network, binaries, fisher_parameters=list(names), waveform_model=model, waveform_class=kind
    )
    return snr, found


def compare_errors(network) -> None:
    """Both waveforms' errors of one binary, with and without spin and tide."""
    binaries = pd.DataFrame({name: [value] for name, value in BINARY.items()})
    for names in (COMPARED[:-2], COMPARED):
        (snr, theirs), (ours_snr, ours) = (errors(network, binaries, *chosen, names) for chosen in CLASSES.values())
        print(f"{len(names)} parameters: signal-to-noise ratio {snr[0]:.2f} with LAL, {ours_snr[0]:.2f} with bnserve")
        for name, one, other in zip(names, theirs[0], ours[0], strict=True):
            print(f"  {name:<20} {one:.4e}  {other:.4e}  {100 * (other / one - 1):+6.2f} %")
            most = MOST_APART.get(name, 0.05)
            if not abs(other / one - 1.0) < most:
                sys.exit(f"The errors of {name} differ by more than {100 * most:.0f} %.")
        if not abs(ours_snr[0] / snr[0] - 1.0) < 0.01:
            sys.exit("The signal-to-noise ratios differ.")


def compare_waveforms(grid: np.ndarray) -> None:
    """Signs of both polarisations, and where phase and time are zero."""
    data = {"frequencyvector": grid, "f_ref": 50.0}
    still = BINARY | {"geocent_time": 0.0}
    theirs, ours = (kind(model, still, data)() for model, kind in CLASSES.values())
    band = (np.squeeze(grid) > 10.0) & (np.squeeze(grid) < 500.0)
    for column, name in enumerate(("plus", "cross")):
        turn = (ours[:, column] / theirs[:, column])[band]
        phase = np.unwrap(np.angle(turn))
        slope = np.polyfit(np.squeeze(grid)[band], phase, 1)[0] / (2.0 * np.pi)
        print(f"{name}: amplitude {np.median(abs(turn)):.4f}, {1e3 * slope:.2f} ms, {phase[0]:.2f} rad apart")
        if not (abs(np.median(abs(turn)) - 1.0) < 0.02 and abs(slope) < 0.01 and np.ptp(phase) < 30.0):
            sys.exit("The waveforms are not of the same binary.")
    if abs(np.angle(ours[0, 1] / ours[0, 0] * theirs[0, 0] / theirs[0, 1])) > 1e-6:
        sys.exit("The cross polarisation has another sign than LAL's.")


def compare_forms(grid: np.ndarray) -> None:
    """One binary in GWFish's different ways, and what is refused."""
    data = {"frequencyvector": grid, "f_ref": 50.0}
    first = Waveform("default", BINARY, data)
    binary = {name: first.gw_params[name] for name in BINARY if name not in ("chirp_mass", "mass_ratio")}
    m1, m2 = first.gw_params["mass_1"], first.gw_params["mass_2"]
    exchanged = {"mass_1": m2, "mass_2": m1, "a_1": binary["a_2"], "a_2": binary["a_1"],
                 "lambda_1": binary["lambda_2"], "lambda_2": binary["lambda_1"]}  # fmt: skip
    forms = {
        "two masses": binary | {"mass_1": m1, "mass_2": m2},
        "the lighter star first": binary | exchanged,
        "source frame": binary | {"mass_1_source": m1 / 1.02, "mass_2_source": m2 / 1.02, "redshift": 0.02},
        "spins down": pd.Series(BINARY | {"a_1": -0.03, "tilt_1": np.pi}),
    }
    for name, form in forms.items():
        apart = np.abs(Waveform("default", form, data)() / first() - 1.0)[np.squeeze(grid) < 2000.0].max()
        if not apart < 1e-5:
            sys.exit(f"{name}: the waveform is another one, by {apart:.1e}.")
    try:
        Waveform("default", BINARY | {"lambda_1": -1.0}, data)()
    except OutOfDomain as found:
        print(f"A tide of -1: {found}")
    else:
        sys.exit("A tide of -1 is not refused.")


def compare_precession(grid: np.ndarray) -> None:
    """Spins in the orbital plane: both polarisations and their phase at the reference frequency, beside LAL's; and a
    Fisher matrix with their angles."""
    data = {"frequencyvector": grid, "f_ref": 50.0}
    binary = BINARY | {"geocent_time": 0.0} | SPINNING
    theirs, ours = (
        kind(model, binary, data)()
        for model, kind in (("IMRPhenomXP_NRTidalv2", waveforms.LALFD_Waveform), ("default", Quadrupole))
    )
    there = int(np.argmin(np.abs(np.squeeze(grid) - 50.0)))
    ratio = ours[there] / theirs[there]
    print(f"Spins in the orbital plane: at 50 Hz {abs(ratio)} times LAL's IMRPhenomXP_NRTidalv2, {np.angle(ratio)} rad")
    if not (np.abs(abs(ratio) - 1.0).max() < 1e-3 and np.abs(np.angle(ratio)).max() < 1e-3):
        sys.exit("Spins in the orbital plane are others than LAL's.")
    frame = pd.DataFrame({name: [value] for name, value in (BINARY | SPINNING).items()})
    _, found = errors(detection.Network(["ET"]), frame, "default", Quadrupole, ["chirp_mass", "tilt_1", "phi_jl"])
    print(f"Errors of chirp_mass, tilt_1 and phi_jl: {found[0]}")
    if not (np.isfinite(found).all() and (found > 0.0).all()):
        sys.exit("A Fisher matrix of a binary that precesses has no errors.")


def compare_bits(network) -> None:
    """What is asked for in a batch, and how often; then the same one by one."""
    asked = []
    original = Neighbours._ask
    Neighbours._ask = lambda self, binaries, options: asked.append(len(binaries)) or original(self, binaries, options)
    _kept.cache_clear()
    errors(network, pd.DataFrame({name: [value] for name, value in BINARY.items()}), *CLASSES["bnserve, server"],
           list(BINARY))  # fmt: skip
    together = _kept(chosen_model(name="default"), Quadrupole.modes, 50.0)[0]
    print(f"A Fisher matrix of 13 parameters asks for {len(asked)} batches, of {asked} waveforms")
    if asked != [1, 12]:
        sys.exit("Waveforms were asked for one by one.")
    for binary, strain in together._known.items():
        alone = Neighbours(Model.connect(sys.argv[1], "default"), Quadrupole.modes, 50.0, together.frequencies)
        alone._evaluate([binary])
        assert np.array_equal(alone._known[binary], strain)
    Neighbours._ask = original
    print(f"{len(together._known)} waveforms have the bits that each has alone")


def print_times(network, count: int = 5) -> None:
    """CPU of this process and wall time of a Fisher matrix: the least of a few, each of another binary."""
    table = {name: [np.inf, np.inf] for name in (*CLASSES, *MORE)}
    for n in range(count):
        binaries = pd.DataFrame({name: [value] for name, value in (BINARY | {"lambda_1": 400.0 + n}).items()})
        for name in table:
            model, kind = (CLASSES | MORE)[name]
            os.environ.pop("BNSERVE_URL", None)
            if "server" in name:
                os.environ["BNSERVE_URL"] = sys.argv[1]
            _kept.cache_clear()
            cpu, wall = time.process_time(), time.perf_counter()
            errors(network, binaries, model, kind, list(BINARY))
            spent = time.process_time() - cpu, time.perf_counter() - wall
            table[name] = [min(pair) for pair in zip(table[name], spent, strict=True)]
    print("One Fisher matrix, 13 parameters, ET: CPU of this process, and wall time")
    for name, (cpu, wall) in table.items():
        print(f"  {name:<28} {cpu:7.3f} s {wall:7.3f} s")


class Nothing(waveforms.Waveform):
    """A waveform that costs nothing: what GWFish itself takes."""

    def calculate_frequency_domain_strain(self) -> None:
        """Not physical; each parameter has a derivative."""
        names = ("mass_1", "theta_jn", "a_1", "a_2", "lambda_1", "lambda_2")
        phase = sum(self.gw_params[name] for name in names) + self.gw_params["mass_2"] ** 2
        shape = 1e-24 * np.exp(1e-3j * phase * self.frequencyvector)
        self._frequency_domain_strain = np.stack((shape, 1j * shape), axis=1)


MORE = {
    "bnserve, in this process": ("default", Quadrupole),
    "bnserve, server, all modes": ("default", Waveform),
    "GWFish without a waveform": ("default", Nothing),
}


def main() -> None:
    """Compare, and print the times."""
    network = detection.Network(["ET"])
    grid = network.detectors[0].frequencyvector
    compare_waveforms(grid)
    compare_forms(grid)
    compare_precession(grid)
    compare_errors(network)
    compare_bits(network)
    print_times(network)


if __name__ == "__main__":
    main()
