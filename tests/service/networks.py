"""Networks of detectors, and binaries to forecast, as somebody would write them who has never seen our client."""

import hashlib
import json

from tests.service.asking import JSON, ask

BINARY = {
    "mass_ratio": 1.2, "lambda_1": 400.0, "lambda_2": 600.0, "chi_1": 0.01, "chi_2": 0.0, "inclination": 0.7,
    "total_mass": 2.76, "right_ascension": 3.4, "declination": -0.4, "polarization_angle": 0.3, "distance_mpc": 40.0,
    "coalescence_time": 0.01,
}  # fmt: skip


SIXTEEN = (
    "E1",
    "E2",
    "E3",
    "ETS1",
    "ETS2",
    "ETS3",
    "ETM1",
    "ETM2",
    "ETM3",
    "ETSL",
    "ETML",
    "CE40",
    "CE20",
    "H1",
    "L1",
    "V1",
)
"""As many detectors as a network has."""


def network(names=("E1", "E2", "E3"), noise="ET-D", **changes):
    told = {"detectors": [{"name": name, "noise": noise} for name in names], "f_min": 20.0, "f_max": 1024.0}
    return told | {"trigger_time": 1187008882.4} | changes


def put(address, told, **headers):
    """Upload a network in JSON; the answer, and the digest that it has."""
    body = told if isinstance(told, bytes) else json.dumps(told).encode()
    sha256 = hashlib.sha256(body).hexdigest()
    headers.setdefault("content_type", JSON)
    return ask(address, "PUT", f"/v1/networks/{sha256}", body, **headers), sha256


def forecast(address, sha256, asked, model="default", **headers):
    path = f"/v1/models/{model}/forecasts/{sha256}"
    return ask(address, "POST", path, json.dumps(asked), content_type=JSON, **headers)
