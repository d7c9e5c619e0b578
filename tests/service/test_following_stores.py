"""Load new, swap, drop old; what is bad never serves and never dislodges what is good."""

import threading

import pytest

from bnserve_protocol import ArtifactCorrupted, ModelLoading, ModelUnknown, StoreUnknown
from bnserve_service.models.loading import Loader, Selection
from bnserve_service.models.registry import Registry
from tests.service.asking import ask, evaluate, question
from tests.service.chirp import ChirpModel, MemorySource, as_it_is, until


@pytest.fixture
def source():
    return MemorySource().add(ChirpModel(version="1.0.0", digest="sha256:1"))


@pytest.fixture
def registry():
    return Registry()


def loader(registry, source, *models):
    return Loader(registry, source, as_it_is, Selection(models))


def test_before_the_first_look_everything_is_loading(registry):
    with pytest.raises(ModelLoading):
        registry.find("chirp")


def test_a_model_is_warm_before_it_is_served(registry, source):
    report = loader(registry, source).refresh()
    assert [identity.version for identity in report.loaded] == ["1.0.0"]
    assert registry.find("chirp").model.warmed_up
    assert registry.find("chirp", "1.0.0") is registry.find("chirp", "stable") is registry.find("chirp")


def test_looking_again_changes_nothing(registry, source):
    following = loader(registry, source)
    following.refresh()
    before = registry.catalogue
    assert not following.refresh().changed
    assert registry.catalogue is before


def test_a_new_version_takes_over_and_the_old_one_stays_for_those_who_pinned_it(registry, source):
    following = loader(registry, source)
    following.refresh()
    old = registry.find("chirp")
    source.add(ChirpModel(version="1.1.0", digest="sha256:2"))
    report = following.refresh()
    assert [identity.version for identity in report.loaded] == ["1.1.0"]
    assert registry.find("chirp").identity.version == "1.1.0"
    assert registry.find("chirp", "1.0.0") is old


def test_a_version_removed_from_the_store_is_dropped(registry, source):
    following = loader(registry, source)
    source.add(ChirpModel(version="1.1.0", digest="sha256:2"))
    following.refresh()
    del source.models["chirp", "1.0.0"]
    assert [identity.version for identity in following.refresh().dropped] == ["1.0.0"]
    with pytest.raises(ModelUnknown, match=r"1\.1\.0"):
        registry.find("chirp", "1.0.0")


@pytest.mark.parametrize("fault", ["corrupted", "unhealthy", "crash"])
def test_a_bad_version_is_refused_with_a_reason_and_the_good_one_goes_on(registry, source, fault):
    following = loader(registry, source)
    following.refresh()
    good = registry.find("chirp")
    source.add(ChirpModel(version="2.0.0", digest="sha256:bad", healthy=fault != "unhealthy"))
    if fault != "unhealthy":
        error = ArtifactCorrupted("A digest is wrong.") if fault == "corrupted" else RuntimeError("/a/path")
        source.broken["chirp", "2.0.0"] = error
    report = following.refresh()
    assert list(report.failures) == ["chirp 2.0.0"]
    assert report.failures["chirp 2.0.0"]
    assert "/a/path" not in report.failures["chirp 2.0.0"]
    assert registry.find("chirp") is good, "the label stays where it was, although the store points elsewhere"
    with pytest.raises(ModelUnknown):
        registry.find("chirp", "2.0.0")


@pytest.mark.parametrize("published", [True, False])
def test_the_stable_version_is_served_until_the_next_one_is_although_it_was_removed(registry, source, published):
    """Whoever removes versions as soon as one of several servers has the next, or removes one that is being read."""
    following = loader(registry, source)
    following.refresh()
    good = registry.find("chirp")
    source.add(ChirpModel(version="2.0.0", digest="sha256:2"))
    source.broken["chirp", "2.0.0"] = ArtifactCorrupted("It was removed.")
    if not published:  # when the versions were listed
        source.label_table["chirp"]["stable"] = "3.0.0"
    del source.models["chirp", "1.0.0"]
    assert not following.refresh().dropped
    assert registry.find("chirp") is registry.find("chirp", "1.0.0") is good
    source.broken.clear()
    source.label_table["chirp"]["stable"] = "2.0.0"
    assert [identity.version for identity in following.refresh(force=True).dropped] == ["1.0.0"]
    assert registry.find("chirp").identity.version == "2.0.0"


def test_a_version_that_a_label_still_names_is_dropped_when_it_is_removed(registry, source):
    following = loader(registry, source)
    source.add(ChirpModel(version="1.1.0", digest="sha256:2"))
    following.refresh()
    del source.models["chirp", "1.1.0"]
    assert [identity.version for identity in following.refresh().dropped] == ["1.1.0"]
    with pytest.raises(ModelUnknown):
        registry.find("chirp")


def test_a_repaired_version_is_served_after_a_poke(registry, source):
    following = loader(registry, source)
    source.broken["chirp", "1.0.0"] = ArtifactCorrupted("A digest is wrong.")
    assert following.refresh().failures
    source.broken.clear()
    assert following.refresh().failures, "not looked at again at every poll"
    assert not following.refresh(force=True).failures
    assert registry.find("chirp").identity.version == "1.0.0"


def test_a_served_version_damaged_on_disk_goes_on_from_memory(registry, source):
    following = loader(registry, source)
    following.refresh()
    good = registry.find("chirp")
    source.models["chirp", "1.0.0"] = ChirpModel(digest="sha256:other", healthy=False)
    assert following.refresh().failures
    assert registry.find("chirp") is good


@pytest.mark.parametrize("error", [StoreUnknown("gone"), OSError(5, "Input/output error")])
def test_a_store_that_cannot_be_read_takes_nothing_away(registry, source, error):
    following = loader(registry, source)
    following.refresh()
    source.unreadable = error
    assert list(following.refresh().failures) == ["store"]
    assert registry.find("chirp").identity.version == "1.0.0"
    source.unreadable = None
    assert not following.refresh().failures


def test_a_label_may_move_back(registry, source):
    following = loader(registry, source)
    source.add(ChirpModel(version="1.1.0", digest="sha256:2"))
    following.refresh()
    source.label_table["chirp"]["stable"] = "1.0.0"
    assert following.refresh().changed
    assert registry.find("chirp").identity.version == "1.0.0"


def test_only_selected_models_are_served(registry, source):
    source.add(ChirpModel(name="fast", digest="sha256:3")).add(ChirpModel(version="1.1.0", digest="sha256:2"))
    loader(registry, source, "chirp@1.0.0").refresh()
    assert list(registry.catalogue.models) == [("chirp", "1.0.0")]
    with pytest.raises(ModelUnknown, match="Known models: chirp"):
        registry.find("fast")


def test_a_selected_model_that_is_not_there_is_reported(registry, source):
    following = loader(registry, source, "chrip")
    with pytest.raises(ModelUnknown):
        following.list_source()
    assert "chrip" in following.refresh().failures


def test_a_newly_published_model_is_served_without_a_restart(start, source):
    server = start(source=source)
    source.add(ChirpModel(version="1.1.0", digest="sha256:2"))
    until(lambda: ask(server.address, "GET", "/v1/models/chirp").document["version"] == "1.1.0", "it is served")
    assert ask(server.address, "GET", "/v1/models/chirp").document["versions"] == ["1.0.0", "1.1.0"]


def test_reloading_under_load_is_invisible(start, source):
    """Every answer is one version's, whole: the digest it names is the one whose numbers it has."""
    server = start(source=source, poll_seconds=0.01)
    stop = threading.Event()
    problems = []

    def keep_asking():
        from tests.service.asking import read_msgpack

        while not stop.is_set():
            answer = evaluate(server.address, question(output="amplitude_phase"))
            if answer.status != 200:
                problems.append(answer.body)
                continue
            message = read_msgpack(answer.body)
            expected = float(message["model"]["version"].split(".")[1]) + 1.0
            seen.add(message["model"]["version"])
            if abs(message["amplitude"][0, 0] / unit - expected) > 1e-9:
                problems.append(message["model"])

    unit = ChirpModel().predict_amplitude_phase([20.0], _binary()).amplitude[0]
    seen: set[str] = set()
    askers = [threading.Thread(target=keep_asking) for _ in range(4)]
    for asker in askers:
        asker.start()
    for minor in range(1, 21):
        source.add(ChirpModel(version=f"1.{minor}.0", digest=f"sha256:{minor + 1}", scale=minor + 1.0))
        until(lambda name=f"1.{minor}.0": server.app.parts.registry.find("chirp").identity.version == name, "served")
    until(lambda: "1.20.0" in seen, "the last one answers")
    stop.set()
    for asker in askers:
        asker.join()
    assert problems == []
    assert len(seen) > 3


def _binary():
    from bnserve_protocol import ParametersWithExtrinsic
    from tests.service.asking import GW170817

    return ParametersWithExtrinsic(**GW170817)


def test_a_server_without_any_model_ends_with_the_reason(start):
    source = MemorySource().add(ChirpModel(healthy=False))
    with pytest.raises(ModelLoading, match=r"chirp 1\.0\.0: .*does not reproduce"):
        start(source=source)
