"""What each room registers for others to find exists, and can be looked at without the program that looks for it."""

import importlib
import tomllib

import pytest

from tests.architecture.rooms import ROOMS, ROOT, run_python


def registered() -> list[tuple[str, str, str]]:
    """Group, name and target of every entry point, commands included."""
    found = []
    for room in ROOMS:
        project = tomllib.loads((ROOT / room / "pyproject.toml").read_text())["project"]
        groups = project.get("entry-points", {}) | {"console_scripts": project.get("scripts", {})}
        found += [(group, name, target) for group, names in groups.items() for name, target in names.items()]
    return found


@pytest.mark.parametrize(("group", "name", "target"), registered())
def test_what_is_registered_exists(group, name, target):
    module, _, attribute = target.partition(":")
    loaded = importlib.import_module(module)
    assert not attribute or callable(getattr(loaded, attribute)), f"{group}: {name}"


def test_pycbc_finds_each_form_of_the_approximant():
    """Not ``fd_det``: of an approximant that is there, PyCBC thinks that it applies the detectors' response itself."""
    groups = {group for group, name, _ in registered() if name == "bnserve" and group.startswith("pycbc.")}
    assert groups == {f"pycbc.waveform.{kind}" for kind in ("fd", "fd_sequence", "length", "end_freq")}


def test_they_are_loaded_where_pycbc_is_not_installed():
    """PyCBC loads them in the middle of its own import, which they must not begin again."""
    code = "import sys; sys.modules['pycbc'] = None; import bnserve_client.pycbc as ours; print(*ours.__all__)"
    assert run_python(code).split() == ["end_frequency", "frequency_series", "length", "samples"]
