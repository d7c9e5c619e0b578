"""A :class:`ReferenceService` that also keeps analyses: its likelihood is a sum with the same bits anywhere."""

import json
import re
from dataclasses import dataclass, field

import numpy as np

from bnserve_protocol import (
    Analysis,
    AnalysisSettings,
    AnalysisUnknown,
    LikelihoodBatch,
    ModelIdentity,
    RowStatus,
    TooLarge,
    decode_analysis,
)
from bnserve_protocol.wire import MSGPACK, LikelihoodAnswer, decode_likelihood_request, encode_likelihood_answer
from tests.client.reference_service import ReferenceService

_ANALYSIS_PATH = re.compile(r"/v1/analyses/(\w+)")
_LIKELIHOOD_PATH = re.compile(r"/v1/models/default/versions/1.0.0/likelihoods/(\w+)")
SIGNAL = {
    "mass_ratio": 1.2, "lambda_1": 400.0, "lambda_2": 600.0, "chi_1": 0.01, "chi_2": 0.0, "inclination": 2.5,
    "total_mass": 2.76, "right_ascension": 3.4, "declination": -0.4, "polarization_angle": 0.3, "distance_mpc": 40.0,
    "coalescence_time": 0.01,
}  # fmt: skip


def tiny_analysis(weight=1.0, **settings) -> Analysis:
    """An analysis of one detector and few frequencies."""
    settings = AnalysisSettings(
        **{
            "kind": "full", "detectors": ("H1",), "f_min": 20.0, "f_max": 30.0, "duration": 1.0, "trigger_time": 0.0,
            "sidereal_time": 0.0, "sidereal_rate": 7e-5,
        } | settings
    )  # fmt: skip
    nodes = len(settings.grid)
    arrays = {
        "response/H1": np.eye(3), "location/H1": np.zeros(3), "linear_weights/H1": np.full((1, nodes), weight + 0j),
        "quadratic_weights/H1": np.full(nodes, weight),
    }  # fmt: skip
    return Analysis(settings=settings, arrays=arrays)


def samples(rows, seed=1) -> LikelihoodBatch:
    """Random samples."""
    random = np.random.default_rng(seed)
    return LikelihoodBatch.coerce({name: value + random.uniform(0.0, 0.1, rows) for name, value in SIGNAL.items()})


def expected(analysis, batch):
    """What the service answers: values and status."""
    batch = LikelihoodBatch.coerce(batch)
    weight = analysis.arrays["quadratic_weights/H1"][0]
    status = np.where(batch["mass_ratio"] > 3.0, RowStatus.OUT_OF_PRIOR, 0).astype(np.uint8)
    values = np.array([weight * float(np.nansum(row)) for row in batch.values])
    return np.where(status == 0, values, -np.inf), status


@dataclass
class LikelihoodReference(ReferenceService):
    analyses: dict = field(default_factory=dict)
    uploads: int = 0

    def _route(self, method, path, body):
        found = _ANALYSIS_PATH.fullmatch(path)
        if found and method == "PUT":
            return self._keep(found[1], body)
        if found:
            self._find(found[1])
            return 200, "application/json", json.dumps({"sha256": found[1]}).encode()
        found = _LIKELIHOOD_PATH.fullmatch(path)
        if found:
            return 200, MSGPACK, self._likelihoods(self._find(found[1]), body)
        return super()._route(method, path, body)

    def _keep(self, name, body):
        if len(body) > self.limits.max_analysis_bytes:
            raise TooLarge("The analysis is too large.")
        self.uploads += 1
        self.analyses[name] = decode_analysis(body)
        return 201, "application/json", json.dumps({"sha256": name}).encode()

    def _find(self, name):
        if name not in self.analyses:
            raise AnalysisUnknown("No uploaded analysis has that digest.")
        return self.analyses[name]

    def _likelihoods(self, analysis, body):
        batch = decode_likelihood_request(body).batch
        if len(batch) > self.limits.max_rows:
            raise TooLarge(f"A batch has at most {self.limits.max_rows} rows here; this one has {len(batch)}.")
        self.requests[-1] = (*self.requests[-1][:3], len(batch))
        values, status = expected(analysis, batch)
        description = self.model.description
        model = ModelIdentity(name=description.name, version=description.version, digest=description.digest)
        answer = LikelihoodAnswer(log_likelihood=values, status=status, model=model, analysis=analysis.digest)
        return b"".join(encode_likelihood_answer(answer))
