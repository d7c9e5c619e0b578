"""The commands that compare speeds: they run without any peer, say who is missing, and judge as their tables say."""

import ast
import json
import sys
from pathlib import Path

import pytest

from benchmarks.environments import find_python, install, install_commands
from benchmarks.growth.__main__ import main as growth
from benchmarks.growth.turning import cost_rises, memory_takes_over, saturates
from benchmarks.peers.__main__ import main as peers
from benchmarks.peers.candidates import candidates
from benchmarks.peers.worker import draw
from benchmarks.servers import bare_server
from benchmarks.serving.__main__ import main as serving
from benchmarks.serving.contestants import CONTESTANTS
from benchmarks.speed.__main__ import main as speed
from benchmarks.speed.bars import BARS, Bar
from benchmarks.speed.table import lines_of, verdict
from benchmarks.workers import Worker, WorkerFailed
from bnserve_service.bench.load import Target, round_trips
from bnserve_surrogate import Model, ParametersWithExtrinsic

ENTRIES = {entry.name: entry for f_min in (5.0, 15.0) for entry in candidates(f_min)}
SCRIPTS = sorted({entry.path for entry in ENTRIES.values()} | {each.script for each in CONTESTANTS})
ECHO = """
import json, sys
for line in sys.stdin:
    request = json.loads(line)
    if request["do"] == "end":
        sys.exit("had enough")
    answer = {"error": "cannot"} if request["do"] == "fail" else request
    print(json.dumps(answer), flush=True)
"""


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: path.name)
def test_every_script_says_how_to_install_what_it_needs(script):
    commands = install_commands(script)
    assert any("pip install" in command for command in commands)
    assert ast.get_docstring(ast.parse(script.read_text()))


def test_the_commands_of_a_script_are_run_in_its_environment(tmp_path):
    script = tmp_path / "peer.py"
    script.write_text('"""A peer.\n\nInstall:\n\n    mkdir -p $PEERS/one/bin\n    touch $PEERS/one/bin/python\n"""\n')
    assert install(script, "PEERS", tmp_path / "peers", tmp_path)
    assert find_python(tmp_path / "peers", "one") == tmp_path / "peers" / "one" / "bin" / "python"
    assert find_python(tmp_path / "peers", "two") is None
    assert find_python(None, "") == Path(sys.executable)


def test_an_installation_that_fails_stops_there(tmp_path, capsys):
    script = tmp_path / "peer.py"
    script.write_text('"""A peer.\n\nInstall:\n\n    false\n    touch $PEERS/never\n"""\n')
    assert not install(script, "PEERS", tmp_path, tmp_path)
    assert not (tmp_path / "never").exists()
    assert "peer.py" in capsys.readouterr().err


def test_a_worker_answers_fails_and_ends_with_its_last_words():
    with Worker([sys.executable, "-c", ECHO]) as worker:
        assert worker.ask("echo", points=3) == {"do": "echo", "points": 3}
        with pytest.raises(WorkerFailed, match="cannot"):
            worker.ask("fail")
        with pytest.raises(WorkerFailed, match="had enough"):
            worker.ask("end")


def test_the_binaries_of_all_peers_are_inside_our_box():
    model = Model.default()
    for seed in range(40):
        model.predict([20.0, 100.0], ParametersWithExtrinsic(**draw(seed)))


def test_the_floor_answers_as_many_bytes_as_asked():
    with bare_server([0, 5000]) as address:
        target = Target(address)
        seconds, body = round_trips(target, target.request("/5000", b"question", {}), 3)
    assert len(seconds) == 3
    assert len(body) == 5000


@pytest.mark.parametrize(
    ("unit", "value", "expected"),
    [
        ("us", 1.0, "goal"), ("us", 2.5, "must"), ("us", 4.0, "MISSED"), ("us", None, "not measured"),
        ("x", 4.0, "MISSED"), ("x", 6.0, "must"), ("x", 9.0, "goal"),
    ],
)  # fmt: skip
def test_a_value_is_judged_by_its_bars(unit, value, expected):
    bar = Bar("key", "what", 8 if unit == "x" else 2, 5 if unit == "x" else 3, unit)
    assert verdict(bar, value) == expected


def test_every_row_of_the_table_is_printed_measured_or_not():
    lines = lines_of(BARS, {"overhead": {"value": 25.0, "peers": {"mlgw_bns": 1000.0}}})
    assert len(lines) == 1 + len(BARS)
    assert "25.0 us" in lines[1]
    assert "mlgw_bns 1000.0 us (40.0x)" in lines[1]
    assert all("not measured" in line for line in lines[2:])


def rows(*costs):
    return [
        {"size": 10**k, "samples": 10**k, "seconds": cost * 10**k, "seconds_to_write": write * 10**k}
        for k, (cost, write) in enumerate(costs)
    ]


def test_memory_takes_over_where_writing_is_half_of_the_time_from_then_on():
    assert memory_takes_over(rows((9, 6), (4, 1), (2, 1.2), (3, 2))) == 100
    assert memory_takes_over(rows((9, 1), (4, 1), (2, 1.2), (3, 1))) is None


def test_cost_rises_from_where_a_sample_stays_dearer_than_the_cheapest():
    assert cost_rises(rows((9, 0), (2, 0), (2.5, 0), (4, 0), (5, 0))) == 1_000
    assert cost_rises(rows((9, 0), (2, 0), (4, 0), (2.1, 0))) is None


def test_a_server_is_saturated_where_more_clients_get_no_more():
    rates = [(1, 100.0), (2, 190.0), (4, 300.0), (8, 310.0)]
    assert saturates([{"size": size, "rows_per_second": rate} for size, rate in rates]) == 4


def test_model_servers_that_are_not_installed_are_named(tmp_path, capsys):
    assert serving(["litserve", "--short", "--serving", str(tmp_path)]) == 1
    assert "LitServe is not installed: see benchmarks/serving/litserve_server.py" in capsys.readouterr().out


@pytest.mark.slow
def test_without_peers_the_figure_has_us_alone_and_says_who_is_missing(tmp_path, capsys):
    arguments = ["--f-min", "15", "--peers", str(tmp_path), "--results", str(tmp_path), "--images", str(tmp_path)]
    assert peers([*arguments, "--short"]) == 0
    printed = capsys.readouterr().out
    assert "bnserve fast" in printed
    assert "TEOBResumSPA: not installed, see benchmarks/peers/teobresums_spa.py" in printed
    saved = json.loads((tmp_path / "from-15-hz-bnserve-fast.json").read_text())
    assert saved["per_point_seconds"] > 0.0
    assert (tmp_path / "speed_from_15_hz.png").read_bytes().startswith(b"\x89PNG")
    assert peers([*arguments, "--redraw"]) == 0
    assert "bnserve fast" in capsys.readouterr().out


@pytest.mark.slow
def test_growth_is_measured_drawn_and_written_into_a_page(tmp_path, capsys):
    page, image = tmp_path / "page.md", tmp_path / "growth.png"
    page.write_text("<!-- begin: growth -->\n<!-- end: growth -->\n")
    assert growth(["--short", "--page", str(page), "--image", str(image)]) == 0
    assert capsys.readouterr().out.strip() in page.read_text()
    assert image.read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
def test_the_speed_table_measures_what_it_can_and_its_status_says_so(tmp_path, capsys):
    status = speed(["--short", "--epochs", "2", "--json", "--peers", str(tmp_path)])
    found = json.loads(capsys.readouterr().out)
    assert set(found["reached"]) == {bar.key for bar in BARS}
    for key in ("overhead", "per_point", "batch_277", "first_waveform", "memory", "http_floor"):
        assert found["reached"][key] != "not measured"
    assert found["reached"]["http_one"] == found["reached"]["clients_32"] == "not measured"
    assert any("benchmarks/peers/mlgw_bns_0.py" in note for note in found["notes"])
    assert status == (1 if "MISSED" in found["reached"].values() else 3)
