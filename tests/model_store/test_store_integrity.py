"""A damaged artifact is refused with a named error that says which file and what to do, whatever the damage."""

import json
import os
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest
import safetensors.numpy

from bnserve_protocol import ArtifactCorrupted, ArtifactError, ArtifactIncomplete, ModelUnknown, SchemaUnknown
from bnserve_store import ModelStore
from bnserve_store._files import decode_manifest, encode_manifest
from bnserve_store._publishing import describe

MANIFEST, TENSORS = "manifest.json", "tensors.safetensors"
FLIPS = 600


@pytest.fixture
def folder(store, root):
    return root / "gw" / "1.0.0"


def refused(store, error=ArtifactError, match=None):
    with pytest.raises(error, match=match) as caught:
        store.load("gw", "1.0.0")
    assert "gw/1.0.0/" in caught.value.detail
    assert store.roots[0] not in caught.value.detail
    assert store.load("gw", "1.1.0").manifest.version == "1.1.0"


def forge(folder, arrays, **changes):
    """Write a version whose digests are all right, as a faulty or hostile program could."""
    data = safetensors.numpy.save(arrays)
    manifest = describe("gw", "1.0.0", arrays, data, {}, None)
    for name, entry in changes.items():
        manifest.tensors[name] = entry
    (folder / TENSORS).write_bytes(data)
    (folder / MANIFEST).write_bytes(encode_manifest(manifest))


@pytest.mark.parametrize("file", [MANIFEST, TENSORS])
def test_no_flipped_byte_passes(store, folder, file):
    path, random = folder / file, np.random.default_rng(20260)
    good = path.read_bytes()
    for _ in range(FLIPS):
        bad = bytearray(good)
        bad[random.integers(len(bad))] ^= random.integers(1, 256)
        path.write_bytes(bad)
        with pytest.raises(ArtifactError):
            store.load("gw", "1.0.0")
    path.write_bytes(good)
    store.verify("gw", "1.0.0")


@pytest.mark.parametrize("file", [MANIFEST, TENSORS])
def test_no_white_space_passes(store, folder, file):
    """Changes that leave the meaning of the JSON alone are damage too."""
    path = folder / file
    good = path.read_bytes()
    for index in [index for index, byte in enumerate(good) if byte in b" \n"]:
        path.write_bytes(good[:index] + b"\t" + good[index + 1 :])
        with pytest.raises(ArtifactError):
            store.load("gw", "1.0.0")


@pytest.mark.parametrize("file", [MANIFEST, TENSORS])
@pytest.mark.parametrize("fraction", [0.0, 0.01, 0.3, 0.7, 0.99, "all but one byte"])
def test_a_truncated_file_is_incomplete(store, folder, file, fraction):
    path = folder / file
    good = path.read_bytes()
    path.write_bytes(good[:-1] if isinstance(fraction, str) else good[: int(fraction * len(good))])
    error = ArtifactError if isinstance(fraction, str) else ArtifactIncomplete
    refused(store, error, f"gw/1.0.0/{file}.*(Restore|publish)")


@pytest.mark.parametrize("file", [MANIFEST, TENSORS])
def test_a_longer_file_is_refused(store, folder, file):
    with (folder / file).open("ab") as stream:
        stream.write(b"\n")
    refused(store, ArtifactCorrupted)


@pytest.mark.parametrize("file", [MANIFEST, TENSORS])
def test_a_missing_file_is_named(store, folder, file):
    (folder / file).unlink()
    refused(store, ArtifactIncomplete, f"gw/1.0.0/{file} is missing.*Restore")


@pytest.mark.parametrize("file", [MANIFEST, TENSORS])
@pytest.mark.parametrize("data", [b"\x80\x04K\x01.", b"null", b"[[" * 50_000, b"\xff\xfe", b'{"a":' * 50_000, b"{}"])
def test_garbage_is_refused(store, folder, file, data):
    (folder / file).write_bytes(data)
    refused(store)


@pytest.mark.parametrize("file", [MANIFEST, TENSORS])
def test_a_pipe_or_folder_in_place_of_a_file_is_refused_at_once(store, folder, file):
    (folder / file).unlink()
    os.mkfifo(folder / file)
    refused(store, ArtifactCorrupted, "not a regular file")
    (folder / file).unlink()
    (folder / file).mkdir()
    refused(store, ArtifactError)


@pytest.mark.parametrize("files", [(MANIFEST,), (TENSORS,), (MANIFEST, TENSORS)])
def test_exchanged_files_are_refused(store, root, files):
    one, other = root / "gw" / "1.0.0", root / "gw" / "1.1.0"
    for file in files:
        first, second = (one / file).read_bytes(), (other / file).read_bytes()
        (one / file).write_bytes(second)
        (other / file).write_bytes(first)
    for version in ("1.0.0", "1.1.0"):
        with pytest.raises(ArtifactCorrupted):
            store.load("gw", version)


def test_a_renamed_model_or_version_is_refused(store, root):
    shutil.copytree(root / "gw", root / "copy")
    with pytest.raises(ArtifactCorrupted, match=r"copy/1\.0\.0/manifest\.json describes gw 1\.0\.0"):
        store.load("copy")
    (root / "gw" / "1.1.0").rename(root / "gw" / "9.0")
    with pytest.raises(ArtifactCorrupted, match=r"describes gw 1\.1\.0, not gw 9\.0"):
        store.manifest("gw", "9.0")


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_weights_that_are_not_finite_are_refused_even_with_right_digests(store, folder, value):
    forge(folder, {"weights": np.array([1.0, value])})
    refused(store, ArtifactCorrupted, "'weights' holds NaN or infinite")


def test_a_wrong_shape_or_dtype_is_refused(store, folder):
    arrays = {"weights": np.arange(6.0).reshape(2, 3)}
    forge(folder, arrays)
    store.verify("gw", "1.0.0")
    entry = decode_manifest((folder / MANIFEST).read_bytes(), MANIFEST).tensors["weights"]
    for change in ({"shape": (3, 2)}, {"shape": (6,)}, {"shape": (2, 3, 1)}, {"dtype": "<i8"}, {"dtype": "<f4"}):
        forge(folder, arrays, weights=type(entry)(**({f: getattr(entry, f) for f in entry.__struct_fields__} | change)))
        refused(store, ArtifactCorrupted, "'weights' is <f8 .2, 3., and should be")


def test_a_wrong_tensor_digest_is_refused(store, folder):
    arrays = {"weights": np.arange(6.0), "bias": np.ones(2)}
    forge(folder, arrays)
    bias = decode_manifest((folder / MANIFEST).read_bytes(), MANIFEST).tensors["bias"]
    forge(folder, arrays, bias=type(bias)(dtype="<f8", shape=(2,), sha256="0" * 64))
    refused(store, ArtifactCorrupted, "'bias' does not match its digest")


def test_missing_and_foreign_tensors_are_refused(store, folder):
    two, one = {"a": np.ones(2), "b": np.ones(3)}, {"a": np.ones(2)}
    forge(folder, one)
    short = decode_manifest((folder / MANIFEST).read_bytes(), MANIFEST)
    forge(folder, one, b=short.tensors["a"])
    refused(store, ArtifactIncomplete, "lacks the tensor 'b'")
    forge(folder, two)
    complete = decode_manifest((folder / MANIFEST).read_bytes(), MANIFEST)
    del complete.tensors["b"]
    (folder / MANIFEST).write_bytes(encode_manifest(complete))
    refused(store, ArtifactCorrupted, "a tensor that the manifest does not name")


def test_another_header_with_the_same_meaning_is_refused(store, folder):
    """The header of the tensors is covered by the digest of the whole file."""
    data = (folder / TENSORS).read_bytes()
    end = 8 + int.from_bytes(data[:8], "little")
    backwards = dict(reversed(json.loads(data[8:end]).items()))
    header = json.dumps(backwards, separators=(",", ":")).encode().ljust(end - 8)
    (folder / TENSORS).write_bytes(data[:8] + header + data[end:])
    assert safetensors.numpy.load_file(folder / TENSORS).keys() == safetensors.numpy.load(data).keys()
    refused(store, ArtifactCorrupted, "does not match its digest in the manifest")


def test_array_types_that_are_never_written_are_refused(store, folder):
    header = json.dumps({"a": {"dtype": "BF16", "shape": [1], "data_offsets": [0, 2]}}).encode()
    forge(folder, {"a": np.ones(1, "<f2")})
    size = (folder / TENSORS).stat().st_size
    data = (len(header).to_bytes(8, "little") + header + b"\0\0").ljust(size, b"\0")[:size]
    (folder / TENSORS).write_bytes(data)
    refused(store, ArtifactCorrupted, "not a complete safetensors file")


def rewrite(folder, change):
    content = json.loads((folder / MANIFEST).read_bytes())
    change(content)
    (folder / MANIFEST).write_text(json.dumps(content, sort_keys=True, indent=2, ensure_ascii=False) + "\n")


@pytest.mark.parametrize("version", [0, 2, 999])
def test_an_unknown_schema_says_what_to_do(store, folder, version):
    rewrite(folder, lambda content: content.update(schema_version=version, surprise=True))
    refused(store, SchemaUnknown, f"schema version {version}.*Upgrade bnserve")


@pytest.mark.parametrize(
    ("change", "error"),
    [
        (lambda content: content.update(surprise=1), ArtifactCorrupted),
        (lambda content: content["tensors"]["nodes"].update(surprise=1), ArtifactCorrupted),
        (lambda content: content.pop("metadata"), ArtifactIncomplete),
        (lambda content: content.pop("digest"), ArtifactIncomplete),
        (lambda content: content.pop("schema_version"), ArtifactIncomplete),
        (lambda content: content.update(schema_version="1"), ArtifactCorrupted),
        (lambda content: content.update(name="../gw"), ArtifactCorrupted),
        (lambda content: content.update(name="gw\n"), ArtifactCorrupted),
        (lambda content: content.update(version="latest"), ArtifactCorrupted),
        (lambda content: content.update(created="yesterday"), ArtifactCorrupted),
        (lambda content: content["tensors"]["nodes"].update(dtype="|O"), ArtifactCorrupted),
        (lambda content: content["tensors"]["nodes"].update(shape=[-1]), ArtifactCorrupted),
        (lambda content: content["tensors"]["nodes"].update(sha256="0"), ArtifactCorrupted),
        (lambda content: content["metadata"].update(edited=True), ArtifactCorrupted),
        (lambda content: content.update(digest="sha256:" + "0" * 64), ArtifactCorrupted),
    ],
)
def test_the_fields_of_a_manifest_are_closed_and_checked(store, folder, change, error):
    rewrite(folder, change)
    refused(store, error, r"gw/1\.0\.0/manifest\.json")


@pytest.mark.parametrize("text", ["../gw", "..", ".", "", "/etc", "gw/../gw", "gw/1.0.0", "gw\0", ".gw", "g w", "gw\n"])
def test_no_name_version_or_label_leaves_the_store(store, root, text):
    shutil.copytree(root / "gw", root.parent / "gw")
    with pytest.raises(ModelUnknown):
        store.load(text)
    with pytest.raises(ModelUnknown):
        store.load("gw", text)
    with pytest.raises(ModelUnknown):
        store.labels(text)


@pytest.mark.parametrize("part", ["gw", "gw/1.0.0", f"gw/1.0.0/{MANIFEST}", f"gw/1.0.0/{TENSORS}", "gw/labels.json"])
def test_links_out_of_the_store_are_refused(store, root, tmp_path, part):
    outside = tmp_path / "outside"
    shutil.move(root / part, outside)
    (root / part).symlink_to(outside)
    with pytest.raises(ArtifactCorrupted, match=f"{part}.* is a link that leads out of the store"):
        store.load("gw")
    assert store.names() == ([] if part == "gw" else ["gw"])


def test_links_inside_the_store_are_followed(store, root):
    """Container platforms mount volumes as links to a hidden folder of the same volume."""
    (root / "gw").rename(root / "..data")
    (root / "gw").symlink_to("..data")
    (root.parent / "alias").symlink_to(root)
    assert ModelStore([root.parent / "alias"]).load("gw").manifest.version == "1.0.0"


def test_a_link_to_itself_is_refused(store, folder):
    (folder / TENSORS).unlink()
    (folder / TENSORS).symlink_to(TENSORS)
    refused(store, ArtifactError)


def test_loading_runs_nothing_and_opens_nothing_but_the_files_of_the_store(store, root):
    """Recorded by an audit hook: no import, no pickle, no exec, no process, no network."""
    events = []
    sys.addaudithook(lambda event, arguments: events.append((event, arguments)) if recording else None)
    recording = True
    store.load("gw")
    recording = False
    banned = ("pickle", "exec", "compile", "subprocess", "os.system", "socket", "import")
    assert [event for event, _ in events if event.startswith(banned)] == []
    opened = [arguments[0] for event, arguments in events if event == "open" and not isinstance(arguments[0], int)]
    assert opened
    assert all(Path(path).is_relative_to(root) for path in opened)
