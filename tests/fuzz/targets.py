"""What reads bytes that somebody else wrote: one function for each, which raises nothing that is not allowed.

``TARGETS`` is used by the tests (the corpus of what once broke, and small changes of what is right) and by the long
forms of ``python -m benchmarks.reliability decode``.
"""

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from random import Random

import numpy as np

from bnserve_client._evaluation import check_model
from bnserve_inference.fisher import Network
from bnserve_inference.fisher._nodes import nodes_of
from bnserve_protocol import (
    ArtifactError,
    BnserveError,
    InvalidRequest,
    ModelUnknown,
    UndecodableBody,
    decode_analysis,
    decode_network,
)
from bnserve_protocol.wire import (
    JSON,
    MSGPACK,
    decode_answer,
    decode_forecast_answer,
    decode_forecast_request,
    decode_likelihood_answer,
    decode_likelihood_request,
    decode_request,
)
from bnserve_service.evaluation import umbridge
from bnserve_service.evaluation.umbridge_bodies import UmBridgeGradientRequest, decode
from bnserve_service.settings import Settings
from bnserve_service.uploads.analyses import StoredAnalysis
from bnserve_service.uploads.grids import GridStore
from bnserve_store._files import decode_manifest
from bnserve_store._reading import LABELS_FILE, MANIFEST_FILE, TENSORS_FILE, read_artifact, read_labels
from tests.client.reference_model import binaries
from tests.fuzz import http_requests, likelihoods, valid
from tests.fuzz.conversation import ask
from tests.fuzz.framing_server import read_from_server
from tests.fuzz.mutations import damage, mutate_conversation, mutate_json, mutate_msgpack, mutate_safetensors
from tests.service.asking import GW170817


@dataclass(frozen=True)
class Target:
    """A reader of foreign bytes."""

    name: str
    read: Callable[[bytes], object]
    errors: tuple[type[BnserveError], ...]
    """What may come out of it."""
    seeds: Callable[[], list[bytes]]
    mutate: Callable[[bytes, Random], bytes]
    """A small change of a valid message."""

    def __call__(self, data: bytes) -> bool:
        """Read; whether it was taken. Every other error than the allowed ones comes out, and is a defect."""
        try:
            self.read(data)
        except self.errors as error:
            said = error.detail
        else:
            return True
        assert said, "an error says what is wrong"
        assert len(said) < 4096, "an error does not repeat its input"
        return False


class OneFile:
    """The root of a store of one version, whose files are in memory."""

    title = "memory"

    def __init__(self, files: dict[str, bytes]) -> None:
        self._files = files

    def folders(self, *parts: str) -> list[str]:
        """Of the one version."""
        return [] if parts else ["small"]

    def read(self, *parts: str, limit: int) -> bytes:
        """As :class:`bnserve_store._reading.LocalRoot` does, for files that are there."""
        return self._files[parts[-1]][:limit]


def read_request(data: bytes) -> None:
    """A request, twice: what the reader remembers of the first time must not make a difference."""
    first, second = decode_request(data, MSGPACK, 4096), decode_request(data, MSGPACK, 4096)
    assert first.batch.values.tobytes() == second.batch.values.tobytes()
    assert np.array_equal(first.grid, second.grid) if isinstance(first.grid, np.ndarray) else first.grid == second.grid
    assert (first.output, first.dtype, first.options) == (second.output, second.dtype, second.options)


def read_tensors(data: bytes) -> None:
    """A file of tensors beside a manifest that says of it what is so."""
    read_artifact(OneFile({MANIFEST_FILE: valid.manifest_of(data), TENSORS_FILE: data}), "small", "1.0.0")


def read_grid(data: bytes) -> None:
    """An upload under its right name."""
    GridStore(Settings(max_frequencies=2**16)).put("", hashlib.sha256(data).hexdigest(), data)


def read_umbridge(data: bytes) -> None:
    """What an UM-Bridge client asks for, of the analysis that it names or of another."""
    umbridge.address(data)
    umbridge.sample(StoredAnalysis(valid.ANALYSIS, 1), decode(data, UmBridgeGradientRequest))


def read_waveform_answer(data: bytes) -> None:
    """The body of an answer."""
    answer = decode_answer(data)
    check_model(answer.model, "http://server", valid.IDENTITY)
    assert all(isinstance(array, np.ndarray) for array in answer.arrays.values())


def read_likelihood_answer(data: bytes) -> None:
    """The body of an answer."""
    check_model(decode_likelihood_answer(data).model, "http://server", valid.IDENTITY)


def read_forecast_answer(data: bytes) -> None:
    """The body of an answer."""
    check_model(decode_forecast_answer(data).model, "http://server", valid.IDENTITY)


def read_network(data: bytes) -> None:
    """An upload, down to the nodes of its integrals."""
    nodes_of(Network.of(decode_network(data)), (2, 3))


TARGETS = {
    target.name: target
    for target in (
        Target("request", read_request, (InvalidRequest,),
               valid.waveform_requests, mutate_msgpack),
        Target("request_json", lambda data: decode_request(data, JSON, 4096), (InvalidRequest,),
               valid.waveform_requests_json, mutate_json),
        Target("likelihood", lambda data: decode_likelihood_request(data, MSGPACK, 4096), (InvalidRequest,),
               valid.likelihood_requests, mutate_msgpack),
        Target("likelihood_json", lambda data: decode_likelihood_request(data, JSON, 4096), (InvalidRequest,),
               valid.likelihood_requests_json, mutate_json),
        Target("umbridge", read_umbridge, (InvalidRequest, ModelUnknown), valid.umbridge_requests, mutate_json),
        Target("analysis", decode_analysis, (InvalidRequest,), valid.analyses, mutate_msgpack),
        Target("analysis_evaluated", likelihoods.read_evaluated, (InvalidRequest,),
               likelihoods.evaluated_seeds, likelihoods.mutate_analysis),
        Target("analysis_made", likelihoods.read_made, (BnserveError,),
               likelihoods.made_seeds, likelihoods.mutate_made),
        Target("forecast", lambda data: decode_forecast_request(data, MSGPACK, 4096), (InvalidRequest,),
               valid.forecast_requests, mutate_msgpack),
        Target("forecast_json", lambda data: decode_forecast_request(data, JSON, 4096), (InvalidRequest,),
               valid.forecast_requests_json, mutate_json),
        Target("network", read_network, (InvalidRequest,), valid.networks, mutate_msgpack),
        Target("network_json", read_network, (InvalidRequest,), valid.networks_json, mutate_json),
        Target("forecast_answer", read_forecast_answer, (BnserveError,), valid.forecast_answers, mutate_msgpack),
        Target("grid", read_grid, (InvalidRequest,), valid.grids, damage),
        Target("manifest", lambda data: decode_manifest(data, "manifest.json"), (ArtifactError,),
               valid.manifests, mutate_json),
        Target("labels", lambda data: read_labels(OneFile({LABELS_FILE: data}), "small"), (ArtifactError,),
               valid.labels, mutate_json),
        Target("tensors", read_tensors, (ArtifactError,), valid.tensors, mutate_safetensors),
        Target("waveform_answer", read_waveform_answer, (BnserveError,), valid.waveform_answers, mutate_msgpack),
        Target("likelihood_answer", read_likelihood_answer, (BnserveError,), valid.likelihood_answers, mutate_msgpack),
        Target("server", lambda data: ask(data, valid.FREQUENCIES, GW170817, binaries(5)), (BnserveError,),
               valid.conversations, mutate_conversation),
        Target("framing", read_from_server, (UndecodableBody,),
               http_requests.conversations, http_requests.mutate_requests),
    )
}  # fmt: skip
