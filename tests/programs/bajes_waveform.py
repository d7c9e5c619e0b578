"""bajes' own ``MLGW-BNS`` waveform, unmodified, with bnserve in the place of mlgw_bns.

    python tests/programs/bajes_waveform.py http://127.0.0.1:8000 waveforms.npz

``tests/programs.sh bajes`` starts the server, and lets mlgw_bns 0.12.1 write the file
(``tests/programs/mlgw_bns_waveforms.py``). The run fails where signs, phases or times are others than mlgw_bns's, where
waveforms differ from its by more than the two models do, or from bajes' post-Newtonian waveform by more than that may.
"""

import os
import sys
import time
import warnings

import numpy as np

import bnserve_client.compat

warnings.simplefilter("ignore")  # bajes names every package that it does not find
os.environ["BNSERVE_URL"] = sys.argv[1]
bnserve_client.compat.register()

from bajes.obs.gw.approx import mlgw  # noqa: E402  (after the registration, as in a user's script)
from bajes.obs.gw.waveform import Waveform  # noqa: E402
from mlgw_bns import Model, ParametersWithExtrinsic  # noqa: E402

POST_NEWTONIAN = "TaylorF2_5.5PN_7.5PNTides"
PARAMETERS = {"mtot": 2.8, "q": 1.2, "s1x": 0.0, "s1y": 0.0, "s1z": 0.02, "s2x": 0.0, "s2y": 0.0, "s2z": 0.01,
              "lambda1": 400.0, "lambda2": 600.0, "distance": 40.0, "iota": 0.5, "phi_ref": 0.3, "f_min": 20.0,
              "f_max": 1024.0, "srate": 2048.0, "seglen": 128.0, "tukey": 0.1, "lmax": 0}  # fmt: skip
MOST = {"mismatch": 1e-5, "phase at 20 Hz, rad": 0.15, "time, s": 2e-3, "amplitude": 0.02, "until merger, s": 2e-3,
        "low grid, rad": 1e-6}  # fmt: skip
"""mlgw_bns's own errors: mismatch 1e-5 (99 %), and the slope of its phase at the lowest frequency."""
MOST_OF_POST_NEWTONIAN = {"mismatch": 1e-3, "amplitude": 0.05}  # its amplitude is that of lowest order


def aligned(one: np.ndarray, other: np.ndarray, frequencies: np.ndarray) -> tuple[float, float, float]:
    """The mismatch after time and phase are aligned, the phase of ``other`` minus that of ``one`` at 20 Hz, the time.

    Weighted towards where detectors on the ground hear most.
    """
    weight = (abs(one) / (1.0 + (30.0 / frequencies) ** 4 + (frequencies / 200.0) ** 2)) ** 2
    difference = np.unwrap(np.angle(one.conj() * other))
    slope, phase = np.polyfit(frequencies, difference, 1, w=np.sqrt(weight / weight.max()))
    rest = np.exp(1j * (difference - phase - slope * frequencies))
    overlap = (weight * abs(other) / abs(one) * rest).sum().real
    norm = np.sqrt(weight.sum() * (weight * abs(other / one) ** 2).sum())
    return 1.0 - float(overlap / norm), float(difference[0]), slope / (2.0 * np.pi)


def compare_with_mlgw_bns(theirs: dict[str, np.ndarray]) -> None:
    """Every result of the module beside that of mlgw_bns; the run ends where they differ by more than the models."""
    model, grid = Model.default(), theirs["grid"]
    model.modes = [(2, 2)]  # which it has alone
    found = {name: [] for name in MOST}
    for n, row in enumerate(theirs["rows"]):
        binary = ParametersWithExtrinsic(*row.tolist())
        waveform = model.predict(grid, binary)
        assert type(waveform) is tuple
        for one, other in zip(theirs["waveforms"][n], waveform, strict=True):  # the signs of both
            apart, phase, seconds = aligned(one, other, grid)
            found["mismatch"].append(apart)
            found["phase at 20 Hz, rad"].append(phase)
            found["time, s"].append(seconds)
        amplitude, phase = model.predict_amplitude_phase(grid, binary)
        strong = grid < 500.0
        found["amplitude"].append(np.abs(amplitude / theirs["amplitude"][n] - 1.0)[strong].max())
        found["phase at 20 Hz, rad"].append((phase - theirs["phase"][n])[0])
        found["until merger, s"].append(model.time_until_merger(25.0, binary) - theirs["until_merger"][n])
        low = model.predict(theirs["low_grid"], binary)[0]
        found["low grid, rad"].append(np.angle(low[0] / theirs["low"][n][0, 0]))
    print(f"Differences from mlgw_bns, {len(theirs['rows'])} binaries:")
    for name, values in found.items():
        print(f"  {name:<22} median {np.median(np.abs(values)):.1e}, largest {np.abs(values).max():.1e}")
    too_large = [name for name, values in found.items() if not np.abs(values).max() < MOST[name]]
    if too_large:
        sys.exit(f"These differ by more than the models do: {', '.join(too_large)}.")


def compare_with_bajes(grid: np.ndarray) -> None:
    """bajes' wrapper beside a post-Newtonian waveform of its own."""
    assert mlgw.Model is Model
    ours, theirs = (Waveform(grid, PARAMETERS["srate"], PARAMETERS["seglen"], name).compute_hphc(dict(PARAMETERS))
                    for name in ("MLGW-BNS", POST_NEWTONIAN))  # fmt: skip
    for polarisation in ("plus", "cross"):
        one, other = getattr(theirs, polarisation), getattr(ours, polarisation)
        apart, _, seconds = aligned(one, other, grid)
        size = np.median(abs(other / one)[grid < 100.0])
        print(f"bajes, {polarisation}: mismatch of MLGW-BNS with {POST_NEWTONIAN} {apart:.1e}, {1e3 * seconds:.2f} ms, "
              f"amplitude {size:.4f}")  # fmt: skip
        if not (apart < MOST_OF_POST_NEWTONIAN["mismatch"] and abs(size - 1.0) < MOST_OF_POST_NEWTONIAN["amplitude"]):
            sys.exit(f"bajes' MLGW-BNS and {POST_NEWTONIAN} are not of the same binary.")
    phases = [np.angle(wave.cross[0] / wave.plus[0]) for wave in (ours, theirs)]
    if abs(phases[0] - phases[1]) > 0.01:
        sys.exit("The cross polarisation has another sign than bajes'.")


def print_times(grid: np.ndarray, of_mlgw_bns: float) -> None:
    """What one call of bajes costs: the best of 200, each of another binary."""
    best = {}
    for name in (POST_NEWTONIAN, "MLGW-BNS"):
        for place in ("server", "in this process"):
            os.environ.pop("BNSERVE_URL", None)
            if place == "server":
                os.environ["BNSERVE_URL"] = sys.argv[1]
            wave = Waveform(grid, PARAMETERS["srate"], PARAMETERS["seglen"], name)
            best[name, place] = np.inf
            for n in range(200):
                started = time.perf_counter()
                wave.wave_func(grid, PARAMETERS | {"lambda1": 400.0 + n})
                best[name, place] = min(best[name, place], time.perf_counter() - started)
    print(f"One waveform on {len(grid)} frequencies:")
    print(f"  mlgw_bns itself                          {1e3 * of_mlgw_bns:7.3f} ms")
    print(f"  bajes {POST_NEWTONIAN:<34} {1e3 * best[POST_NEWTONIAN, 'server']:7.3f} ms")
    for place in ("server", "in this process"):
        print(f"  bajes MLGW-BNS by bnserve, {place:<13} {1e3 * best['MLGW-BNS', place]:7.3f} ms")


def main() -> None:
    """Compare, and print the times."""
    theirs = dict(np.load(sys.argv[2]))
    compare_with_mlgw_bns(theirs)
    compare_with_bajes(theirs["grid"])
    print_times(theirs["grid"], float(theirs["seconds"]))


if __name__ == "__main__":
    main()
