"""Write the golden messages with today's code: ``python -m tests.protocol.golden.write DIRECTORY``."""

import argparse
from pathlib import Path

import numpy as np

from bnserve_protocol import EvaluationOptions, ModelIdentity, ParameterBatch, UniformGrid, grid_digest
from bnserve_protocol.wire import GridDigest, WaveformRequest, encode_answer, encode_request

BATCH = ParameterBatch(
    [
        [1.2, 400.0, 600.0, 0.01, 0.0, 40.0, 2.5, 2.76, 0.0, 0.0],
        [2.0, 5.0, 5000.0, -0.5, 0.5, 100.0, 0.0, 3.5, 1.0, -0.01],
    ]
)
FREQUENCIES = np.array([20.0, 20.5, 100.0, 1024.0])
MODEL = ModelIdentity(name="default", version="1.0.0", digest="sha256:" + "ab" * 32)
STATUS = np.array([0, 2], np.uint8)
STRAIN = np.array([[1.5 - 2.5j, 1e-23j, 0.0], [np.nan, np.nan, np.nan]])

REQUESTS = {
    "request_explicit.msgpack": WaveformRequest(batch=BATCH, grid=FREQUENCIES),
    "request_uniform.msgpack": WaveformRequest(
        batch=BATCH,
        grid=UniformGrid(20.0, 1024.0, 0.25),
        output="amplitude_phase",
        options=EvaluationOptions(out_of_domain="flag", below_band="error", above_band="error", alignment="merger"),
    ),
    "request_uploaded.msgpack": WaveformRequest(
        batch=BATCH, grid=GridDigest(grid_digest(FREQUENCIES)), output="polarizations", dtype="complex64"
    ),
}
ANSWERS = {
    "answer_factored.msgpack": {"h": STRAIN, "plus": np.array([0.8, 1.0]), "cross": np.array([0.8j, -1j])},
    "answer_polarizations.msgpack": {"h_plus": STRAIN.astype("<c8"), "h_cross": -1j * STRAIN.astype("<c8")},
    "answer_amplitude_phase.msgpack": {"amplitude": STRAIN.real.copy(), "phase": STRAIN.imag.copy()},
}


def messages() -> dict[str, bytes]:
    """What today's code makes of the golden messages, by file name."""
    answers = {name: arrays | {"status": STATUS} for name, arrays in ANSWERS.items()}
    return {name: encode_request(request) for name, request in REQUESTS.items()} | {
        name: b"".join(encode_answer(arrays, MODEL)) for name, arrays in answers.items()
    }


def main() -> None:
    """Write all of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("directory", type=Path)
    directory = parser.parse_args().directory
    for name, body in messages().items():
        (directory / name).write_bytes(body)


if __name__ == "__main__":
    main()
