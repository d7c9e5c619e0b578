"""The bill of materials of the lock, and the look for what is old or known to be vulnerable in it."""

import importlib.util
import json
import os
import shutil
import subprocess
import sys
import time
import zipfile

import pytest

from bnserve_protocol import __version__
from tests.architecture.rooms import ROOT
from tests.architecture.test_locks import locked

_spec = importlib.util.spec_from_file_location("release_lock", ROOT / "release" / "lock.py")
lock = importlib.util.module_from_spec(_spec)
sys.modules["release_lock"] = lock  # dataclasses look for their module there
_spec.loader.exec_module(lock)


@pytest.fixture(scope="module")
def bill():
    command = [sys.executable, ROOT / "release" / "lock.py", "sbom"]
    return json.loads(subprocess.run(command, capture_output=True, check=True).stdout)


def test_the_bill_names_what_the_image_holds(bill):
    """Its form was checked by CycloneDX's own strict validator when it was written."""
    listed = {(component["name"], component["version"]) for component in bill["components"]}
    pinned = {(name, version) for name, versions in locked("requirements.lock").items() for version in versions}
    dockerfile = (ROOT / "Dockerfile").read_text()
    assert listed == pinned | {
        (name, __version__) for folder, name in lock.ROOMS.items() if f"./{folder}" in dockerfile
    }
    assert all(component.get("externalReferences", [{"hashes": True}])[0]["hashes"] for component in bill["components"])


def test_it_says_who_depends_on_whom(bill):
    asked = {entry["ref"]: entry["dependsOn"] for entry in bill["dependencies"]}
    references = {component["bom-ref"] for component in bill["components"]}
    assert set(asked) == references | {"bnserve"}
    assert {url for urls in asked.values() for url in urls} <= references
    fastapi = next(reference for reference in references if "/fastapi@" in reference)
    assert any("/starlette@" in url for url in asked[fastapi])
    assert fastapi in asked[f"pkg:pypi/bnserve-service@{__version__}"]
    without = references - {url for urls in asked.values() for url in urls}
    assert without == set(), "each is there because something needs it"


def advisory(name, *events, kind="ECOSYSTEM", **more):
    ranges = [{"type": kind, "events": list(events)}]
    return {
        "affected": [{"package": {"ecosystem": "PyPI", "name": name}, "ranges": ranges}],
        "summary": "it leaks",
    } | more


CASES = {
    "HOLDS": advisory("One_Thing", {"introduced": "0"}, {"fixed": "2.1"}),
    "HOLDS-AGAIN": advisory("one.thing", {"introduced": "0"}, {"fixed": "1.0"}, {"introduced": "2.0"}),
    "NAMED": {"affected": [{"package": {"ecosystem": "PyPI", "name": "one-thing"}, "versions": ["2.0"]}]},
    "LAST": advisory("one-thing", {"introduced": "0"}, {"last_affected": "2.0"}),
    "BEFORE": advisory("one-thing", {"introduced": "0"}, {"last_affected": "1.9"}),
    "FIXED": advisory("one-thing", {"introduced": "0"}, {"fixed": "2.0"}),
    "LATER": advisory("one-thing", {"introduced": "2.0.1"}),
    "WITHDRAWN": advisory("one-thing", {"introduced": "0"}, withdrawn="2026-01-01T00:00:00Z"),
    "COMMITS": advisory("one-thing", {"introduced": "0"}, kind="GIT"),
    "OTHER": advisory("another-thing", {"introduced": "0"}),
}


@pytest.fixture
def folder(tmp_path):
    """Two locks, the second of nothing."""
    (tmp_path / "requirements.lock").write_text("one-thing==2.0 \\\n    --hash=sha256:00\n    # via bnserve-service\n")
    (tmp_path / "requirements-build.lock").write_text("")
    return tmp_path


def archive(folder, cases):
    path = folder / "all.zip"
    with zipfile.ZipFile(path, "w") as made:
        for name, told in cases.items():
            made.writestr(f"{name}.json", json.dumps({"id": name} | told))
    return path


def test_advisories_that_hold_are_found_and_no_others(folder, capsys):
    assert lock.check(archive(folder, CASES), folder) == 1
    said = capsys.readouterr().out
    assert {name for name in CASES if f" {name}: " in said} == {"HOLDS", "HOLDS-AGAIN", "NAMED", "LAST"}


def test_nothing_to_do_is_said_with_success(folder, capsys):
    assert lock.check(archive(folder, {"OTHER": CASES["OTHER"]}), folder) == 0
    assert "1 were looked at, 0 hold" in capsys.readouterr().out


def test_an_old_lock_is_to_be_renewed(folder, capsys):
    long_ago = time.time() - 100 * 86400
    os.utime(folder / "requirements.lock", (long_ago, long_ago))
    assert lock.check(archive(folder, {}), folder) == 1
    assert "renew it" in capsys.readouterr().out


def test_without_advisories_it_says_that_it_does_not_know(folder, capsys):
    assert lock.check(folder / "absent.zip", folder) == 3
    assert "NOT CHECKED" in capsys.readouterr().out


def test_the_age_is_that_of_the_last_change_in_git():
    assert shutil.which("git")
    assert 0 <= lock.days_old(ROOT / "requirements.lock") < 10_000
