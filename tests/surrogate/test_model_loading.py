"""Loading: what is there works and knows itself, what is wrong is said."""

import threading
from dataclasses import replace
from types import MappingProxyType

import msgspec
import numpy as np
import pytest

from bnserve_protocol import (
    ArtifactCorrupted,
    ArtifactIncomplete,
    InvalidRequest,
    ModelUnknown,
    ParameterBatch,
    ParametersWithExtrinsic,
    StoreUnknown,
    WaveformModel,
)
from bnserve_store import Artifact, ModelStore
from bnserve_surrogate import Model, SelfCheck
from bnserve_surrogate.kernel._loader import ASSEMBLY, DIGEST_PREFIX
from bnserve_surrogate.kernel.build import source_digest, sources
from tests.surrogate.conftest import random_batch

GRID = np.geomspace(5.0, 2048.0, 100)
ONE = ParametersWithExtrinsic.gw170817()


def test_the_kernel_was_compiled_from_the_sources_that_are_here():
    first_line = ASSEMBLY.read_text().splitlines()[0]
    assert first_line == DIGEST_PREFIX + source_digest(sources()), "run: python -m bnserve_surrogate.kernel.build"


@pytest.fixture(scope="module")
def store(tmp_path_factory, metadata, tensors, model):
    """A store with the synthetic model, which carries a stored answer."""
    answer = model.predict_amplitude_phase(GRID, ONE)
    check = SelfCheck(
        parameters={name: getattr(ONE, name) for name in ONE.__slots__},
        frequencies=GRID.tolist(),
        amplitude=answer.amplitude.tolist(),
        phase=answer.phase.tolist(),
    )
    root = tmp_path_factory.mktemp("store")
    whole = msgspec.structs.replace(metadata, self_check=check)
    ModelStore([root]).publish("synthetic", "1.0.0", tensors, whole.write())
    return root


@pytest.fixture
def artifact(store):
    return ModelStore([store]).load("synthetic")


def with_tensors(artifact, **changes):
    """The artifact with some tensors of its mode replaced, or removed where None is given."""
    tensors = dict(artifact.tensors)
    for name, tensor in changes.items():
        if tensor is None:
            del tensors[f"22/{name}"]
        else:
            tensors[f"22/{name}"] = np.asarray(tensor)
    return Artifact(artifact.manifest, MappingProxyType(tensors))


def with_metadata(artifact, **changes):
    manifest = msgspec.structs.replace(artifact.manifest, metadata={**artifact.manifest.metadata, **changes})
    return Artifact(manifest, artifact.tensors)


def test_a_loaded_model_is_the_published_one(store, model):
    for loaded in (
        Model.load("synthetic", store=store),
        Model.load("synthetic", "1.0.0", store=str(store)),
        Model.load("synthetic", "stable", store=ModelStore([store])),
    ):
        assert isinstance(loaded, WaveformModel)
        assert loaded.self_check()
        batch = ParameterBatch(random_batch(5))
        np.testing.assert_array_equal(loaded.predict_batch(GRID, batch).plus, model.predict_batch(GRID, batch).plus)
        assert loaded.description.digest == ModelStore([store]).manifest("synthetic").digest


def test_the_default_model_ships_loads_and_keeps_its_promise():
    model = Model.default()
    model.warm_up()
    assert model.self_check()
    description = model.description
    assert (description.name, description.frequency_band) == ("default", (5.0, 2048.0))
    assert description.provenance["generator"]["name"] == "TEOBResumSPA"
    assert description.provenance["waveforms"] >= 8192
    assert description.accuracy["uniform"]["count"] >= 512
    mismatch = description.accuracy["uniform"]["mismatch"]
    assert mismatch["median"] <= 1e-6
    assert mismatch["99 %"] <= 2e-5
    assert mismatch["max"] <= 2e-4


@pytest.mark.parametrize(
    ("name", "version", "says"),
    [
        ("sinthetic", "stable", "Did you mean 'synthetic'?"),
        ("other", "stable", "There is no model 'other'"),
        ("synthetic", "9.9.9", "no version or label '9.9.9' (versions: 1.0.0; labels: stable)"),
        ("synthetic", "nightly", "no version or label 'nightly'"),
        ("../synthetic", "stable", "There is no model"),
    ],
)
def test_an_unknown_model_or_version_says_what_there_is(store, name, version, says):
    with pytest.raises(ModelUnknown) as raised:
        Model.load(name, version, store=store)
    assert says in raised.value.detail


def test_a_store_that_is_not_there_is_said(tmp_path):
    with pytest.raises(StoreUnknown, match="nowhere"):
        Model.load("synthetic", store=tmp_path / "nowhere")


@pytest.mark.parametrize(
    "name",
    ["amplitude_nodes", "phase_nodes", "mean", "basis", "merger_alignment", "coordinate_offset", "coordinate_scale"],
)
def test_a_missing_tensor_is_named(artifact, name):
    with pytest.raises(ArtifactIncomplete, match=rf"lacks the tensors: {name}\."):
        Model.from_artifact(with_tensors(artifact, **{name: None}))


def test_a_model_without_a_regressor_is_incomplete(artifact):
    nothing = dict.fromkeys(
        ["polynomial_exponents", "polynomial_coefficients"]
        + [f"mlp_{kind}_{layer}" for kind in ("weights", "biases") for layer in (0, 1)]
    )
    with pytest.raises(ArtifactIncomplete, match="polynomial_exponents or mlp_weights_0"):
        Model.from_artifact(with_tensors(artifact, **nothing))


MISFITS = {
    "nodes out of order": ("phase_nodes", lambda t: t[::-1].copy()),
    "nodes repeated": ("amplitude_nodes", lambda t: np.concatenate([t[:1], t[:-1]])),
    "nodes in two dimensions": ("amplitude_nodes", lambda t: t[None]),
    "a node less": ("phase_nodes", lambda t: t[:-1]),
    "nodes that end inside the band": ("phase_nodes", lambda t: t * 0.9),
    "nodes that begin inside the band": ("amplitude_nodes", lambda t: t * 1.1),
    "nodes that are not numbers": ("amplitude_nodes", lambda t: t * np.nan),
    "a negative node": ("amplitude_nodes", lambda t: t - 2.0 * t[0]),
    "a mean that is too short": ("mean", lambda t: t[1:]),
    "a basis that is too narrow": ("basis", lambda t: t[:, 1:]),
    "a basis with a row more": ("basis", lambda t: np.vstack([t, t[:1]])),
    "an empty basis": ("basis", lambda t: t[:0]),
    "a basis in one dimension": ("basis", np.ravel),
    "an alignment of other outputs": ("merger_alignment", lambda t: t[1:]),
    "an alignment of whole numbers": ("merger_alignment", lambda t: t.astype(np.int64)),
    "too few coordinates": ("coordinate_offset", lambda t: t[:4]),
    "too many coordinates": ("coordinate_scale", lambda t: np.append(t, 1.0)),
    "exponents of four coordinates": ("polynomial_exponents", lambda t: t[:, :4]),
    "exponents that are not integers": ("polynomial_exponents", lambda t: t.astype(float)),
    "negative exponents": ("polynomial_exponents", lambda t: t.astype(np.int64) - 1),
    "a degree beyond the kernel's": ("polynomial_exponents", lambda t: t + np.uint8(200)),
    "coefficients of other terms": ("polynomial_coefficients", lambda t: t[1:]),
    "no coefficients": ("polynomial_coefficients", lambda t: None),
    "a layer of other inputs": ("mlp_weights_0", lambda t: t[1:]),
    "a layer that does not follow": ("mlp_weights_1", lambda t: t[1:]),
    "a layer without biases": ("mlp_biases_1", lambda t: None),
    "biases of another layer": ("mlp_biases_0", lambda t: t[1:]),
    "a network that ends early": ("mlp_weights_1", lambda t: None),
    "a layer too wide for the kernel": ("mlp_weights_0", lambda t: np.zeros((5, 5000))),
}


@pytest.mark.parametrize(("name", "spoil"), MISFITS.values(), ids=list(MISFITS))
def test_tensors_that_do_not_fit_together_are_refused(artifact, name, spoil):
    spoilt = with_tensors(artifact, **{name: spoil(artifact.tensors[f"22/{name}"])})
    with pytest.raises(ArtifactCorrupted, match=r"Tensor 22/.* does not fit the others; publish the model again"):
        Model.from_artifact(spoilt)


@pytest.mark.parametrize(
    ("changes", "kind", "says"),
    [
        ({"kind": "a likelihood"}, ArtifactCorrupted, "does not describe a waveform surrogate"),
        ({"modes": {}}, ArtifactCorrupted, "modes"),
        ({"modes": {"55": {"coordinates": "physical"}}}, ArtifactCorrupted, "not among those implemented"),
        ({"modes": {"33": {"relative_to": "22", "ratio_power": 1}}}, ArtifactIncomplete, r"no \(2, 2\)"),
        ({"modes": {"22": {"relative_to": "22", "ratio_power": 1}}}, ArtifactCorrupted, "relative to the baseline"),
        (
            {"modes": {"22": {"coordinates": "physical"}, "33": {"coordinates": "physical"}}},
            ArtifactCorrupted,
            "its other modes to the",
        ),
        ({"modes": {"22": {"coordinates": "polar"}}}, ArtifactCorrupted, "polar"),
        ({"modes": {"22": {"coordinates": "physical", "baseline": "other"}}}, ArtifactCorrupted, "other"),
        ({"reference_mass": None}, ArtifactCorrupted, "reference_mass"),
        ({"total_mass": [2.0]}, ArtifactCorrupted, "total_mass"),
        ({"colour": "blue"}, ArtifactCorrupted, "colour"),
    ],
    ids=str,
)
def test_metadata_that_cannot_be_understood_is_refused(artifact, changes, kind, says):
    with pytest.raises(kind, match=says):
        Model.from_artifact(with_metadata(artifact, **changes))


def test_metadata_of_something_else_is_refused(artifact):
    manifest = msgspec.structs.replace(artifact.manifest, metadata={})
    with pytest.raises(ArtifactCorrupted):
        Model.from_artifact(Artifact(manifest, artifact.tensors))


@pytest.mark.parametrize(
    "name", ["mean", "basis", "polynomial_coefficients", "mlp_weights_0", "mlp_biases_1", "coordinate_scale"]
)
def test_the_self_check_finds_a_changed_weight(artifact, name):
    assert Model.from_artifact(artifact).self_check()
    changed = np.array(artifact.tensors[f"22/{name}"])
    changed.flat[0] += 1e-3
    assert not Model.from_artifact(with_tensors(artifact, **{name: changed})).self_check()


def test_the_self_check_finds_a_weight_that_is_not_a_number(artifact):
    changed = np.array(artifact.tensors["22/basis"])
    changed[0, 0] = np.nan
    for spoilt in (
        with_tensors(artifact, basis=changed),
        with_metadata(with_tensors(artifact, basis=changed), self_check=None),
    ):
        assert not Model.from_artifact(spoilt).self_check()


def test_many_threads_share_one_model_and_its_grids(model):
    """More grids than are kept, and every answer is that of one thread."""
    grids = [np.geomspace(10.0 + number, 1000.0, 50 + number) for number in range(20)]
    batches = [ParameterBatch(random_batch(4, seed=number)) for number in range(20)]
    expected = [model.predict_batch(grid, batch).plus for grid, batch in zip(grids, batches, strict=True)]
    wrong = []

    def work(first):
        for number in [(first + step) % 20 for step in range(60)]:
            if not np.array_equal(model.predict_batch(grids[number], batches[number]).plus, expected[number]):
                wrong.append(number)

    threads = [threading.Thread(target=work, args=(3 * number,)) for number in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == []


def test_a_model_does_not_remember_the_row_before(model):
    other = replace(ONE, mass_ratio=2.9, total_mass=3.9)
    before = model.predict(GRID, ONE).plus
    model.predict(GRID, other)
    np.testing.assert_array_equal(model.predict(GRID, ONE).plus, before)


@pytest.mark.parametrize("threads", [1, np.int64(2), np.array(2), np.uint8(3)], ids=repr)
def test_the_number_of_threads_is_any_whole_number(threads):
    f, batch = np.geomspace(20.0, 2000.0, 5000), ParameterBatch(random_batch(64))
    here, there = (Model.load("fast", threads=count).predict_batch(f, batch) for count in (1, threads))
    np.testing.assert_array_equal(here.plus, there.plus)


@pytest.mark.parametrize("threads", [0, -1, 2.0, "2", None, np.float64(2.0)], ids=repr)
def test_a_number_of_threads_that_is_none_is_refused(threads):
    with pytest.raises(InvalidRequest, match="'threads' must be a whole number of at least 1"):
        Model.load("fast", threads=threads)


@pytest.mark.parametrize("digest", [3, b"sha256:", "sha256:0", ""], ids=repr)
def test_a_digest_that_is_none_is_refused(digest):
    with pytest.raises(InvalidRequest, match="A model's digest is 'sha256:' and 64 hexadecimal digits"):
        Model.load("fast", digest=digest)
