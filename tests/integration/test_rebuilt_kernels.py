"""The compiled kernels that are shipped, and run, are what their sources compile to."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import bnserve_inference.adjoint_kernel._call as adjoint
import bnserve_inference.fisher._factorisation as fisher
import bnserve_inference.fisher_kernel._assembly as factorisation
import bnserve_inference.kernel._contraction as contraction
import bnserve_inference.marginal_kernel._call as integrals
import bnserve_inference.modes_kernel._contraction as contraction_of_modes
import bnserve_inference.moving_kernel._contraction as contraction_of_moving
import bnserve_surrogate.adjoint._call as adjoint_of_modes
import bnserve_surrogate.kernel._evaluate as surrogate
import bnserve_surrogate.kernel._loader as loader
import bnserve_surrogate.precession._twist as precession
import bnserve_surrogate.tangents._call as tangents
from bnserve_inference import Detector, likelihood
from bnserve_inference.fisher import Network, NoiseCurve, forecast
from bnserve_protocol import Calibration, DistanceMarginalisation, EvaluationOptions, ParameterBatch
from bnserve_surrogate import Model
from bnserve_surrogate.kernel.build import TOOLCHAIN_PREFIX, toolchain
from tests.inference.networks import F_MAX, F_MIN, columns, full, network
from tests.inference.test_kinds_agree import binned, errors
from tests.surrogate.conftest import random_batch

pytestmark = pytest.mark.slow

TOLERANCE = 1e-10
"""Relative, between builds of different compilers: each may fuse and order operations in its own way."""


def rebuilt(builder: str, shipped: Path, folder: Path) -> Path:
    """A kernel built anew; checked byte for byte where the tools are those that built the one shipped."""
    file = folder / shipped.name
    command = [sys.executable, "-m", builder, "--output", str(file)]
    before = shipped.read_bytes()
    # numba's settings are the build's alone.
    environment = {name: value for name, value in os.environ.items() if not name.startswith("NUMBA_")}
    subprocess.run(command, check=True, env=environment)
    assert shipped.read_bytes() == before
    built_by = before.decode().splitlines()[1]
    assert built_by.startswith(TOOLCHAIN_PREFIX)
    if built_by == toolchain():
        assert file.read_bytes() == before, f"run: python -m {builder}"
    return file


def assert_close(shipped, anew):
    np.testing.assert_allclose(shipped, anew, rtol=TOLERANCE, atol=TOLERANCE * np.abs(anew).max())


def test_the_kernel_is_what_its_sources_compile_to(tmp_path, monkeypatch):
    file = rebuilt("bnserve_surrogate.kernel.build", loader.ASSEMBLY, tmp_path)
    again = loader.load_assembly(file, loader.ENTRY_POINT, vectorise=False)
    batch, model = ParameterBatch(random_batch(11)), Model.default()
    for f in (np.geomspace(3.0, 2700.0, 300), np.linspace(3.0, 2700.0, 20_000)):
        shipped = everything(model, f, batch)
        with monkeypatch.context() as patch:
            patch.setattr(surrogate, "load_kernel", lambda: again)
            anew = everything(model, f, batch)
        for one, other in zip(shipped, anew, strict=True):
            assert_close(one, other)


def everything(model, f, batch):
    """What the kernel computes: of all modes, their sum, and the (2, 2) alone."""
    alone = EvaluationOptions(modes=((2, 2),))
    summed, curves = model.predict_batch(f, batch), model.predict_amplitude_phase(f, batch, options=alone)
    strain = model.predict_factored(f, batch, options=alone).h
    return summed.plus, summed.cross, model.predict_modes(f, batch).h, strain, curves.amplitude, curves.phase


def test_the_precession_is_what_its_sources_compile_to(tmp_path, monkeypatch):
    file = rebuilt("bnserve_surrogate.precession.build", precession.ASSEMBLY, tmp_path)
    again = loader.load_assembly(file, precession.ENTRY_POINT)
    random, f = np.random.default_rng(1), np.geomspace(10.0, 2700.0, 300)
    batch = ParameterBatch(random_batch(11), random.uniform(-0.3, 0.3, (11, 4)))
    model, options = Model.default(), EvaluationOptions(reference_frequency=20.0)
    shipped = model.predict_batch(f, batch, options=options)
    with monkeypatch.context() as patch:
        patch.setattr(precession, "load_twist", lambda: again)
        anew = model.predict_batch(f, batch, options=options)
    assert_close(shipped.plus, anew.plus)
    assert_close(shipped.cross, anew.cross)


def test_the_derivatives_are_what_their_sources_compile_to(tmp_path, monkeypatch):
    file = rebuilt("bnserve_surrogate.tangents.build", tangents.ASSEMBLY, tmp_path)
    again = loader.load_assembly(file, tangents.ENTRY_POINT, vectorise=False)
    model, f, batch = Model.default(), np.geomspace(3.0, 2700.0, 300), ParameterBatch(random_batch(11))
    shipped = model.predict_derivatives(f, batch).derivatives
    with monkeypatch.context() as patch:
        patch.setattr(tangents, "load_tangents", lambda: again)
        assert_close(shipped, model.predict_derivatives(f, batch).derivatives)


def test_the_adjoint_of_modes_is_what_its_sources_compile_to(tmp_path, monkeypatch):
    file = rebuilt("bnserve_surrogate.adjoint.build", adjoint_of_modes.ASSEMBLY, tmp_path)
    again = loader.load_assembly(file, adjoint_of_modes.ENTRY_POINT, vectorise=False)
    model, f, batch = Model.default(), np.geomspace(3.0, 2700.0, 300), ParameterBatch(random_batch(11))
    found = model.predict_pullback(f, batch)
    shipped = found.pull_back(found.h)
    with monkeypatch.context() as patch:
        patch.setattr(adjoint_of_modes, "load_adjoint", lambda: again)
        assert_close(shipped, found.pull_back(found.h))


def test_the_contraction_is_what_its_sources_compile_to(tmp_path, monkeypatch):
    file = rebuilt("bnserve_inference.kernel.build", contraction.ASSEMBLY, tmp_path)
    again = loader.load_assembly(file, contraction.ENTRY_POINT)
    model = Model.load("fast", "1.0.0")
    data, batch = network(model), columns(20)
    calibration = Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX)
    for analysis in (full(data, calibration=calibration), binned(model, data, calibration=calibration)):
        ours, given = likelihood(model, analysis), batch | errors(batch)
        shipped = ours.log_likelihood(given)
        with monkeypatch.context() as patch:
            patch.setattr(contraction, "load_contraction", lambda: again)
            assert_close(shipped, ours.log_likelihood(given))


def test_the_contraction_of_several_modes_is_what_its_sources_compile_to(tmp_path, monkeypatch):
    file = rebuilt("bnserve_inference.modes_kernel.build", contraction_of_modes.ASSEMBLY, tmp_path)
    again = loader.load_assembly(file, contraction_of_modes.ENTRY_POINT)
    model = Model.default()
    data, batch = network(model), columns(20)
    options = {"calibration": Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX), "phase_marginalisation": True}
    for analysis in (full(data, **options), binned(model, data, **options)):
        ours, given = likelihood(model, analysis), batch | errors(batch)
        shipped = ours.log_likelihood(given)
        with monkeypatch.context() as patch:
            patch.setattr(contraction_of_modes, "load_contraction", lambda: again)
            assert_close(shipped, ours.log_likelihood(given))


def test_the_contraction_of_moving_detectors_is_what_its_sources_compile_to(tmp_path, monkeypatch):
    file = rebuilt("bnserve_inference.moving_kernel.build", contraction_of_moving.ASSEMBLY, tmp_path)
    again = loader.load_assembly(file, contraction_of_moving.ENTRY_POINT)
    model = Model.default()
    detectors = ["H1", Detector.named("CE40", finite_arms=True)]
    data, batch = network(model, detectors, response="moving"), columns(20)
    options = {"calibration": Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX), "response": "moving"}
    for analysis in (full(data, **options), binned(model, data, **options)):
        ours, given = likelihood(model, analysis), batch
        shipped = ours.log_likelihood(given)
        with monkeypatch.context() as patch:
            patch.setattr(contraction_of_moving, "load_contraction", lambda: again)
            assert_close(shipped, ours.log_likelihood(given))


def test_the_integrals_are_what_their_sources_compile_to(tmp_path, monkeypatch):
    file = rebuilt("bnserve_inference.marginal_kernel.build", integrals.ASSEMBLY, tmp_path)
    again = loader.load_assembly(file, integrals.ENTRY_POINT)
    distance = DistanceMarginalisation(minimum=20.0, maximum=200.0)
    for model in (Model.load("fast", "1.0.0"), Model.default()):
        data, given = network(model), columns(20, width=0.25)
        ours = likelihood(model, full(data, phase_marginalisation=True, distance_marginalisation=distance))
        shipped = ours.gradients(given)
        with monkeypatch.context() as patch:
            patch.setattr(integrals, "load_integrals", lambda: again)
            anew = ours.gradients(given)
        assert_close(shipped.log_likelihood, anew.log_likelihood)
        assert_close(shipped.gradient, anew.gradient)


def test_the_factorisation_of_forecasts_is_what_its_sources_compile_to(tmp_path, monkeypatch):
    file = rebuilt("bnserve_inference.fisher_kernel.build", factorisation.ASSEMBLY, tmp_path)
    again = loader.load_assembly(file, factorisation.ENTRY_POINT, vectorise=False)
    sites, curve = ["H1", Detector.named("CE40", finite_arms=True)], NoiseCurve.named("CE40")
    own, samples = Network(sites, [curve, curve], 10.0, 1000.0, 1187008882.4), columns(5) | {"distance_mpc": 100.0}
    shipped = forecast(Model.default(), own, samples)
    with monkeypatch.context() as patch:
        patch.setattr(fisher, "load_factorisation", lambda: again)
        anew = forecast(Model.default(), own, samples)
    assert_close(shipped.snr, anew.snr)
    for one, other in zip(shipped.root, anew.root, strict=True):
        assert_close(one, other)


def test_the_adjoint_of_contractions_is_what_its_sources_compile_to(tmp_path, monkeypatch):
    file = rebuilt("bnserve_inference.adjoint_kernel.build", adjoint.ASSEMBLY, tmp_path)
    again = loader.load_assembly(file, adjoint.ENTRY_POINT, vectorise=False)
    model = Model.default()
    data, batch = network(model), columns(8, width=0.25)
    options = {"calibration": Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX), "response": "moving"}
    for analysis in (full(data, **options), binned(model, data, **options)):
        ours, given = likelihood(model, analysis), batch | errors(batch)
        shipped = ours.gradients(given).gradient
        with monkeypatch.context() as patch:
            patch.setattr(adjoint, "load_adjoint", lambda: again)
            assert_close(shipped, ours.gradients(given).gradient)
