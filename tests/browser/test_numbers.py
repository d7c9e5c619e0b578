"""The numbers that the pages bring along, and their own physics, against Python's."""

import importlib.util
import json
import subprocess

import numpy as np
import pytest

from bnserve_client._lal_precession import components
from bnserve_protocol import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS
from bnserve_surrogate.baseline import taylorf2_amplitude, taylorf2_phase
from bnserve_surrogate.training.data.noise import advanced_ligo_design, einstein_telescope_d
from tests.architecture.rooms import ROOT

PAGES = ROOT / "service" / "bnserve_service" / "pages"
NOISE = json.loads((PAGES / "data" / "noise.json").read_text())
INTRINSIC = {"mass_ratio": (1.0, 3.0), "chi_1": (-0.5, 0.5), "chi_2": (-0.5, 0.5), "lambda_1": (0.0, 5000.0),
             "lambda_2": (0.0, 5000.0)}  # fmt: skip


def in_node(script: str, question: object) -> object:
    """What a script of JavaScript prints, that may import what the pages do and has `question`."""
    head = 'import { readFileSync } from "node:fs"; const question = JSON.parse(readFileSync(0));\n'
    command = ["node", "--input-type=module", "--eval", head + script]
    done = subprocess.run(command, input=json.dumps(question), capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.mark.filterwarnings("ignore::DeprecationWarning:bilby.*", "ignore::SyntaxWarning")
def test_they_are_those_that_the_command_writes():
    """Otherwise: python docs/explorer_data.py."""
    pytest.importorskip("bilby")
    place = importlib.util.spec_from_file_location("explorer_data", ROOT / "docs" / "explorer_data.py")
    module = importlib.util.module_from_spec(place)
    place.loader.exec_module(module)
    for path, text in module.documents().items():
        assert path.read_text() == text, path.name


def test_noise_curves_are_those_of_the_detectors():
    curves = {curve["key"]: curve for curve in NOISE["curves"]}
    assert set(curves) == {"aligo", "et", "ce"}
    f, asd = (np.array(curves["et"][name]) for name in ("frequencies", "asd"))
    np.testing.assert_allclose(asd, np.sqrt(einstein_telescope_d(f)), rtol=5e-3)  # five digits of f, at a wall
    f, asd = (np.array(curves["aligo"][name]) for name in ("frequencies", "asd"))
    inside = (f > 25.0) & (f < 4000.0)
    np.testing.assert_allclose(asd[inside], np.sqrt(advanced_ligo_design(f[inside])), rtol=0.06)  # a fit of the curve
    ce = np.array(curves["ce"]["asd"])
    assert 1e-25 < ce.min() < 2e-25


def test_the_baseline_is_that_of_the_surrogate():
    rng = np.random.default_rng(1)
    drawn = {name: rng.uniform(*ends, 50) for name, ends in INTRINSIC.items()}
    f, total_mass = np.geomspace(5.0, 2000.0, 40), 2.9
    binaries = [{name: values[i] for name, values in drawn.items()} | {"total_mass": total_mass, "distance_mpc": 40.0}
                for i in range(50)]  # fmt: skip
    script = f"""
        const {{ baseline }} = await import("{PAGES / "physics" / "baseline.js"}");
        const data = JSON.parse(readFileSync("{PAGES / "data" / "baseline.json"}"));
        console.log(JSON.stringify(question.binaries.map((one) => baseline(one, question.f, data))));
    """
    found = in_node(script, {"binaries": binaries, "f": f.tolist()})
    seconds = total_mass * SOLAR_MASS_SECONDS
    phase = -taylorf2_phase(f * seconds, *drawn.values())
    nu = drawn["mass_ratio"] / (1.0 + drawn["mass_ratio"]) ** 2
    size = taylorf2_amplitude(f * seconds, *(drawn[name] for name in ("mass_ratio", "chi_1", "chi_2")))
    size *= nu[:, None] * seconds**2 / (40.0 * MEGAPARSEC_SECONDS)
    np.testing.assert_allclose([one["phase"] for one in found], phase, rtol=1e-12)
    np.testing.assert_allclose([one["amplitude"] for one in found], size, rtol=1e-12)


def test_angles_of_a_binary_that_precesses_are_those_that_the_client_reads():
    rng = np.random.default_rng(2)
    names = ("chi_1x", "chi_1y", "chi_1", "chi_2x", "chi_2y", "chi_2")
    binaries = [
        dict(zip(names, rng.uniform(-0.4, 0.4, 6) * np.array([1, 1, 1, *([i % 3 > 0] * 2), 1]), strict=True))
        | {"inclination": rng.uniform(0.0, np.pi), "mass_ratio": rng.uniform(1.0, 3.0), "total_mass": 2.8}
        | {"lambda_1": 0.0, "lambda_2": 0.0, "reference_phase": rng.uniform(0.0, 12.0)}
        | {"reference_frequency": rng.uniform(10.0, 50.0)}
        for i in range(30)
    ]  # fmt: skip
    script = f"""
        const {{ anglesOf }} = await import("{PAGES / "physics" / "angles.js"}");
        console.log(JSON.stringify(question.map(anglesOf)));
    """
    for binary, angles in zip(binaries, in_node(script, binaries), strict=True):
        heavier = 2.8 * binary["mass_ratio"] / (1.0 + binary["mass_ratio"])
        masses = {"mass_1": heavier, "mass_2": 2.8 - heavier}
        found = components(masses | angles, binary["reference_frequency"], 0.5 * binary["reference_phase"])
        for name, value in found.items():
            assert value == pytest.approx(binary[name], abs=1e-13)


def test_a_mismatch_is_the_least_over_time_and_phase():
    """Two waveforms that differ in nothing else, and two that differ by what no time or phase mends."""
    f = np.geomspace(20.0, 2000.0, 1000)
    size, bend = f ** (-7.0 / 6.0) * 1e-20, 0.3 * np.sin(4.0 * np.log(f))
    script = f"""
        const {{ differenceOf }} = await import("{PAGES / "physics" / "difference.js"}");
        const of = (other) => differenceOf(question.curve, question.f, question.one, other).mismatch;
        console.log(JSON.stringify([of(question.moved), of(question.bent)]));
    """
    one = {"amplitude": size.tolist(), "phase": np.zeros(1000).tolist()}
    moved = one | {"phase": (1.7 + 2.0 * np.pi * f * 3e-3).tolist()}
    bent = one | {"phase": (bend + 1.0 - 2.0 * np.pi * f * 1e-3).tolist()}
    question = {"f": f.tolist(), "one": one, "moved": moved, "bent": bent, "curve": NOISE["curves"][0]}
    same, other = in_node(script, question)
    assert same < 1e-9
    asd = np.interp(f, NOISE["curves"][0]["frequencies"], NOISE["curves"][0]["asd"])
    weights = np.gradient(f) * (size / asd) ** 2
    times = np.linspace(-2e-3, 2e-3, 4001)
    overlaps = np.abs(np.exp(1j * (bend + 2.0 * np.pi * np.multiply.outer(times, f))) @ weights) / weights.sum()
    assert other == pytest.approx(1.0 - overlaps.max(), rel=0.02)
