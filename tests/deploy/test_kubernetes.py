"""The Kubernetes manifests: valid without a cluster, and in agreement with the service that they run."""

import asyncio
import re
from pathlib import Path

import httpx
import kubernetes_validate
import pytest
import yaml

from bnserve_protocol import __version__
from bnserve_service import Settings, create_app
from bnserve_service.cli import build_parser
from tests.integration.dockerfile import instructions

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "deploy" / "kubernetes"
VERSIONS = ["1.30", kubernetes_validate.latest_version()]
"""The first that knows ``preStop.sleep`` without being asked to, and the newest whose schema is at hand."""


def documents(name):
    return [document for document in yaml.safe_load_all((FOLDER / name).read_text()) if document]


RESOURCES = yaml.safe_load((FOLDER / "kustomization.yaml").read_text())["resources"]
OBJECTS = {
    f"{document['kind']}/{document['metadata']['name']}": document for name in RESOURCES for document in documents(name)
}
POD = OBJECTS["Deployment/bnserve"]["spec"]["template"]
CONTAINER = POD["spec"]["containers"][0]
LABELS = POD["metadata"]["labels"]


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("name", OBJECTS)
def test_it_is_what_the_schema_asks_for(name, version):
    kubernetes_validate.validate(OBJECTS[name], version, strict=True)


def test_a_mistake_is_found():
    wrong = yaml.safe_load(yaml.safe_dump(OBJECTS["Deployment/bnserve"]))
    wrong["spec"]["template"]["spec"]["containers"][0]["readinesProbe"] = {}
    with pytest.raises(kubernetes_validate.ValidationError):
        kubernetes_validate.validate(wrong, VERSIONS[-1], strict=True)


def test_every_file_is_applied():
    others = {"kustomization.yaml", "prometheus-adapter-values.yaml"}
    assert {path.name for path in FOLDER.iterdir()} - others == set(RESOURCES)


def test_nothing_is_missing():
    assert {name.partition("/")[0] for name in OBJECTS} == {
        "Namespace", "Deployment", "Service", "PodDisruptionBudget", "HorizontalPodAutoscaler", "NetworkPolicy"
    }  # fmt: skip


def test_the_image_is_this_version():
    assert CONTAINER["image"] == f"bnserve:{__version__}"
    assert f"docker build -t bnserve:{__version__} ." in (FOLDER / "kustomization.yaml").read_text()


def test_the_command_line_is_understood_and_means_the_ports_that_are_named():
    options = build_parser().parse_args(["serve", *CONTAINER["args"]])
    ports = {port["name"]: port["containerPort"] for port in CONTAINER["ports"]}
    assert ports == {"http": options.port, "metrics": options.metrics_port}
    assert options.metrics_host == "0.0.0.0", "the Prometheus is in another pod"
    assert POD["metadata"]["annotations"]["prometheus.io/port"] == str(options.metrics_port)


def test_all_select_the_same_pods():
    deployment, budget = OBJECTS["Deployment/bnserve"], OBJECTS["PodDisruptionBudget/bnserve"]
    selections = [deployment["spec"]["selector"]["matchLabels"], budget["spec"]["selector"]["matchLabels"]]
    selections += [OBJECTS[f"Service/{name}"]["spec"]["selector"] for name in ("bnserve", "bnserve-replicas")]
    selections.append(OBJECTS["NetworkPolicy/bnserve"]["spec"]["podSelector"]["matchLabels"])
    assert all(selection == LABELS for selection in selections)


def test_all_name_ports_that_there_are():
    known = {port["name"] for port in CONTAINER["ports"]}
    services = [OBJECTS[f"Service/{name}"]["spec"] for name in ("bnserve", "bnserve-replicas")]
    rules = OBJECTS["NetworkPolicy/bnserve"]["spec"]["ingress"]
    named = [port["targetPort"] for service in services for port in service["ports"]]
    named += [port["port"] for rule in rules for port in rule["ports"]]
    named += [CONTAINER[f"{probe}Probe"]["httpGet"]["port"] for probe in ("startup", "readiness", "liveness")]
    assert set(named) == known


def test_the_probes_ask_paths_that_there_are():
    paths = {CONTAINER[f"{probe}Probe"]["httpGet"]["path"] for probe in ("startup", "readiness", "liveness")}
    assert paths == {"/v2/health/ready", "/v2/health/live"}

    async def statuses():
        transport = httpx.ASGITransport(create_app(Settings()))  # not started: alive, and not ready
        async with httpx.AsyncClient(transport=transport, base_url="http://pod") as client:
            return {path: (await client.get(path)).status_code for path in paths}

    assert asyncio.run(statuses()) == {"/v2/health/live": 200, "/v2/health/ready": 503}


def test_it_is_given_the_time_that_draining_takes():
    settings = Settings()
    pause = CONTAINER["lifecycle"]["preStop"]["sleep"]["seconds"]
    needed = pause + settings.drain_grace + settings.drain_timeout
    assert needed + 5.0 <= POD["spec"]["terminationGracePeriodSeconds"]


def test_a_hung_server_is_out_of_rotation_within_five_seconds():
    probe = CONTAINER["readinessProbe"]
    assert probe["periodSeconds"] * (probe["failureThreshold"] - 1) + probe["timeoutSeconds"] <= 5


def test_it_has_no_rights_that_it_does_not_need():
    image = dict(instructions((ROOT / "Dockerfile").read_text()))
    pod, own = POD["spec"]["securityContext"], CONTAINER["securityContext"]
    assert pod["runAsNonRoot"]
    assert f"{pod['runAsUser']}:{pod['runAsGroup']}" == image["USER"]
    assert own == {
        "allowPrivilegeEscalation": False, "readOnlyRootFilesystem": True, "capabilities": {"drop": ["ALL"]}
    }  # fmt: skip
    assert POD["spec"]["automountServiceAccountToken"] is False


def test_what_it_writes_lies_in_memory():
    places = {mount["mountPath"]: mount["name"] for mount in CONTAINER["volumeMounts"]}
    volumes = {volume["name"]: volume["emptyDir"]["medium"] for volume in POD["spec"]["volumes"]}
    assert set(places) == {"/dev/shm", "/tmp"}
    assert {volumes[name] for name in places.values()} == {"Memory"}


def test_the_autoscaler_follows_gauges_that_there_are():
    (rule,) = documents("prometheus-adapter-values.yaml")[0]["rules"]["custom"]
    exposed = create_app(Settings()).parts.metrics.exposition().decode()
    used = set(re.findall(r"\bbnserve_\w+", rule["seriesQuery"] + rule["metricsQuery"]))
    assert used == {"bnserve_queue_samples", "bnserve_queue_capacity_samples"}
    assert all(re.search(rf"^{name} ", exposed, re.MULTILINE) for name in used)
    scaled = OBJECTS["HorizontalPodAutoscaler/bnserve"]["spec"]
    assert scaled["metrics"][0]["pods"]["metric"]["name"] == rule["name"]["as"]
    assert scaled["scaleTargetRef"]["name"] == OBJECTS["Deployment/bnserve"]["metadata"]["name"]
    assert "replicas" not in OBJECTS["Deployment/bnserve"]["spec"]
