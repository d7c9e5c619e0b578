"""Calibration envelopes from files: which way they correct, and the numbers that bilby reads."""

import numpy as np
import pytest

from benchmarks.gw170817.setting import DATA
from bnserve_inference import calibration_nodes, read_envelope
from bnserve_protocol import AnalysisInvalid, Calibration

NODES = Calibration(nodes=10, f_min=23.0, f_max=2000.0)
FILE = DATA / "L1_CalEnv.txt"


@pytest.mark.filterwarnings("default")  # of bilby and what it imports
@pytest.mark.parametrize("correction", ["data", "template"])
@pytest.mark.parametrize("detector", ["H1", "L1", "V1"])
def test_they_are_bilbys(detector, correction):
    bilby = pytest.importorskip("bilby")
    file = DATA / f"{detector}_CalEnv.txt"
    theirs = bilby.gw.prior.CalibrationPriorDict.from_envelope_file(
        str(file), NODES.f_min, NODES.f_max, NODES.nodes, detector, correction_type=correction
    )
    ours = read_envelope(file, NODES, correction=correction)
    for kind, mean, width in (
        ("amplitude", ours.amplitude, ours.amplitude_width),
        ("phase", ours.phase, ours.phase_width),
    ):
        gaussians = [theirs[f"recalib_{detector}_{kind}_{node}"] for node in range(NODES.nodes)]
        np.testing.assert_allclose(mean, [one.mu for one in gaussians], atol=1e-10)
        np.testing.assert_allclose(width, [one.sigma for one in gaussians], atol=1e-10)


def write(path, f, amplitude, phase, width=0.02):
    one = np.ones(len(f))
    columns = [f, amplitude * one, phase * one, (amplitude - width) * one, (phase - width) * one]
    np.savetxt(path, np.transpose([*columns, (amplitude + width) * one, (phase + width) * one]))
    return path


def test_a_correction_of_the_data_is_the_inverse_of_one_of_the_template(tmp_path):
    path = write(tmp_path / "envelope.txt", np.geomspace(20.0, 2048.0, 50), 1.25, 0.1)
    template = read_envelope(path, NODES, correction="template")
    data = read_envelope(path, NODES, correction="data")
    np.testing.assert_allclose(template.amplitude, 0.25)
    np.testing.assert_allclose(template.phase, 0.1)
    np.testing.assert_allclose(data.amplitude, 1.0 / 1.25 - 1.0)
    np.testing.assert_allclose(data.phase, -0.1)
    np.testing.assert_allclose(data.amplitude_width, 0.5 * (1.0 / 1.23 - 1.0 / 1.27))
    np.testing.assert_allclose([*data.phase_width, *template.phase_width, *template.amplitude_width], 0.02)


def test_nodes_are_those_of_the_analysis():
    assert read_envelope(FILE, NODES, correction="data").amplitude.shape == calibration_nodes(NODES).shape


def test_the_correction_must_be_stated():
    with pytest.raises(TypeError, match="correction"):
        read_envelope(FILE, NODES)
    with pytest.raises(AnalysisInvalid, match="'data' or 'template'"):
        read_envelope(FILE, NODES, correction="strain")


def test_files_that_are_none_are_refused(tmp_path):
    path = tmp_path / "envelope.txt"
    with pytest.raises(AnalysisInvalid, match=r"There is no file .*envelope\.txt"):
        read_envelope(path, NODES, correction="data")
    path.write_text("20 1 0\n")
    with pytest.raises(AnalysisInvalid, match="3 columns of 1 rows"):
        read_envelope(path, NODES, correction="data")
    path.write_text("words\n")
    with pytest.raises(AnalysisInvalid, match="7 columns of numbers"):
        read_envelope(path, NODES, correction="data")
    f = np.geomspace(20.0, 2048.0, 50)
    with pytest.raises(AnalysisInvalid, match="positive and increasing"):
        read_envelope(write(path, f[::-1], 1.0, 0.0), NODES, correction="data")
    with pytest.raises(AnalysisInvalid, match="magnitudes"):
        read_envelope(write(path, f, 0.0, 0.0), NODES, correction="data")
    with pytest.raises(AnalysisInvalid, match=r"from 30 to 2048 Hz"):
        read_envelope(write(path, np.geomspace(30.0, 2048.0, 50), 1.0, 0.0), NODES, correction="data")
