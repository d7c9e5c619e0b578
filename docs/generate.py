"""The pages of reference that are made from the code: settings, metrics, commands, errors, HTTP; and `bnserve.toml`.

    python docs/generate.py            # writes them
    python docs/generate.py --check    # says which are not what the code says; exit status 1

The reference of Python is made when the site is built (``docs/hooks.py``), from the docstrings.
"""

from __future__ import annotations

import argparse
import ast
import inspect
import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from prometheus_client.registry import Collector

import bnserve_protocol
from bnserve_service import Settings, create_app
from bnserve_service.app import Application
from bnserve_service.cli import build_parser
from bnserve_service.errors import status_of
from bnserve_service.reference.openapi import openapi_document
from bnserve_service.workers import pool

sys.path.insert(0, str(Path(__file__).parent))  # wherever this is run from

from rooms import ROOMS  # as above
from settings_pages import HEAD, sample, settings_page, table  # as above

ROOT = Path(__file__).parents[1]
REFERENCE = Path("docs/reference")
SAMPLE = Path("examples/bnserve.toml")


def pages() -> dict[Path, str]:
    """Every page that is made from the code, by its path in the repository."""
    app = create_app(Settings(), wait_for_models=False)
    made = {
        "settings": settings_page(),
        "metrics": metrics_page(app),
        "commands": commands_page(),
        "errors": errors_page(),
        "http": http_page(app),
    }
    return {REFERENCE / f"{name}.md": text for name, text in made.items()} | {SAMPLE: sample()}


# Metrics


def metrics(app: Application) -> dict[str, tuple[str, str, str]]:
    """Kind, labels and description of every metric of a server, by the name that Prometheus shows."""
    registry = app.parts.metrics.registry
    collectors: list[Collector] = list(registry._collector_to_names)
    found = {}
    for collector in collectors:
        labels = ", ".join(f"`{label}`" for label in getattr(collector, "_labelnames", ()))
        for family in getattr(collector, "describe", collector.collect)() or collector.collect():
            found[_shown(family.name, family.type)] = (family.type, labels, family.documentation)
    for call in ast.walk(ast.parse(inspect.getsource(pool))):
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id == "_family":
            name, kind, text = (argument.value for argument in call.args[:3])
            found[_shown(name, kind)] = (kind, "`reason`" if kind == "counter" else "", text)
    return dict(sorted(found.items()))


def _shown(name: str, kind: str) -> str:
    return name + {"counter": "_total", "info": "_info"}.get(kind, "")


def metrics_page(app: Application) -> str:
    """Every metric."""
    rows = [(f"`{name}`", *described) for name, described in metrics(app).items()]
    return f"""# Metrics

{HEAD}

Of `/metrics`. A histogram has `_bucket`, `_sum`, `_count` and `_created`; a counter has `_created`, too. How those of
several workers become one, and what is worth an alert, is in [Operate it](../guides/operations.md#metrics).
`bnserve_workers_serving` and `bnserve_worker_restarts_total` are there with several workers.

{table("Metric | Kind | Labels | What it says", rows)}"""


# Commands


def commands() -> Iterator[tuple[str, argparse.ArgumentParser]]:
    """Every command and its parser, actions of commands included."""

    def below(parser: argparse.ArgumentParser) -> Iterator[tuple[str, argparse.ArgumentParser]]:
        yield parser.prog, parser
        for action in parser._actions:
            if isinstance(action, argparse._SubParsersAction):
                for child in action.choices.values():
                    yield from below(child)

    return below(build_parser())


def _option(action: argparse.Action) -> str:
    names = ", ".join(action.option_strings)
    choices = "{" + ",".join(map(str, action.choices)) + "}" if action.choices is not None else ""
    value = "" if action.nargs == 0 else action.metavar or choices or (names and action.dest.upper()) or action.dest
    return " ".join(f"`{word}`" for word in (names, value) if word)


def commands_page() -> str:
    """Every command with all its options."""
    parts = [f"# Commands\n\n{HEAD}\n\nWhat went wrong is one sentence on standard error, with exit status 2.\n"]
    for name, parser in commands():
        shown = [
            action for action in parser._actions
            if not isinstance(action, argparse._HelpAction | argparse._SubParsersAction | argparse._VersionAction)
            and action.help is not argparse.SUPPRESS
        ]  # fmt: skip
        text = re.sub(r"^`[^`]*`: ", "", _prose(parser.description or ""))
        parts.append(f"## {name}\n\n{text[:1].upper()}{text[1:]}\n")
        if shown:
            rows = [(_option(action), (action.help or "") % (vars(action) | {"prog": name})) for action in shown]
            parts.append(table("Option | What it does", rows))
    return "\n".join(parts).rstrip() + "\n"


def _prose(text: str) -> str:
    return text.replace("``", "`").strip()


# Errors


def errors() -> Iterator[tuple[str, ast.ClassDef]]:
    """Code and definition of every error of all rooms, wherever it is; those of the protocol first."""
    rooms = sorted(ROOMS, key="protocol".__ne__)
    for file in [file for room in rooms for file in sorted((ROOT / room).glob("bnserve_*/**/*.py"))]:
        for node in ast.walk(ast.parse(file.read_text())):
            if isinstance(node, ast.ClassDef):
                code = re.search(r"^    code(?:: ClassVar\[str\])? = '([a-z-]+)'$", ast.unparse(node), re.MULTILINE)
                if code:
                    yield code[1], node


NEVER_SAID = (
    bnserve_protocol.ArtifactError, bnserve_protocol.ConnectionFailed, bnserve_protocol.PackageMissing,
    bnserve_protocol.UntrustedAnswer,
)  # fmt: skip
"""Errors of the protocol that no server answers with."""


def errors_page() -> str:
    """Every error with its code."""
    rows = []
    for code, node in errors():
        known = getattr(bnserve_protocol, node.name, None)
        is_said = known is not None and not issubclass(known, NEVER_SAID)
        meaning = (ast.get_docstring(node) or "").partition("\n\n")[0]
        parents = ", ".join(f"`{ast.unparse(base).rpartition('.')[2]}`" for base in node.bases)
        again = _yes(known is not None and known.retryable)
        rows.append(
            (f"`{code}`", str(status_of(known(""))) if is_said else "", f"`{node.name}`", parents, again, meaning)
        )
    return f"""# Errors

{HEAD}

All derive from `BnserveError`. Those with a status a server answers with ([how](wire.md#errors)); they are in
`bnserve_protocol`, and local and remote models raise the same ones. Those without are raised where you are: by the
client, by model stores, by `bnserve_inference.roq`, by
`bnserve_posterior`, by training and by the commands.

{table("Code | Status | Class | Is also a | Ask again? | Meaning", rows)}"""


def _yes(value: bool) -> str:
    return "yes" if value else ""


# HTTP


def http_page(app: Application) -> str:
    """Every path, and the fields of all that travels."""
    operations = {path: kind.operation for kind in app.parts.kinds for path in kind.paths}
    document = openapi_document(app, operations, with_tokens=True)
    parts = [
        f"# HTTP\n\n{HEAD}\n\nFrom the OpenAPI document, which a server has under `/openapi.json` and draws under "
        "`/docs`. [On the wire](wire.md) says it in words.\n"
    ]
    for path, item in sorted(document["paths"].items()):
        for method, operation in item.items():
            parts.append(f"## {method.upper()} `{path}`\n\n{_sentence(operation)}\n")
            parts += _asked(operation)
            rows = [
                (status, answer["description"], _content(answer))
                for status, answer in sorted(operation["responses"].items(), key=lambda item: str(item[0]))
            ]
            parts.append(table("Status | Meaning | Body", rows))
    parts.append("# What travels\n")
    for name, schema in sorted(document["components"]["schemas"].items()):
        parts.append(f"## {name}\n\n{_prose(schema.get('description', ''))}\n")
        rows = [
            (f"`{field}`", _form(form), _yes(field in schema.get("required", ())), form.get("description", ""))
            for field, form in schema.get("properties", {}).items()
        ]
        parts.append(table("Field | Form | Must be there | What it is", rows) if rows else f"{_form(schema)}\n")
    return "\n".join(parts).rstrip().replace("\n\n\n", "\n\n") + "\n"


def _sentence(operation: dict[str, Any]) -> str:
    return _prose(operation.get("description") or operation.get("summary", "")).rstrip(".") + "."


def _asked(operation: dict[str, Any]) -> list[str]:
    """The parameters and the body of a request."""
    parts = []
    rows = [
        (f"`{item['name']}`", item["in"], _form(item["schema"]), item.get("description", ""))
        for item in operation.get("parameters", ())
    ]
    if rows:
        parts.append(table("Parameter | Where | Form | What it is", rows))
    body = operation.get("requestBody")
    if body:
        parts.append(f"The body is {_content(body)}. {body.get('description', '')}".strip() + "\n")
    return parts


def _content(answer: dict[str, Any]) -> str:
    content = answer.get("content", {})
    forms = dict.fromkeys(_form(item["schema"]) for item in content.values())
    return f"{' or '.join(forms)}, as {' or '.join(f'`{kind}`' for kind in content)}" if content else ""


def _form(schema: dict[str, Any]) -> str:
    """A schema in a few words."""
    if "$ref" in schema:
        name = schema["$ref"].rpartition("/")[2]
        return f"[{name}](#{name.lower()})"
    for key in ("oneOf", "anyOf", "allOf"):
        if key in schema:
            return " or ".join(dict.fromkeys(map(_form, schema[key])))
    if "enum" in schema:
        return " or ".join(f"`{value}`" for value in schema["enum"])
    if "const" in schema:
        return f"`{json.dumps(schema['const'])}`"
    kind = schema.get("type", "anything")
    if isinstance(kind, list):
        return " or ".join(kind)
    if kind == "array" and isinstance(schema.get("items"), dict):
        return f"list of {_form(schema['items'])}"
    if kind == "object" and isinstance(schema.get("additionalProperties"), dict):
        return f"map to {_form(schema['additionalProperties'])}"
    if kind == "object" and schema.get("properties"):
        return "`{" + ", ".join(schema["properties"]) + "}`"
    return {"string": "bytes" if schema.get("format") == "binary" else "text"}.get(kind, kind)


def main() -> int:
    """Write the pages, or say which are not what the code says."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--check", action="store_true", help="write nothing")
    check = parser.parse_args().check
    stale = []
    for path, text in pages().items():
        file = ROOT / path
        if not file.exists() or file.read_text() != text:
            stale.append(str(path))
            if not check:
                file.write_text(text)
    if stale:
        print(f"{'Stale' if check else 'Written'}: {', '.join(stale)}")
    return int(check and bool(stale))


if __name__ == "__main__":
    sys.exit(main())
