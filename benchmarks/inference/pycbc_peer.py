"""The peer: PyCBC's relative binning, its ``earth_rotation`` on and off, in its own process, on the same data.

    python pycbc_peer.py FILE

In the environment of PyCBC, with bnserve's ``protocol``, ``client``, ``model_store`` and ``surrogate`` installed: its
waveforms are ours. The file is that of ``python -m benchmarks.inference.moving --pycbc``; the answer is a line of JSON,
ln L at the points of the file with the phase integrated. PyCBC takes antenna patterns and delays at the times at which
a Newtonian chirp of the fiducial masses passes the edges of its bins.
"""

from __future__ import annotations

import json
import sys
from typing import Any

import numpy as np
from pycbc.inference.models import Relative
from pycbc.types import FrequencySeries

EPSILON = 0.05
"""Of the phase across a bin: a tenth of PyCBC's default, so that what is left is the response."""


def parameters_of(row: dict[str, float]) -> dict[str, float]:
    """A sample by PyCBC's names; its times are relative to the trigger."""
    q, total = row["mass_ratio"], row["total_mass"]
    return {
        "mass1": total * q / (1.0 + q), "mass2": total / (1.0 + q), "spin1z": row["chi_1"], "spin2z": row["chi_2"],
        "lambda1": row["lambda_1"], "lambda2": row["lambda_2"], "distance": row["distance_mpc"],
        "inclination": row["inclination"], "ra": row["right_ascension"], "dec": row["declination"],
        "polarization": row["polarization_angle"], "tc": row["coalescence_time"],
    }  # fmt: skip


def log_likelihoods(file: Any, rows: list[dict[str, float]], rotation: bool) -> list[float]:
    """At all rows; the first is the fiducial signal."""
    trigger, delta_f = float(file["trigger_time"]), float(file["delta_f"])
    samples = [parameters_of(row) for row in rows]
    for sample in samples:
        sample["tc"] += trigger
    data, psds = {}, {}
    for name in file["detectors"].tolist():
        data[name] = FrequencySeries(file[f"strain_{name}"], delta_f=delta_f, epoch=float(file["start_time"]))
        psds[name] = FrequencySeries(file[f"psd_{name}"], delta_f=delta_f)
    model = Relative(
        list(samples[0]), data, {name: float(file["f_min"]) for name in data}, psds=psds,
        high_frequency_cutoff={name: float(file["f_max"]) for name in data}, fiducial_params=samples[0],
        static_params={"approximant": "bnserve", "mode_array": 22, "f_lower": float(file["f_min"]), "f_ref": 50.0},
        epsilon=EPSILON, earth_rotation=rotation, marginalize_phase=True,
    )  # fmt: skip
    found = []
    for sample in samples:
        model.update(**sample)
        found.append(float(model.loglr))
    return found


if __name__ == "__main__":
    with np.load(sys.argv[1], allow_pickle=False) as given:
        names = given["names"].tolist()
        points = [dict(zip(names, row.tolist(), strict=True)) for row in given["points"]]
        print(json.dumps({str(rotation): log_likelihoods(given, points, rotation) for rotation in (False, True)}))
