"""Names, versions, labels, several roots, and what a loaded artifact is."""

from datetime import UTC, datetime, timedelta, timezone

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from packaging.version import Version

from bnserve_protocol import ArtifactCorrupted, InvalidRequest, ModelUnknown, StoreUnknown
from bnserve_store import SHIPPED_MODELS, ModelStore
from bnserve_store._files import is_version, version_key


def test_what_is_published_is_loaded(store, tensors):
    artifact = store.load("gw", "1.0.0")
    assert artifact.tensors.keys() == tensors(1).keys()
    for name, expected in tensors(1).items():
        np.testing.assert_array_equal(artifact.tensors[name], expected, strict=True)
    assert artifact.manifest.metadata["citation"] == "Ünal & Co."
    assert store.verify("gw", "1.0.0") == store.manifest("gw", "1.0.0") == artifact.manifest


def test_a_loaded_artifact_cannot_be_changed(store):
    artifact = store.load("gw")
    for array in artifact.tensors.values():
        assert array.flags.c_contiguous
        assert not array.flags.writeable
    with pytest.raises(TypeError):
        artifact.tensors["nodes"] = np.zeros(3)


def test_the_digest_covers_tensors_and_metadata_and_nothing_else(tmp_path, tensors):
    def digest(folder, seed=1, metadata=None, **more):
        store = ModelStore([tmp_path / folder])
        return store.publish("gw", "1.0.0", tensors(seed), metadata or {"a": 1.0, "b": 2}, **more).digest

    first = digest("1")
    assert first.startswith("sha256:")
    assert len(first) == 7 + 64
    assert digest("2", metadata={"b": 2, "a": 1.0}, labels=("other",)) == first
    assert digest("3", seed=2) != first
    assert digest("4", metadata={"a": 1.0, "b": 3}) != first
    assert digest("5", created=datetime(2026, 1, 1, tzinfo=UTC)) != first


def test_the_time_of_creation_is_kept_with_its_zone(store, tensors):
    moment = datetime(2026, 3, 1, 12, 30, 5, 250, tzinfo=timezone(timedelta(hours=2)))
    store.publish("gw", "2.0", tensors(3), {}, created=moment)
    assert store.manifest("gw", "2.0").created == moment


def test_names_versions_and_labels_are_listed(store, tensors):
    for version in ("1.10.0", "1.2.0", "2.0.0rc1"):
        store.publish("gw", version, tensors(1), {}, labels=())
    store.publish("another", "1.0", tensors(1), {})
    assert store.names() == ["another", "gw"]
    assert store.versions("gw") == ["1.0.0", "1.1.0", "1.2.0", "1.10.0", "2.0.0rc1"]
    assert store.labels("gw") == {"candidate": "1.1.0", "stable": "1.0.0"}


_numbers = st.integers(0, 12)
_versions = st.builds(
    lambda release, *suffixes: ".".join(map(str, release)) + "".join(suffixes),
    st.lists(_numbers, min_size=1, max_size=4),
    st.one_of(st.just(""), st.builds("{}{}".format, st.sampled_from(["a", "b", "rc"]), _numbers)),
    st.one_of(st.just(""), st.builds(".post{}".format, _numbers)),
    st.one_of(st.just(""), st.builds(".dev{}".format, _numbers)),
)


@settings(deadline=None)  # a busy machine is not a defect
@given(st.lists(_versions, min_size=2, max_size=8))
def test_versions_are_ordered_as_pep_440_orders_them(versions):
    assert all(is_version(version) for version in versions)
    ours = sorted(versions, key=version_key)
    assert [Version(version) for version in ours] == sorted(Version(version) for version in versions)


def test_a_label_or_a_version_resolves_to_a_version(store):
    assert store.resolve("gw") == "1.0.0"
    assert store.resolve("gw", "candidate") == "1.1.0"
    assert store.resolve("gw", "1.1.0") == "1.1.0"


def test_labels_move(store):
    store.set_label("gw", "stable", "candidate")
    assert store.resolve("gw") == "1.1.0"
    assert store.labels("gw") == {"candidate": "1.1.0", "stable": "1.1.0"}


def test_an_unknown_model_is_named_with_its_nearest(store):
    with pytest.raises(ModelUnknown, match=r"no model 'gv'.*Did you mean 'gw'"):
        store.load("gv")
    with pytest.raises(ModelUnknown, match="Known models: gw"):
        store.versions("something else")


def test_an_unknown_version_lists_the_known_ones(store):
    with pytest.raises(ModelUnknown, match=r"'3\.0'.*versions: 1\.0\.0, 1\.1\.0; labels: candidate, stable"):
        store.load("gw", "3.0")
    with pytest.raises(ModelUnknown, match=r"'3\.0'"):
        store.set_label("gw", "stable", "3.0")


def test_a_label_whose_version_is_gone_says_so(store, root):
    (root / "gw" / "labels.json").write_text('{"stable": "7.0.0"}')
    with pytest.raises(ModelUnknown, match=r"Label 'stable'.*points to version 7\.0\.0.*set the label"):
        store.load("gw")


@pytest.mark.parametrize("text", ["", "{", "[]", '{"stable": 1}', '{"stable": "../1.0.0"}', "\xff", "[" * 100_000])
def test_damaged_labels_are_refused_and_versions_still_load(store, root, text):
    (root / "gw" / "labels.json").write_bytes(text.encode("latin-1"))
    with pytest.raises(ArtifactCorrupted, match=r"gw/labels\.json is damaged.*Remove it"):
        store.load("gw")
    assert store.load("gw", "1.0.0").manifest.version == "1.0.0"


def test_a_store_that_is_not_there_is_named(tmp_path):
    missing = ModelStore([tmp_path / "nowhere"])
    for call in (missing.names, lambda: missing.load("gw"), lambda: missing.versions("gw")):
        with pytest.raises(StoreUnknown, match=r"nowhere' does not exist"):
            call()
    (tmp_path / "file").touch()
    with pytest.raises(StoreUnknown, match="not a directory"):
        ModelStore([tmp_path / "file"]).names()


def test_earlier_roots_come_first(tmp_path, tensors):
    mine, theirs = ModelStore([tmp_path / "mine"]), ModelStore([tmp_path / "theirs"])
    mine.publish("gw", "1.0", tensors(1), {"whose": "mine"})
    theirs.publish("gw", "1.0", tensors(2), {"whose": "theirs"})
    theirs.publish("gw", "2.0", tensors(3), {"whose": "theirs"}, labels=("stable", "newest"))
    theirs.publish("other", "1.0", tensors(4), {})
    both = ModelStore([tmp_path / "mine", tmp_path / "theirs"])
    assert both.names() == ["gw", "other"]
    assert both.versions("gw") == ["1.0", "2.0"]
    assert both.labels("gw") == {"newest": "2.0", "stable": "1.0"}
    assert both.load("gw").manifest.metadata == {"whose": "mine"}
    assert both.load("gw", "newest").manifest.metadata == {"whose": "theirs"}


def test_the_shipped_models_come_last_and_verify(root, store):
    default = ModelStore.default([root])
    assert default.roots == (str(root), str(SHIPPED_MODELS))
    assert "gw" in default.names()
    shipped = ModelStore.default()
    for name in shipped.names():
        for version in shipped.versions(name):
            assert shipped.verify(name, version).version == version


def test_things_that_are_not_models_are_not_listed(store, root):
    (root / "README.md").touch()
    (root / ".hidden" / "1.0").mkdir(parents=True)
    (root / "empty").mkdir()
    (root / "gw" / ".staging-abc" / "9.0").mkdir(parents=True)
    (root / "gw" / "notes").mkdir()
    assert store.names() == ["gw"]
    assert store.versions("gw") == ["1.0.0", "1.1.0"]


class Elsewhere:
    """What has a path and is none of pathlib's."""

    def __init__(self, path):
        self._path = path

    def __fspath__(self):
        return str(self._path)


ROOTS = {
    "text": str,
    "numpy's text": lambda path: np.str_(path),
    "a path": lambda path: path,
    "what has a path": Elsewhere,
    "a list": lambda path: [Elsewhere(path)],
    "a tuple": lambda path: (path,),
}


@pytest.mark.parametrize("given", ROOTS.values(), ids=ROOTS)
def test_a_root_is_given_in_every_form_that_a_path_has(tmp_path, tensors, given):
    for store in (ModelStore(given(tmp_path)), ModelStore.default(given(tmp_path))):
        assert store.roots[0] == str(tmp_path)
        version = f"{len(store.roots)}.0"
        assert store.publish("gw", version, tensors(1), {}, root=Elsewhere(tmp_path)).version == version


@pytest.mark.parametrize("roots", [None, 3, b"/store", [b"/store"], [None], {"/store"}], ids=str)
def test_a_root_that_is_none_is_refused(roots):
    for make in (ModelStore, ModelStore.default):
        with pytest.raises(InvalidRequest, match="A root of a model store is a directory or a URL"):
            make(roots)


@pytest.mark.parametrize("name", [None, 3, b"gw"], ids=str)
def test_names_and_versions_that_are_no_text_are_unknown(store, tensors, name):
    with pytest.raises(ModelUnknown):
        store.load(name)
    with pytest.raises(ModelUnknown, match="A version or label is a string"):
        store.load("gw", name)
    for arguments in ((name, "3.0"), ("gw", name)):
        with pytest.raises(InvalidRequest):
            store.publish(*arguments, tensors(1), {})
    with pytest.raises(InvalidRequest):
        store.set_label("gw", name, "1.0.0")
