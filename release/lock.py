"""The lock of the container: a bill of materials of it, and whether it is old or holds what is known to be vulnerable.

    python release/lock.py sbom > bnserve.cdx.json          # CycloneDX 1.6, for scanners and inventories
    python release/lock.py check                            # asks OSV for the advisories of PyPI
    python release/lock.py check --osv all.zip              # without network: the archive, fetched elsewhere

The second exits with 1 where something is to be done, and with 3 where it could not look. Needs ``packaging``.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
import time
import urllib.request
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from typing import Any

from packaging.version import InvalidVersion, Version

ROOT = Path(__file__).parents[1]
LOCKS = ("requirements.lock", "requirements-build.lock")
ROOMS = {
    "protocol": "bnserve-protocol", "model_store": "bnserve-store", "surrogate": "bnserve-surrogate",
    "inference": "bnserve-inference", "service": "bnserve-service",
}  # fmt: skip
"""What the image holds of ours, by folder."""
ADVISORIES = "https://osv-vulnerabilities.storage.googleapis.com/PyPI/all.zip"
MOST_DAYS = 90
"""Advisories come as often; a lock that nobody has renewed for longer has been forgotten."""
_PIN = re.compile(r"^([A-Za-z0-9._-]+)==([^\s;\\]+)(?:\s*;\s*([^\\]+?))?\s*\\?$")


@dataclass
class Pin:
    """One package of a lock."""

    name: str
    version: str
    marker: str = ""
    """Where it is installed; empty for everywhere."""
    hashes: list[str] = field(default_factory=list)
    """SHA-256 of its files."""
    asked_by: list[str] = field(default_factory=list)
    """The packages that depend on it."""

    @property
    def url(self) -> str:
        """Its package URL."""
        return f"pkg:pypi/{self.name}@{self.version}"


def read_lock(text: str) -> list[Pin]:
    """The packages of a lock that ``uv pip compile --generate-hashes`` wrote."""
    pins: list[Pin] = []
    for line in text.splitlines():
        found = _PIN.match(line)
        if found:
            pins.append(Pin(found[1].lower().replace("_", "-"), found[2], found[3] or ""))
        elif "--hash=sha256:" in line:
            pins[-1].hashes.append(line.partition("sha256:")[2].rstrip(" \\"))
        elif line.startswith("    #") and pins:
            named = line.replace("# via", "").strip(" #")
            pins[-1].asked_by += [named.partition(" ")[0]] if named and "(" not in named[:1] else []
    return pins


def bill_of_materials(pins: list[Pin], version: str) -> dict[str, Any]:
    """What the image of this version holds, as CycloneDX 1.6; without a time, so that the same lock gives the same."""
    ours = {name: f"pkg:pypi/{name}@{version}" for name in ROOMS.values()}
    urls = {name: [url] for name, url in ours.items()}
    for pin in pins:
        urls.setdefault(pin.name, []).append(pin.url)  # several, where they differ by interpreter
    asks: dict[str, set[str]] = {url: set() for found in urls.values() for url in found}
    for pin in pins:
        for url in (url for who in pin.asked_by for url in urls.get(who, [])):
            asks[url].add(pin.url)
    return {
        "$schema": "http://cyclonedx.org/schema/bom-1.6.schema.json",
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": {
            "component": {"type": "container", "bom-ref": "bnserve", "name": "bnserve", "version": version,
                          "licenses": [{"license": {"id": "MIT"}}]},
            "tools": {"components": [{"type": "application", "name": "release/lock.py", "version": version}]},
        },
        "components": [
            {"type": "library", "bom-ref": url, "name": name, "version": version, "purl": url,
             "licenses": [{"license": {"id": "MIT"}}]}
            for name, url in ours.items()
        ] + [_component(pin) for pin in pins],
        "dependencies": [
            {"ref": "bnserve", "dependsOn": sorted(ours.values())},
            *({"ref": url, "dependsOn": sorted(needed)} for url, needed in asks.items()),
        ],
    }  # fmt: skip


def _component(pin: Pin) -> dict[str, Any]:
    files = {
        "type": "distribution", "url": f"https://pypi.org/project/{pin.name}/{pin.version}/#files",
        "comment": "one of these files, by interpreter and processor" + (f"; where {pin.marker}" if pin.marker else ""),
        "hashes": [{"alg": "SHA-256", "content": digest} for digest in pin.hashes],
    }  # fmt: skip
    return {"type": "library", "bom-ref": pin.url, "name": pin.name, "version": pin.version, "purl": pin.url,
            "externalReferences": [files]}  # fmt: skip


def advisories_of(archive: zipfile.ZipFile, pins: list[Pin]) -> Iterator[str]:
    """A line for each advisory of OSV's archive that holds for one of the pins."""
    by_name = {re.sub(r"[-_.]+", "-", pin.name): pin for pin in pins}
    for name in archive.namelist():
        told = json.loads(archive.read(name)) if name.endswith(".json") else {}
        if told.get("withdrawn"):
            continue
        for affected in told.get("affected", []):
            package = affected.get("package", {})
            pin = by_name.get(re.sub(r"[-_.]+", "-", str(package.get("name", "")).lower()))
            if pin is not None and package.get("ecosystem") == "PyPI" and _holds(affected, pin.version):
                yield f"{pin.name} {pin.version}: {told['id']}: {told.get('summary') or told.get('details', '')[:200]}"


def _holds(affected: dict[str, Any], version: str) -> bool:
    if version in affected.get("versions", []):
        return True
    return any(
        _within(span.get("events", []), version) for span in affected.get("ranges", []) if span["type"] == "ECOSYSTEM"
    )


def _within(events: list[dict[str, str]], version: str) -> bool:
    """Whether the last event at or before a version says that it is affected."""
    inside, own = False, Version(version)
    for event in events:
        kind, at = next(iter(event.items()))
        try:
            reached = at == "0" or own > Version(at) or (own == Version(at) and kind != "last_affected")
        except InvalidVersion:
            continue
        if reached:
            inside = kind == "introduced"
    return inside


def days_old(lock: Path) -> float:
    """Since the lock was last changed: by git's account, or by that of the file."""
    said = subprocess.run(
        ["git", "log", "-1", "--format=%ct", "--", lock.name],
        cwd=lock.parent,
        capture_output=True,
        text=True,
        check=False,
    ).stdout.strip()
    return (time.time() - (float(said) if said else lock.stat().st_mtime)) / 86400


def check(osv: Path | None, folder: Path = ROOT) -> int:
    """Say what is to be done; 0 for nothing, 1 for something, 3 for not knowing."""
    code = 0
    pins = {name: read_lock((folder / name).read_text()) for name in LOCKS}
    for name, locked in pins.items():
        days = days_old(folder / name)
        print(f"{name}: {len(locked)} packages, renewed {days:.0f} days ago")
        if days > MOST_DAYS:
            print(f"  to do: renew it (CONTRIBUTING.md); {MOST_DAYS} days are enough")
            code = 1
    try:
        content = osv.read_bytes() if osv is not None else urllib.request.urlopen(ADVISORIES, timeout=60).read()
    except OSError as error:
        print(f"advisories: NOT CHECKED, {ADVISORIES if osv is None else osv} cannot be read: {error}")
        print("  to do: fetch it where there is a network, and give it with --osv")
        return code or 3
    with zipfile.ZipFile(BytesIO(content)) as archive:
        found = sorted(set(advisories_of(archive, [pin for locked in pins.values() for pin in locked])))
        print(f"advisories: {len(archive.namelist())} were looked at, {len(found)} hold")
    for line in found:
        print(f"  to do: {line}")
    return 1 if found else code


def main(arguments: list[str]) -> int:
    """Run one of the two commands."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("sbom", help="print the bill of materials")
    checking = commands.add_parser("check", help="look at age and advisories")
    checking.add_argument("--osv", type=Path, metavar="FILE", help=f"the archive of advisories ({ADVISORIES})")
    options = parser.parse_args(arguments)
    if options.command == "check":
        return check(options.osv)
    said = (ROOT / "protocol" / "bnserve_protocol" / "_version.py").read_text()
    version = said.split("__version__ =")[1].split('"')[1]
    print(json.dumps(bill_of_materials(read_lock((ROOT / LOCKS[0]).read_text()), version), indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
