"""``bnserve demo``: it shows everything, notices a wrong bit, and leaves nothing behind."""

import os
import re
import signal
import socket
import subprocess
import sys
from dataclasses import replace
from urllib.parse import urlsplit

import numpy as np
import pytest
from matplotlib.image import imread

from bnserve_protocol import EvaluationOptions, Polarizations, RowStatus
from bnserve_service.demo import demonstration, server_process
from bnserve_service.demo.binaries import like_gw170817
from bnserve_service.demo.chirp import SAMPLING_RATE, evaluate_chirp
from bnserve_service.demo.picture import save_picture
from tests.architecture.rooms import run_python
from tests.architecture.test_thin import TRAINING
from tests.integration.conftest import COMMAND, bnserve

MERGER_AT_ZERO = EvaluationOptions(alignment="merger")
SIGNAL_BLUE = np.array([0x17, 0x50, 0x8F]) / 255.0


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    """One run of the command, and the folder it ran in."""
    folder = tmp_path_factory.mktemp("demo")
    command = [*COMMAND, "demo", "--binaries", "16"]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, timeout=300), folder


def address_in(output: str) -> str:
    found = re.search(r"^server +(http://[\d.:]+), ready after", output, re.MULTILINE)
    assert found, output
    return found.group(1)


def is_listening(address: str) -> bool:
    parts = urlsplit(address)
    try:
        socket.create_connection((parts.hostname, parts.port), timeout=10).close()
    except ConnectionRefusedError:
        return False
    return True


def test_it_succeeds_and_every_bit_is_the_same(demo):
    done, _ = demo
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.findall(r"^bits +([\d,]+) of ([\d,]+) .* identical", done.stdout, re.MULTILINE) == [
        ("8,864", "8,864"),  # 16 binaries, 277 frequencies, two polarisations
        ("259,616", "259,616"),  # and 8,113 frequencies
    ]


def test_it_says_which_model_answered(demo, local):
    done, _ = demo
    assert f"{local.description.name} {local.description.version}\n" in done.stdout
    assert local.description.digest in done.stdout


def test_it_prints_what_it_measured(demo):
    done, _ = demo
    for size in ("1 x 277", "16 x 277", "16 x 8,113"):
        assert re.search(rf"^ +{size} frequencies( +[\d.]+ ms +[\d,]+ / s){{2}}$", done.stdout, re.MULTILINE), (
            done.stdout
        )


def test_it_draws_the_signal(demo):
    _, folder = demo
    pixels = imread(folder / "bnserve-demo.png")[..., :3]
    assert pixels.shape[1] > pixels.shape[0] > 1000
    inked = (pixels < 0.9).any(axis=-1)
    of_the_signal = (np.abs(pixels - SIGNAL_BLUE) < 0.02).all(axis=-1)
    assert 0.02 < inked.mean() < 0.5
    for panel in (of_the_signal[:600], of_the_signal[600:, :800], of_the_signal[600:, 800:]):
        assert panel.sum() > 1000


def test_its_server_is_stopped(demo):
    done, _ = demo
    assert re.search(r"^server +stopped by SIGTERM after [\d.]+ s, exit code 0$", done.stdout, re.MULTILINE)
    assert not is_listening(address_in(done.stdout))


@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 128 + signal.SIGTERM), (signal.SIGHUP, 129)]
)
def test_whatever_ends_it_its_server_is_stopped(tmp_path, number, code):
    command = [*COMMAND, "demo", "--output", str(tmp_path / "demo.png")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        lines = iter(process.stdout.readline, "")
        address = address_in(next(line for line in lines if line.startswith("server ")))
        assert is_listening(address)
        process.send_signal(number)
        _, errors = process.communicate(timeout=120)
    assert process.returncode == code
    assert "Traceback" not in errors
    assert not is_listening(address)


def test_a_wrong_bit_is_noticed(tmp_path, monkeypatch, local):
    class NearlyTheSame:
        description, predict = local.description, local.predict

        def predict_batch(self, grid, batch):
            answer = local.predict_batch(grid, batch)
            plus = answer.plus.copy()
            plus[-1, 0] = np.nextafter(plus[-1, 0].real, 1.0) + 1j * plus[-1, 0].imag
            return Polarizations(plus=plus, cross=answer.cross, status=answer.status)

    monkeypatch.setattr(demonstration.LocalModel, "default", NearlyTheSame)
    lines: list[str] = []
    assert not demonstration.demonstrate(tmp_path / "demo.png", 3, lines.append)
    assert any("1,661 of 1,662 complex numbers ARE THE LOCAL MODEL'S" in line for line in lines)


def test_a_server_that_does_not_start_is_explained(monkeypatch):
    broken = (sys.executable, "-c", "import sys; print('bnserve listens on x'); sys.exit('no luck')")
    monkeypatch.setattr(server_process, "_COMMAND", broken)
    server = server_process.ServerProcess()
    with pytest.raises(server_process.ServerFailed, match="no luck"):
        server.__enter__()
    assert server.exit_code == 1


@pytest.fixture(scope="module")
def chirp(local):
    return evaluate_chirp(local, demonstration.ONE)


def test_the_strain_is_the_inverse_transform_of_the_model(local, chirp):
    for frequency in (200.0, 300.0, 1500.0):  # modes of m = 4 are whole from twice as high as (2, 2) on
        transform = (chirp.strain * np.exp(-2j * np.pi * frequency * chirp.times)).sum() / SAMPLING_RATE
        h_plus = local.predict([frequency], demonstration.ONE, options=MERGER_AT_ZERO).plus[0]
        assert abs(transform - h_plus) < 2e-3 * abs(h_plus)


def test_the_merger_is_at_zero_and_nothing_wraps_around(chirp):
    assert abs(chirp.times[np.argmax(np.abs(chirp.strain))]) < 2e-3
    quiet = (chirp.times < chirp.times[0] + 0.01) | (chirp.times > 0.04)
    assert np.abs(chirp.strain[quiet]).max() < 1e-3 * np.abs(chirp.strain).max()


def test_every_mode_is_there_with_what_it_counts(local, chirp):
    assert list(chirp.amplitudes) == local.description.modes
    for mode, amplitude in chirp.amplitudes.items():
        alone = local.predict(chirp.frequencies, demonstration.ONE, options=EvaluationOptions(modes=[mode]))
        np.testing.assert_allclose(amplitude, np.abs(alone.plus), rtol=1e-9)
    assert list(evaluate_chirp(local, demonstration.ONE, [(3, 3), (2, 2)]).amplitudes) == [(3, 3), (2, 2)]


@pytest.mark.parametrize("inclination", [0.0, 1.2, np.pi / 2.0])
@pytest.mark.parametrize("modes", [None, [(2, 2)], [(4, 3), (2, 1)]])
def test_it_is_drawn_from_every_direction(local, tmp_path, inclination, modes):
    """Face-on, modes of m other than 2 are not seen."""
    one = replace(demonstration.ONE, inclination=inclination)
    save_picture(tmp_path / "seen.png", evaluate_chirp(local, one, modes), local.description)
    assert imread(tmp_path / "seen.png").shape[0] > 1000


@pytest.mark.parametrize("frequency", [6.0, 20.0, 100.0, 1000.0])
def test_the_track_is_the_time_until_the_merger(local, chirp, frequency):
    assert chirp.seconds_from(frequency) == pytest.approx(
        local.time_until_merger(frequency, chirp.parameters), rel=1e-4
    )


def test_the_same_seed_gives_the_same_binaries_inside_the_model(local):
    batch = like_gw170817(500)
    assert batch.values.tobytes() == like_gw170817(500).values.tobytes()
    chirp_mass = batch["total_mass"] * (batch["mass_ratio"] / (1.0 + batch["mass_ratio"]) ** 2) ** 0.6
    assert np.ptp(chirp_mass) < 3e-3
    assert (local.predict_batch([100.0], batch).status == RowStatus.OK).all()


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        (["--output", "not-there/demo.png"], "not-there"),
        (["--output", "demo.wav"], ".png"),
        (["--binaries", "0"], "--binaries"),
        (["--modes", "2,2"], "such as 22,33"),
        (["--modes", "22,22"], "twice"),
    ],
)
def test_mistakes_are_explained_before_anything_starts(arguments, word):
    done = bnserve("demo", *arguments)
    assert (done.returncode, done.stdout) == (2, "")
    assert word in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("package", ["matplotlib", "bnserve_client"])
def test_a_missing_package_is_explained(package):
    code = (
        f"import sys; sys.modules['{package}'] = None\nfrom bnserve_service.cli import main; sys.exit(main(['demo']))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, env=os.environ)
    assert done.returncode == 2
    assert f"'{package}'" in done.stderr
    assert "pip install" in done.stderr
    assert "Traceback" not in done.stderr


def test_it_needs_nothing_of_training():
    absent = TRAINING - {"matplotlib"}
    code = f"import sys; sys.modules.update(dict.fromkeys({sorted(absent)}))\nimport bnserve_service.demo.demonstration"
    run_python(code)
