"""What ``bnserve demo`` does, from the start of the server to its end."""

from __future__ import annotations

import platform
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

import numpy as np

from bnserve_client import Model as RemoteModel
from bnserve_protocol import InvalidRequest, ParameterBatch, ParametersWithExtrinsic, UniformGrid, WaveformModel
from bnserve_service._version import __version__
from bnserve_service.demo.binaries import like_gw170817
from bnserve_service.demo.chirp import evaluate_chirp
from bnserve_service.demo.measuring import identical_numbers, medians
from bnserve_service.demo.picture import check_output, save_picture
from bnserve_service.demo.report import Report
from bnserve_service.demo.server_process import ServerProcess
from bnserve_service.process.system import available_cpus
from bnserve_surrogate import Model as LocalModel

MOST_BINARIES = 1024
"""Local and remote answers on the uniform grid are compared in memory: half a gigabyte."""
SPARSE = np.geomspace(20.0, 2048.0, 277)
"""Hz; as many as the paper's reduced-order quadrature has nodes."""
UNIFORM = UniformGrid(f_min=20.0, f_max=2048.0, delta_f=0.25)
"""An analysis of four seconds."""
ONE = ParametersWithExtrinsic.gw170817()


def demonstrate(
    output: Path, binaries: int, say: Callable[[str], None], modes: Sequence[tuple[int, int]] | None = None
) -> bool:
    """Serve, evaluate, compare, measure, draw.

    Parameters
    ----------
    output
        The picture.
    binaries
        Size of the batch.
    say
        Gets every line of the report as soon as it is known.
    modes
        Those that the picture shows; None for all.

    Returns
    -------
    Whether every bit was the same as the local model's, and the server ended as it should.

    Raises
    ------
    InvalidRequest
        A picture that cannot be saved, or a size that is not offered.
    ServerFailed
        The server did not start.
    """
    check_output(output)
    if not 1 <= binaries <= MOST_BINARIES:
        raise InvalidRequest(f"--binaries must be between 1 and {MOST_BINARIES}; got {binaries}.")
    batch = like_gw170817(binaries)
    report = Report(say)
    report.line("bnserve", f"{__version__} on Python {platform.python_version()}, {available_cpus()} processors")
    server = ServerProcess()
    with server, RemoteModel.connect(server.address) as remote:
        report.line("server", f"{server.address}, ready after {server.seconds_to_start:.1f} s")
        local = LocalModel.default()
        report.model(remote.description)
        same = _compare(report, remote, local, batch)
        _measure(report, remote, local, batch)
        chirp = evaluate_chirp(remote, ONE, modes)
        report.chirp(chirp)
        save_picture(output, chirp, remote.description)
        report.line("picture", str(output))
    report.line("server", f"stopped by SIGTERM after {server.seconds_to_stop:.1f} s, exit code {server.exit_code}")
    return same and server.exit_code == 0


def _compare(report: Report, remote: WaveformModel, local: WaveformModel, batch: ParameterBatch) -> bool:
    """Whether the remote model gives the bits of the local one, on an explicit and on a uniform grid."""
    same = remote.description.digest == local.description.digest
    if not same:
        report.line("local model", f"ANOTHER ONE: {local.description.digest}")
    for grid, size in ((SPARSE, SPARSE.size), (UNIFORM, len(UNIFORM))):
        numbers = 2 * len(batch) * size
        identical = identical_numbers(remote.predict_batch(grid, batch), local.predict_batch(grid, batch))
        verdict = "identical to the local model's" if identical == numbers else "ARE THE LOCAL MODEL'S"
        report.line("bits", f"{identical:,} of {numbers:,} complex numbers {verdict} ({len(batch)} x {size:,})")
        same = same and identical == numbers
    return same


def _measure(report: Report, remote: WaveformModel, local: WaveformModel, batch: ParameterBatch) -> None:
    """Times of the same calls, through the client and in this process."""
    report.times_header()
    models = (remote, local)
    report.times(1, SPARSE.size, medians([partial(model.predict, SPARSE, ONE) for model in models], 200))
    for grid, size, repetitions in ((SPARSE, SPARSE.size, 20), (UNIFORM, len(UNIFORM), 5)):
        calls = [partial(model.predict_batch, grid, batch) for model in models]
        report.times(len(batch), size, medians(calls, repetitions))
