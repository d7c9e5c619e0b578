"""``bnserve validate``: the mismatch of a model on waveforms of its generator that it never saw."""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any


def add_parser(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "validate",
        help="measure a model's mismatch on fresh waveforms",
        description="Generate fresh waveforms with the model's own generator and print the mismatch, maximised over "
        "time and phase, over the whole trained band.",
    )
    parser.add_argument("model", metavar="NAME[@VERSION]")
    parser.add_argument("--store", type=Path, action="append", metavar="DIR", help="searched before the shipped models")
    parser.add_argument(
        "--generator", metavar="MODULE:FUNCTION", help="of a model trained on a function of yours, which is imported"
    )
    parser.add_argument("--count", type=int, default=512, metavar="N", help="waveforms, uniform in the box (512)")
    parser.add_argument("--edges", type=int, default=0, metavar="N", help="waveforms on faces, edges, corners (0)")
    parser.add_argument("--seed", type=int, default=2024, metavar="N", help="of the fresh waveforms (2024)")
    parser.add_argument("--noise", default="ET-D", metavar="NAME", help="ET-D, aLIGO-design or flat (ET-D)")
    parser.add_argument("--total-mass", type=float, metavar="MSUN", help="of the binaries (the reference mass)")
    parser.add_argument("--f-min", type=float, metavar="HZ", help="lower end of the integral (the band's beginning)")
    parser.add_argument(
        "--work", type=Path, default=Path("runs"), metavar="DIR", help="where waveforms are kept (runs)"
    )
    parser.add_argument("--jobs", type=int, default=-1, metavar="N", help="processes at once (all cores)")
    parser.add_argument("--output", type=Path, metavar="FILE.json", help="also save the figures and every mismatch")
    parser.add_argument("--json", action="store_true", help="print the figures and every mismatch as one JSON object")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Validate, print, save."""
    from bnserve_protocol import require
    from bnserve_service.cli.places import check_place, name_and_version, print_json
    from bnserve_store import ModelStore

    fresh, report = (
        require(f"bnserve_surrogate.training.validation.{name}", "Training", "train") for name in ("fresh", "report")
    )
    if options.output:
        check_place(options.output, "--output")
    artifact = ModelStore.default(options.store or ()).load(*name_and_version(options.model))
    validations = fresh.validate_artifact(
        artifact,
        options.work,
        counts={"uniform": options.count, "edges": options.edges},
        seed=options.seed,
        noise=options.noise,
        total_mass=options.total_mass,
        f_min=options.f_min,
        n_jobs=options.jobs,
        own_function=options.generator,
    )
    figures = {kind: report.as_json(validation) for kind, validation in validations.items()}
    document = {"digest": artifact.manifest.digest, **figures}
    if options.json:
        print_json(document)
    else:
        print(f"{artifact.manifest.name} {artifact.manifest.version} ({artifact.manifest.digest})")
        print(report.table(validations))
    if options.output:
        report.write_text(options.output, json.dumps(document, indent=1))
        if not options.json:
            print(f"Saved {options.output}")
    return 0
