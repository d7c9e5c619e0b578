"""How long PyCBC waits for a waveform: ours from a server (``BNSERVE_URL``) and in this process, and LAL's.

Milliseconds a call, the least of interleaved rounds of some calls each; no binary is asked for twice.
"""

import os
import time

import numpy as np
from pycbc.waveform import get_fd_waveform, get_fd_waveform_sequence

BINARY = {"mass2": 1.3, "spin1z": 0.02, "lambda1": 400.0, "lambda2": 450.0, "distance": 50.0, "f_ref": 50.0}
PEERS = {
    "server, all modes": ("bnserve", {}),
    "server, (2, 2)": ("bnserve", {"mode_array": [(2, 2)]}),
    "here, all modes": ("bnserve", {}),
    "here, (2, 2)": ("bnserve", {"mode_array": [(2, 2)]}),
    "TaylorF2": ("TaylorF2", {}),
    "IMRPhenomD_NRTidalv2": ("IMRPhenomD_NRTidalv2", {}),
    "IMRPhenomXAS_NRTidalv3": ("IMRPhenomXAS_NRTidalv3", {}),
}
"""Approximants; bnserve's from the server and in this process."""
ROUNDS, CALLS = 4, 6


def calls() -> dict[str, tuple]:
    """What is asked for, by its name in the table."""
    grids = {
        f"{seconds} s, 20 to 2048 Hz": (
            get_fd_waveform,
            {"delta_f": 1.0 / seconds, "f_lower": 20.0, "f_final": 2048.0},
        )
        for seconds in (32, 128)
    }
    points = np.geomspace(20.0, 1024.0, 200)
    return grids | {"200 sample_points": (get_fd_waveform_sequence, {"sample_points": points})}


def main() -> None:
    """Print the table."""
    address = os.environ.pop("BNSERVE_URL")
    print(f"{'ms a call':24}" + "".join(f"{peer:>24}" for peer in PEERS))
    for name, (function, grid) in calls().items():
        seconds = {peer: [] for peer in PEERS}
        for turn in range(ROUNDS):
            for peer, found in seconds.items():
                approximant, more = PEERS[peer]
                url = {"bnserve_url": address} if "server" in peer else {}
                for call in range(CALLS):
                    mass1 = 1.5 + 0.001 * (turn * CALLS + call)
                    start = time.perf_counter()
                    function(approximant=approximant, mass1=mass1, **BINARY, **grid, **more, **url)
                    found.append(time.perf_counter() - start)
        print(f"{name:24}" + "".join(f"{1e3 * min(found):24.3g}" for found in seconds.values()))


if __name__ == "__main__":
    main()
