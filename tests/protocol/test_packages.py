"""Packages of extras: imported where they are needed, or a sentence about what to install."""

import sys

import pytest

from bnserve_protocol import PackageMissing, require


def test_a_package_that_is_there_is_imported():
    assert require("json.decoder", "Reading", "extra") is sys.modules["json.decoder"]


@pytest.mark.parametrize(("extra", "command"), [("train", r"pip install '\.\[train\]'"), ("", r"pip install \.$")])
def test_a_package_that_is_missing_is_named_with_what_installs_it(extra, command):
    with pytest.raises(PackageMissing, match=f"^Training needs the package 'nobody_has', which is not.*{command}"):
        require("nobody_has.this.module", "Training", extra)


def test_the_package_that_a_module_of_ours_imports_is_named(tmp_path, monkeypatch):
    (tmp_path / "bnserve_of_a_test.py").write_text("import nobody_has\n")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(PackageMissing, match="'nobody_has'"):
        require("bnserve_of_a_test", "A test")


def test_a_package_that_is_broken_says_how(tmp_path, monkeypatch):
    (tmp_path / "broken_package.py").write_text("raise ImportError('libgsl.so.27: cannot open')\n")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(PackageMissing, match=r"'broken_package', which cannot be imported \(libgsl.so.27"):
        require("broken_package", "A test")


def test_a_module_of_ours_that_does_not_exist_is_a_defect_and_nothing_to_install():
    with pytest.raises(ModuleNotFoundError):
        require("bnserve_protocol.nothing", "A test")
