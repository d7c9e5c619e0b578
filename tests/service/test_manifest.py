"""The manifest of a service, models pinned by their digest, and looking at the stores when told to."""

import json

import msgspec
import numpy as np
import pytest

from bnserve_client import DigestUnknown, InvalidRequest, Model, ModelUnknown, ParametersWithExtrinsic
from bnserve_protocol import AnswerCorrupted, ModelLoading, RunManifest
from bnserve_service.models.registry import Registry
from tests.service.asking import ask, evaluate, question
from tests.service.chirp import ChirpModel, MemorySource, QuickChirpModel, until

OLD, NEW, NONE = (f"sha256:{letter * 64}" for letter in "abc")
FREQUENCIES, ONE = np.linspace(20.0, 100.0, 5), ParametersWithExtrinsic.gw170817()


@pytest.fixture(params=[ChirpModel, QuickChirpModel], ids=["in threads", "fast path"])
def moved(request, start):
    """A server whose label has moved from the old artifact to the new one."""
    source = MemorySource().add(request.param(version="1.0.0", digest=OLD))
    server = start(source=source)
    source.add(request.param(version="1.1.0", digest=NEW, scale=2.0))
    until(lambda: len(server.app.parts.registry.catalogue.models) == 2, "the new version is served")
    return server


def manifest(server):
    return msgspec.json.decode(ask(server.address, "GET", "/v1/manifest").body, type=RunManifest)


def test_the_manifest_says_what_the_numbers_depend_on(moved):
    told = manifest(moved)
    assert [(m.name, m.version, m.digest, m.labels) for m in told.models] == [
        ("chirp", "1.0.0", OLD, []),
        ("chirp", "1.1.0", NEW, ["stable"]),
    ]
    assert {"bnserve", "python", "numpy", "LLVM", "llvmlite", "uvicorn"} <= set(told.software)
    assert told.kernel.startswith("sha256:")
    assert told.processor.name
    assert told.processor.features == sorted(told.processor.features)
    assert told.limits["max_rows"] == 64


def test_equal_services_have_equal_manifests_and_others_have_not(moved, start):
    first = manifest(moved)
    assert first == manifest(moved) == first.sealed()
    assert manifest(start(ChirpModel(digest=OLD))).digest != first.digest


def test_a_digest_in_the_path_is_that_artifact_whatever_the_label_stands_for(moved):
    def asked(version):
        path = f"/v1/models/chirp/versions/{version}/waveforms"
        return ask(moved.address, "POST", path, json.dumps(question()), content_type="application/json")

    by_digest, by_label = asked(OLD), asked("stable")
    assert by_digest.document["model"] == {"name": "chirp", "version": "1.0.0", "digest": OLD}
    assert by_label.document["model"]["digest"] == NEW
    assert ask(moved.address, "GET", f"/v1/models/chirp/versions/{OLD}").document["version"] == "1.0.0"
    answer = asked(NONE)
    assert (answer.status, answer.code) == (404, "digest-unknown")
    assert OLD in answer.document["detail"]
    assert NEW in answer.document["detail"]


def test_a_pinned_client_gets_the_very_artifact_or_an_error(moved):
    old = ChirpModel(version="1.0.0").predict(FREQUENCIES, ONE)
    with Model.connect(moved.address, "chirp", digest=OLD) as model:
        assert (model.description.version, model.description.digest) == ("1.0.0", OLD)
        assert model.predict(FREQUENCIES, ONE).plus.tobytes() == old.plus.tobytes()
        assert any(m.digest == OLD for m in model.manifest().models)
        del moved.app.parts.maintenance._loader._source.models["chirp", "1.0.0"]
        until(lambda: len(moved.app.parts.registry.catalogue.models) == 1, "the old version is gone")
        with pytest.raises(DigestUnknown, match=NEW):
            model.predict(FREQUENCIES, ONE)
    with pytest.raises(ModelUnknown), Model.connect(moved.address, "chirp", digest=OLD):
        pass


def test_a_digest_and_a_version_that_contradict_each_other_are_refused(moved):
    with Model.connect(moved.address, "chirp", version="1.0.0", digest=OLD) as model:
        assert model.description.digest == OLD
    with (
        pytest.raises(DigestUnknown, match=r"1\.0\.0"),
        Model.connect(moved.address, "chirp", version="1.1.0", digest=OLD),
    ):
        pass
    with pytest.raises(InvalidRequest, match="64 hexadecimal"), Model.connect(moved.address, "chirp", digest="abc"):
        pass


def test_a_client_without_a_pin_stays_with_what_it_found_and_notices_other_content_under_that_version(moved):
    with Model.connect(moved.address, "chirp", version="1.0.0") as model:
        source = moved.app.parts.maintenance._loader._source
        source.models["chirp", "1.0.0"] = type(source.models["chirp", "1.0.0"])(version="1.0.0", digest=NONE, scale=3.0)
        until(lambda: ("chirp", NONE) in moved.app.parts.registry.catalogue.pins, "the version has other content")
        with pytest.raises(AnswerCorrupted, match="pinned to"):
            model.predict(FREQUENCIES, ONE)


def test_the_digest_of_another_model_is_not_taken(start):
    server = start(ChirpModel(digest=OLD), ChirpModel(name="other", digest=NEW))
    with pytest.raises(DigestUnknown), Model.connect(server.address, "chirp", digest=NEW):
        pass


def test_before_anything_is_loaded_a_digest_is_loading():
    with pytest.raises(ModelLoading):
        Registry().find("chirp", OLD)


def test_looking_at_the_stores_when_told_to(start):
    source = MemorySource().add(ChirpModel(digest=OLD))
    server = start(source=source, poll_seconds=3600.0)
    assert ask(server.address, "POST", "/v1/reload").document["changed"] is False
    source.add(ChirpModel(version="1.1.0", digest=NEW))
    source.add(ChirpModel(version="1.2.0", digest=NONE, healthy=False), label=None)
    told = ask(server.address, "POST", "/v1/reload").document
    assert [model["version"] for model in told["loaded"]] == ["1.1.0"]
    assert list(told["failures"]) == ["chirp 1.2.0"]
    assert evaluate(server.address, question()).status == 200
