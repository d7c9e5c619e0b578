"""The Kubernetes manifests: valid without a cluster, and in agreement with the service that they run."""

import asyncio
import re
import shutil
import subprocess
from pathlib import Path

import httpx
import kubernetes_validate
import pytest
import yaml

from bnserve_protocol import __version__
from bnserve_service import Settings, create_app
from bnserve_service.cli import build_parser
from bnserve_service.reference.openapi import openapi_document
from tests.integration.dockerfile import instructions

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "deploy" / "kubernetes"
VERSIONS = ["1.30", kubernetes_validate.latest_version()]
"""The first that knows ``preStop.sleep`` without being asked to, and the newest whose schema is at hand."""


def documents(name):
    return [document for document in yaml.safe_load_all((FOLDER / name).read_text()) if document]


def objects_of(names):
    return {
        f"{document['kind']}/{document['metadata']['name']}": document for name in names for document in documents(name)
    }


RESOURCES = yaml.safe_load((FOLDER / "kustomization.yaml").read_text())["resources"]
OBJECTS = objects_of(RESOURCES)
COMPONENTS = {path.parent.name for path in FOLDER.glob("*/kustomization.yaml")}
ADDED = {
    name: objects_of(
        f"{name}/{file}"
        for file in yaml.safe_load((FOLDER / name / "kustomization.yaml").read_text()).get("resources", [])
    )
    for name in COMPONENTS
}
"""By component: what it adds to the objects."""
POD = OBJECTS["Deployment/bnserve"]["spec"]["template"]
CONTAINER = POD["spec"]["containers"][0]
LABELS = POD["metadata"]["labels"]


OF_KUBERNETES = {
    name: document
    for name, document in (OBJECTS | ADDED["ingress"] | ADDED["monitoring"]).items()
    if document["kind"] != "ServiceMonitor"  # of an operator, which brings its schema
}


@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("name", OF_KUBERNETES)
def test_it_is_what_the_schema_asks_for(name, version):
    kubernetes_validate.validate(OF_KUBERNETES[name], version, strict=True)


def test_a_mistake_is_found():
    wrong = yaml.safe_load(yaml.safe_dump(OBJECTS["Deployment/bnserve"]))
    wrong["spec"]["template"]["spec"]["containers"][0]["readinesProbe"] = {}
    with pytest.raises(kubernetes_validate.ValidationError):
        kubernetes_validate.validate(wrong, VERSIONS[-1], strict=True)


def test_every_file_is_applied():
    assert {path.name for path in FOLDER.glob("*.yaml")} - {"kustomization.yaml"} == set(RESOURCES)
    text = (FOLDER / "kustomization.yaml").read_text()
    assert set(re.findall(r"^#   - (\w+)", text, re.MULTILINE)) == COMPONENTS, "each is offered there"


@pytest.fixture(scope="module")
def with_components(tmp_path_factory):
    """All objects as kubectl would apply them, with every component that is offered."""
    kubectl = shutil.which("kubectl")
    if kubectl is None:
        pytest.skip("kubectl is not installed, and Debian's is too old to know components")
    folder = tmp_path_factory.mktemp("kubernetes") / "bnserve"
    shutil.copytree(FOLDER, folder)
    file = folder / "kustomization.yaml"
    file.write_text(re.sub(r"^# (components:|  - )", r"\1", file.read_text(), flags=re.MULTILINE))
    done = subprocess.run([kubectl, "kustomize", str(folder)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found = [document for document in yaml.safe_load_all(done.stdout) if document]
    return {f"{document['kind']}/{document['metadata']['name']}": document for document in found}


def test_components_go_together(with_components):
    assert set(with_components) == set(OBJECTS) | set(ADDED["ingress"]) | set(ADDED["monitoring"])
    assert {document["metadata"].get("namespace", "bnserve") for document in with_components.values()} == {"bnserve"}
    scaled, default = with_components["HorizontalPodAutoscaler/bnserve"], OBJECTS["HorizontalPodAutoscaler/bnserve"]
    kubernetes_validate.validate(scaled, VERSIONS[-1], strict=True)
    assert scaled["spec"]["metrics"][:-1] == default["spec"]["metrics"], "the queue comes beside the processors"
    assert scaled["spec"]["behavior"] == default["spec"]["behavior"]


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


def test_the_autoscaler_needs_nothing_that_not_every_cluster_has():
    scaled = OBJECTS["HorizontalPodAutoscaler/bnserve"]["spec"]
    assert [metric["type"] for metric in scaled["metrics"]] == ["Resource"], "one that is missing keeps every pod"
    assert scaled["scaleTargetRef"]["name"] == OBJECTS["Deployment/bnserve"]["metadata"]["name"]
    assert CONTAINER["resources"]["requests"]["cpu"], "utilisation is a part of what was asked for"
    assert "replicas" not in OBJECTS["Deployment/bnserve"]["spec"]


def test_the_queue_that_the_autoscaler_may_follow_is_made_of_gauges_that_there_are():
    (rule,) = documents("queue/prometheus-adapter-values.yaml")[0]["rules"]["custom"]
    exposed = create_app(Settings()).parts.metrics.exposition().decode()
    used = set(re.findall(r"\bbnserve_\w+", rule["seriesQuery"] + rule["metricsQuery"]))
    assert used == {"bnserve_queue_samples", "bnserve_queue_capacity_samples"}
    assert all(re.search(rf"^{name} ", exposed, re.MULTILINE) for name in used)
    followed = documents("queue/horizontalpodautoscaler.yaml")[0]["spec"]["metrics"][-1]
    assert followed["pods"]["metric"]["name"] == rule["name"]["as"]


def test_from_outside_callers_reach_what_they_use_and_operators_nothing():
    (ingress,) = documents("ingress/ingress.yaml")
    (rule,) = ingress["spec"]["rules"]
    assert ingress["spec"]["tls"][0]["hosts"] == [rule["host"]]
    paths = rule["http"]["paths"]
    backends = [path["backend"]["service"] for path in paths]
    service = OBJECTS["Service/bnserve"]
    assert all(backend["name"] == service["metadata"]["name"] for backend in backends)
    assert {backend["port"]["name"] for backend in backends} == {port["name"] for port in service["spec"]["ports"]}
    exact = {path["path"] for path in paths if path["pathType"] == "Exact"}
    below = tuple(path["path"] for path in paths if path["pathType"] == "Prefix")
    app = create_app(Settings())
    operations = {path: kind.operation for kind in app.parts.kinds for path in kind.paths}
    offered = set(openapi_document(app, operations, with_tokens=False)["paths"])
    passed = {path for path in offered if path in exact or path.startswith(below)}
    assert offered - passed == {"/metrics", "/v1/reload"}
    size = int(ingress["metadata"]["annotations"]["nginx.ingress.kubernetes.io/proxy-body-size"].removesuffix("m"))
    assert size * 2**20 >= Settings().max_analysis_bytes
    (policy,) = documents("ingress/networkpolicy.yaml")
    assert policy["spec"]["podSelector"]["matchLabels"] == LABELS


def test_the_operator_of_prometheus_finds_every_pods_metrics_once(with_components):
    (monitor,) = documents("monitoring/servicemonitor.yaml")
    services = [document for document in with_components.values() if document["kind"] == "Service"]
    wanted = monitor["spec"]["selector"]["matchLabels"].items()
    (found,) = [service for service in services if wanted <= service["metadata"]["labels"].items()]
    (endpoint,) = monitor["spec"]["endpoints"]
    (port,) = found["spec"]["ports"]
    assert (endpoint["port"], port["targetPort"]) == (port["name"], "metrics")
    assert found["spec"]["selector"] == LABELS
    assert found["metadata"]["labels"][monitor["spec"]["jobLabel"]] == "bnserve", "the job of the rules of alerts"
