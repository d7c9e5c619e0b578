"""Prometheus' configuration, its alerts and Grafana's board: with Debian's Prometheus, asking a real server."""

import json
import os
import re
import shutil
import subprocess
import urllib.error
import urllib.parse
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest
import yaml
from grafana_foundation_sdk.cog.encoder import JSONEncoder
from grafana_foundation_sdk.models.dashboard import Dashboard

from bnserve_service import Settings, create_app
from docs import generate
from tests.integration.conftest import serving
from tests.integration.workers import serving_with, until
from tests.running_server import free_port, running
from tests.service.asking import GW170817, evaluate_json, question

ROOT = Path(__file__).parents[2]
PROMETHEUS = ROOT / "deploy" / "prometheus"
BOARD = json.loads((ROOT / "deploy" / "grafana" / "bnserve.json").read_text())
RULES = yaml.safe_load((PROMETHEUS / "bnserve.rules.yml").read_text())["groups"][0]["rules"]
CURL = question(GW170817, {"f_min": 20, "f_max": 2048, "delta_f": 4})


def promtool(*arguments: str, folder: Path) -> str:
    done = subprocess.run(["promtool", *arguments], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def queries() -> dict[str, str]:
    """What the panels of the board ask, by their titles."""
    return {
        f"{panel['title']} {target['refId']}": target["expr"]
        for panel in BOARD["panels"]
        for target in panel.get("targets", [])
    }


def filled_in(query: str) -> str:
    """A query of the board as Grafana sends it."""
    return query.replace("$__rate_interval", "1m").replace("$job", "bnserve").replace("$instance", ".*")


def names_in(query: str) -> set[str]:
    """The metrics that a query names: what is followed by a selector, as all of ours are."""
    return set(re.findall(r"\b([a-z_]+)\{", query))


def exposed_names() -> set[str]:
    """All names that a server may expose, those of histograms with what belongs to them; ``up`` is of Prometheus."""
    described = generate.metrics(create_app(Settings(), wait_for_models=False))
    ends = {"histogram": ("_bucket", "_sum", "_count")}
    return {name + end for name, about in described.items() for end in ("", *ends.get(about[0], ()))} | {"up"}


def test_the_configuration_is_one_and_its_rules_are_found():
    assert f"{len(RULES)} rules found" in promtool("check", "config", "prometheus.yml", folder=PROMETHEUS)


def test_each_alert_fires_when_it_should_and_not_else(tmp_path):
    shutil.copy(PROMETHEUS / "bnserve.rules.yml", tmp_path)
    cases = ROOT / "tests" / "deploy" / "bnserve.rules.test.yml"
    shutil.copy(cases, tmp_path)
    promtool("test", "rules", cases.name, folder=tmp_path)
    well, ill = yaml.safe_load(cases.read_text())["tests"]
    everything = {rule["alert"] for rule in RULES}
    assert {case["alertname"] for case in well["alert_rule_test"]} == everything
    assert {case["alertname"] for case in ill["alert_rule_test"] if case["exp_alerts"]} == everything


@pytest.mark.parametrize("query", [rule["expr"] for rule in RULES] + list(queries().values()))
def test_only_metrics_that_there_are_are_named(query):
    assert names_in(query) <= exposed_names()
    assert names_in(query), "each is of something"


def lost(said, known, place="") -> list[str]:
    """Where something that is said is not known."""
    if isinstance(said, dict):
        return [each for key, value in said.items() for each in lost(value, known.get(key), f"{place}/{key}")]
    if isinstance(said, list):
        return [each for number, value in enumerate(said) for each in lost(value, known[number], f"{place}/{number}")]
    return [] if said == known else [place]


def test_grafana_knows_all_that_the_board_says():
    """Its own model of a board leaves out what it does not know; the last query of a variable is the editor's own."""
    known = json.loads(JSONEncoder().encode(Dashboard.from_json(BOARD)))
    assert {place.rpartition("/")[2] for place in lost(BOARD, known)} <= {"definition"}


def test_every_selector_is_found_by_the_look_for_names():
    """Or a name without a selector would not be looked at."""
    known = exposed_names()
    for query in [rule["expr"] for rule in RULES] + list(queries().values()):
        without = re.sub(r'"[^"]*"', "", query)
        words = set(re.findall(r"\b[a-z_]+\b", without))
        assert {word for word in words if word in known or word.startswith("bnserve_")} == names_in(query)


@dataclass
class Prometheus:
    """A running Prometheus."""

    address: str

    def ask(self, path: str, **parameters: str) -> dict:
        query = urllib.parse.urlencode(parameters)
        with urllib.request.urlopen(f"{self.address}/api/v1/{path}?{query}", timeout=10) as answer:
            return json.load(answer)["data"]

    def firing(self) -> set[str]:
        return {alert["labels"]["alertname"] for alert in self.ask("alerts")["alerts"] if alert["state"] == "firing"}


@contextmanager
def asking(folder: Path, metrics_address: str) -> Iterator[Prometheus]:
    """Prometheus with what ships, but for whom it asks and how long it waits: once a second, and no patience."""
    configuration = yaml.safe_load((PROMETHEUS / "prometheus.yml").read_text())
    configuration["global"] = {"scrape_interval": "1s", "evaluation_interval": "1s"}
    target = urllib.parse.urlsplit(metrics_address).netloc
    configuration["scrape_configs"][0]["static_configs"][0]["targets"] = [target]
    (folder / "prometheus.yml").write_text(yaml.safe_dump(configuration))
    rules = (PROMETHEUS / "bnserve.rules.yml").read_text()
    (folder / "bnserve.rules.yml").write_text(re.sub(r"for: \d+[mh]", "for: 0s", rules))
    port = free_port()
    address = f"http://127.0.0.1:{port}"

    def ready() -> bool:
        try:
            with urllib.request.urlopen(f"{address}/-/ready", timeout=5) as answer:
                return answer.status == 200
        except OSError:
            return False

    command = ["prometheus", f"--config.file={folder / 'prometheus.yml'}", f"--storage.tsdb.path={folder / 'data'}",
               f"--web.listen-address=127.0.0.1:{port}"]  # fmt: skip
    with running(command, folder / "prometheus.log", ready, env=os.environ | {"GOMAXPROCS": "1"}):
        yield Prometheus(address)


def test_the_board_shows_what_a_server_does(tmp_path):
    with serving_with(tmp_path / "server.log", 2) as server, asking(tmp_path, server.metrics_address) as prometheus:

        def asked_and_counted() -> bool:
            assert evaluate_json(server.address, CURL, "default").status == 200
            return bool(prometheus.ask("query", query="rate(bnserve_rows_total[1m]) > 0")["result"])

        until(asked_and_counted, "two looks at the metrics with work in between")
        shown = {}
        for title, query in queries().items():
            shown[title] = prometheus.ask("query", query=filled_in(query))["result"]
        assert prometheus.firing() == set(), "nothing is wrong with this server"
    without = {title for title, found in shown.items() if not found}
    assert without <= {
        "Refusals A",
        "Withdrawn A",
        "Log-likelihoods each second A",
        "Log-likelihoods A",
        "Certificates A",
        "Tokens A",
    }, "what did not happen is not shown, all else is"


def test_alerts_fire_when_a_model_cannot_be_loaded_and_when_nobody_is_there(tmp_path):
    broken = tmp_path / "store" / "broken" / "1.0.0"
    broken.mkdir(parents=True)
    (broken / "manifest.json").write_text("{}")
    options = ["--store", str(tmp_path / "store"), "--metrics-port", "0"]
    with serving(tmp_path / "server.log", *options) as server:
        metrics = re.search(r"^bnserve metrics on (\S+)$", server.log.read_text(), re.MULTILINE)[1]
        with asking(tmp_path, metrics) as prometheus:
            until(lambda: prometheus.firing() == {"BnserveReloadFails"}, "a model that cannot be loaded is told")
            server.process.kill()
            until(lambda: prometheus.firing() >= {"BnserveDown", "BnserveNobodyReady"}, "nobody is there")
