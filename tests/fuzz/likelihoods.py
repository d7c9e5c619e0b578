"""Likelihoods of analyses that somebody made to go wrong: finite and right, or refused, or flagged; nothing else.

An analysis comes as a message (``evaluated``), or is made by ``bnserve_inference`` of what a message says (``made``).
What is taken is evaluated at samples that are themselves odd, in part.
"""

import json
from dataclasses import dataclass
from functools import cache
from random import Random
from typing import Any

import msgpack
import msgspec
import numpy as np

from bnserve_inference import (
    Detector,
    DetectorData,
    LikelihoodOptions,
    antenna_pattern,
    full_analysis,
    likelihood,
    relative_binning_analysis,
    time_delay,
)
from bnserve_inference._calibration import calibration_splines
from bnserve_protocol import (
    Analysis,
    BnserveError,
    Calibration,
    DistanceMarginalisation,
    EvaluationOptions,
    InvalidRequest,
    Likelihood,
    LikelihoodBatch,
    RowStatus,
    TimeMarginalisation,
    decode_analysis,
    encode_analysis,
    integrated_names,
    likelihood_samples,
)
from bnserve_surrogate import Model
from tests.fuzz.mutations import NUMBERS, mutate_json, mutate_msgpack
from tests.service.injections import SIGNAL, samples, small_analysis

MOST_WORK = 200_000
"""Samples of one row; a service counts what it admits in them, and here all has to be quick."""
ODD = {
    "distance_mpc": [1e-300, 0.0, np.nan, 1e300],
    "coalescence_time": [np.inf, -1e5, 0.0999, -0.1],
    "mass_ratio": [0.5, 3.0, np.nan, 1.0],
    "right_ascension": [1e6, -1e300, np.nan, 0.0],
    "total_mass": [4.0, 2.0, 100.0, 0.2, 0.0, -1.0],
}


@cache
def model() -> Model:
    """The one that all are evaluated with."""
    return Model.load("fast")


@cache
def batch_of(detectors: tuple[str, ...], nodes: int) -> LikelihoodBatch:
    """Samples around a signal, and some of odd values; with calibration errors where there are nodes."""
    good, odd = samples(6), samples(sum(map(len, ODD.values())), seed=6)
    place = 0
    for name, values in ODD.items():
        odd[name][place : place + len(values)] = values
        place += len(values)
    values = np.concatenate([good.values, odd.values])
    random = np.random.default_rng(1)
    errors: list[dict[str, Any]] = [{}, {}]
    for name in detectors if nodes else ():
        for each in errors:
            each[name] = random.normal(0.0, 0.05, (len(values), nodes))
            each[name][4, 0], each[name][5, -1] = 1e200, -1e155
    return LikelihoodBatch(values, *errors)


def check(analysis: Analysis) -> None:
    """Evaluate an analysis: a value is finite with the status OK, or -inf with another, and right on a full grid."""
    settings = analysis.settings
    if likelihood_samples(analysis) > MOST_WORK:
        return
    nodes = 0 if settings.calibration is None else settings.calibration.nodes
    batch = batch_of(settings.detectors, nodes)
    bound = likelihood(model(), analysis)
    values, status = bound.evaluate(batch)
    good = status == RowStatus.OK
    assert (np.isfinite(values) == good).all(), (values, status)
    assert (values[~good] == -np.inf).all()
    check_details(bound, batch)
    if settings.kind != "full" or settings.time_marginalisation or settings.distance_marginalisation:
        return
    if settings.moves or any(name.startswith("arms/") for name in analysis.arrays):
        return
    for row in np.flatnonzero(good):
        expected, tolerance = directly(analysis, batch.rows(slice(row, row + 1)))
        assert not abs(values[row] - expected) > tolerance, (row, values[row], expected, tolerance)


def check_details(bound: Likelihood, batch: LikelihoodBatch) -> None:
    """Evaluate products, and draws of what is integrated over: finite where the status is OK, and nowhere else."""
    products = bound.products(batch)
    good = products.status == RowStatus.OK
    assert (np.isfinite(products.d_inner_h).all(axis=1) == good).all(), products
    assert (np.isfinite(products.h_inner_h).all(axis=1) == good).all(), products
    if not integrated_names(bound.analysis.settings):
        return
    drawn = bound.draw_marginalised(batch, seed=1)
    good = drawn.status == RowStatus.OK
    for numbers in (drawn.log_likelihood, *drawn.parameters.values()):
        assert (np.isfinite(numbers) == good).all(), drawn


def directly(analysis: Analysis, row: LikelihoodBatch) -> tuple[float, float]:
    """ln L of one sample by its definition, and what rounding may make of it."""
    settings, arrays = analysis.settings, analysis.arrays
    f = settings.grid.frequencies()
    phase = {"reference_phase": 0.0} if settings.phase_marginalisation else {}
    options = EvaluationOptions(out_of_domain="flag", alignment=settings.alignment)
    found = model().predict_factored(f, row.waveform_batch(**phase), options=options)
    sidereal = settings.sidereal_time + settings.sidereal_rate * row["coalescence_time"][0]
    place = float(row["right_ascension"][0]), float(row["declination"][0])
    product, norm, size, turns = 0j, 0.0, 0.0, abs(sidereal) + abs(place[0])
    with np.errstate(all="ignore"):
        for name in settings.detectors:
            site = FreeSite(name, arrays[f"response/{name}"], arrays[f"location/{name}"])
            plus, cross = antenna_pattern(site, *place, float(row["polarization_angle"][0]), float(sidereal))
            arrival = row["coalescence_time"][0] + time_delay(site, *place, float(sidereal))
            h = found.h[0] * (plus * found.plus[0] + cross * found.cross[0])
            if name in row.calibration_amplitude:
                splines = calibration_splines(settings.calibration, f)
                a, p = row.calibration_amplitude[name][0] @ splines, row.calibration_phase[name][0] @ splines
                h = h * (1.0 + a) * (2.0 + 1j * p) / (2.0 - 1j * p)
            terms = arrays[f"linear_weights/{name}"][0] * h * np.exp(-2j * np.pi * f * arrival)
            squares = arrays[f"quadratic_weights/{name}"] * np.abs(h) ** 2
            product, norm = product + terms.sum(), norm + float(squares.sum())
            size += float(np.abs(terms).sum() + np.abs(squares).sum())
            turns += 2.0 * np.pi * float(f[-1]) * (abs(arrival) + 1.0)
        reached = abs(product) if settings.phase_marginalisation else product.real
        value = float(log_i0(reached) if settings.phase_marginalisation else reached) - 0.5 * norm
    return value, 1e-12 * (1.0 + turns) * (1.0 + size)


def log_i0(x: float) -> float:
    """ln I0, by its series or its asymptotic form."""
    return float(np.log(np.i0(x))) if x < 100.0 else x - 0.5 * np.log(2.0 * np.pi * x) + np.log1p(0.125 / x)


@dataclass(frozen=True)
class FreeSite:
    """A detector wherever an analysis says that it is."""

    name: str
    response: Any
    location: Any


def read_evaluated(data: bytes) -> None:
    """An analysis from a message, and its likelihood."""
    check(decode_analysis(data))


def read_made(data: bytes) -> None:
    """An analysis made of what a message says, and its likelihood."""
    try:
        said = msgspec.json.decode(json.dumps(json.loads(data)).replace("NaN", '"nan"').replace("Infinity", '"inf"'))
    except (ValueError, RecursionError) as error:
        raise InvalidRequest("This is no message.") from error
    if not isinstance(said, dict):
        raise InvalidRequest("This is no map.")
    check(made(_with_infinities(said)))


def _with_infinities(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _with_infinities(one) for name, one in value.items()}
    if isinstance(value, list):
        return [_with_infinities(one) for one in value]
    return float(value) if value in ("nan", "inf", "-inf") else value


def made(said: dict[str, Any]) -> Analysis:
    """The analysis that a message asks for; what it does not say is as it should be."""
    said = MAKING | said
    noise = np.random.default_rng(3).normal(size=(2, 257)) * 1e-24
    strain, asd = (noise[0] + 1j * noise[1]) * numbers(said["strain"]), np.full(257, 1e-23) * numbers(said["asd"])
    spoil(strain, said["strain_at"])
    spoil(asd, said["asd_at"])
    detector: Any = said["detector"]
    if isinstance(detector, dict):
        detector = Detector("X1", response=detector.get("response"), location=detector.get("location"))
    data = [DetectorData(one, strain, asd, said["start_time"], said["duration"]) for one in (detector, "L1")]
    integrals = {}
    for name, kind in (
        ("time_marginalisation", TimeMarginalisation),
        ("distance_marginalisation", DistanceMarginalisation),
        ("calibration", Calibration),
    ):
        integrals[name] = None if said[name] is None else of_struct(kind, said[name])
    options = LikelihoodOptions(
        prior=said["prior"], phase_marginalisation=bool(said["phase_marginalisation"]), response=said["response"],
        **integrals,
    )  # fmt: skip
    common = {"trigger_time": said["trigger_time"], "f_min": said["f_min"], "f_max": said["f_max"], "options": options}
    if said["kind"] == "full":
        return full_analysis(data, **common)
    fiducial = {name: value for name, value in SIGNAL.items() if name in MODEL_NAMES}
    return relative_binning_analysis(
        data,
        fiducial=fiducial,
        model=model(),
        phase_tolerance=said["phase_tolerance"],
        alignment="post_newtonian",
        **common,
    )


MODEL_NAMES = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "distance_mpc", "inclination", "total_mass")
MAKING: dict[str, Any] = {
    "kind": "full", "strain": 1.0, "asd": 1.0, "strain_at": [], "asd_at": [], "detector": "H1",
    "start_time": 1187008880.0, "duration": 2.0, "trigger_time": 1187008881.5, "f_min": 90.0, "f_max": 110.0,
    "phase_tolerance": 1.0, "phase_marginalisation": False,
    "prior": {
        "coalescence_time": [-0.05, 0.05], "chirp_mass": [1.1953, 1.1955], "mass_ratio": [1.15, 1.25],
        "lambda_1": [350, 450], "lambda_2": [550, 650], "chi_1": [0.0, 0.02], "chi_2": [-0.01, 0.01],
    },
    "time_marginalisation": None, "distance_marginalisation": None, "calibration": None, "response": "static",
}  # fmt: skip


def numbers(value: Any) -> float:
    """A factor, or a refusal of ours: arrays cannot be made of anything else."""
    if isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e308:
        return float(value)
    raise InvalidRequest("This is no factor.")


def spoil(array: Any, places: Any) -> None:
    """Put numbers where a message says, ``[[place, number], ...]``."""
    for pair in places if isinstance(places, list) else []:
        plain = isinstance(pair, list) and len(pair) == 2 and all(isinstance(one, int | float) for one in pair)
        if plain and abs(pair[0]) < len(array):
            array[int(pair[0])] = pair[1] if abs(pair[1]) < 1e308 else np.inf * np.sign(pair[1])


def of_struct(kind: Any, fields: Any) -> Any:
    """A structure of the vocabulary as a user would make it."""
    try:
        return kind(**fields)
    except TypeError as error:
        raise InvalidRequest("These are no fields.") from error


@cache
def evaluated_seeds() -> list[bytes]:
    """Messages of small analyses of every kind and integral."""
    far, times = DistanceMarginalisation(minimum=1.0, maximum=5000.0), TimeMarginalisation(minimum=-0.01, maximum=0.02)
    settings: list[dict[str, Any]] = [
        {}, {"phase_marginalisation": True}, {"calibration": Calibration(nodes=4, f_min=20.0, f_max=22.0)},
        {"distance_marginalisation": far}, {"time_marginalisation": times},
        {"time_marginalisation": times, "distance_marginalisation": far, "phase_marginalisation": True},
        {"response": "moving"},
    ]  # fmt: skip
    full = [b"".join(encode_analysis(small_analysis(model(), f_max=22.0, **each))) for each in settings]
    moving = made(MADE[0] | {"kind": "binned", "response": "moving"})
    long = Analysis(settings=moving.settings, arrays=dict(moving.arrays) | x_and_y("L1"))
    binned = [made(each | {"kind": "binned"}) for each in (MADE[0], MADE[3])]
    return [*full, *(b"".join(encode_analysis(each)) for each in (*binned, long))]


def x_and_y(name: str) -> dict[str, Any]:
    """A detector with long arms along the first axes of the Earth."""
    return {f"arms/{name}": 4e4 * np.eye(3)[:2], f"response/{name}": np.diag([0.5, -0.5, 0.0])}


MADE: list[dict[str, Any]] = [
    {}, {"phase_marginalisation": True}, {"calibration": {"nodes": 4, "f_min": 90.0, "f_max": 110.0}},
    {"time_marginalisation": {"minimum": -0.01, "maximum": 0.02}},
    {"time_marginalisation": {"minimum": -0.01, "maximum": 0.02, "step": 0.001}, "phase_marginalisation": True,
     "distance_marginalisation": {"minimum": 1.0, "maximum": 5000.0, "power": 2.0}},
    {"response": "moving"}, {"response": "auto"},
    {"asd_at": [[200, 0.0], [201, 1e300]], "strain_at": [[200, 1e300]]},
    {"detector": {"response": [[0.5, 0, 0], [0, -0.5, 0], [0, 0, 0]], "location": [0, 0, 6356752.0]}},
]  # fmt: skip


@cache
def made_seeds() -> list[bytes]:
    """What analyses may be asked for: everything is stated, so that everything can be changed."""
    binned = [MADE[0] | {"kind": "binned"}, MADE[2] | {"kind": "binned"}]  # which take longer
    binned.append({"kind": "binned", "response": "auto"})
    return [json.dumps(MAKING | each).encode() for each in [*MADE, *binned]]


HOSTILE = [float(number) for number in NUMBERS if abs(number) < 1e308] + [1e150, -1e160, 1e200, 1e-150, 3.0, -0.1]


def mutate_analysis(data: bytes, random: Random) -> bytes:
    """A change of the numbers in an analysis' arrays or, as often, one anywhere in its structure."""
    if random.randrange(2):
        return mutate_msgpack(data, random)
    tree = msgpack.unpackb(data, strict_map_key=False)
    for _ in range(random.randrange(1, 4)):
        array = tree["arrays"][random.choice(sorted(tree["arrays"]))]
        values = np.frombuffer(array[b"data"], np.float64).copy()
        action, number = random.randrange(4), random.choice(HOSTILE)
        with np.errstate(all="ignore"):
            if action == 0:
                values[random.randrange(len(values))] = number
            elif action == 1:
                values *= number
            elif action == 2:
                values[:] = number
            else:
                values[random.randrange(len(values)) :] *= -random.choice([1.0, 1e-20, 1e20, 1e60])
        array[b"data"] = values.tobytes()
    return msgpack.packb(tree)


mutate_made = mutate_json
ERRORS = (BnserveError,)
