"""``bnserve train``: from a configuration to a published model, resumable at any point."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any


def add_parser(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "train",
        help="train a model from a configuration and publish it",
        description="Generate waveforms, fit a surrogate, validate it on fresh waveforms and publish it. Finished "
        "waveforms are kept: run the same command again after an interruption and it goes on.",
    )
    parser.add_argument("configuration", type=Path, metavar="CONFIG.toml")
    parser.add_argument("--store", required=True, metavar="DIR", help="model store to publish to")
    parser.add_argument(
        "--work", type=Path, default=Path("runs"), metavar="DIR", help="where waveforms are kept (runs)"
    )
    parser.add_argument("--jobs", type=int, default=-1, metavar="N", help="processes at once (all cores)")
    parser.add_argument(
        "--backend", default="loky", metavar="NAME", help="joblib backend, or ray[:ADDRESS], a Ray cluster (loky)"
    )
    parser.add_argument("--version", metavar="VERSION", help="publish under this version instead of the configured")
    parser.add_argument(
        "--force", action="store_true", help="publish with the labels even if it is hardly better than the baseline"
    )
    parser.add_argument("--no-progress", action="store_true", help="no progress bars")
    parser.add_argument("--no-report", action="store_true", help="no page with plots (it needs matplotlib)")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Train and publish."""
    import msgspec

    from bnserve_protocol import require

    config, pipeline, publication, report = (
        require(f"bnserve_surrogate.training.{name}", "Training", "train")
        for name in ("config", "pipeline", "publication", "validation.report")
    )
    if not options.no_report:
        require("matplotlib", "The report (or --no-report)", "train")  # better missed now than at the end
    configuration = config.read_configuration(options.configuration)
    if options.version:
        configuration = msgspec.structs.replace(configuration, version=options.version)
    publication.check_publishable(configuration, options.store)
    trained = pipeline.train(
        configuration,
        options.work,
        n_jobs=options.jobs,
        backend=options.backend,
        progress=False if options.no_progress else None,
    )
    print(report.table(trained.validations))
    manifest = publication.publish(
        configuration, trained, options.store, with_report=not options.no_report, force=options.force
    )
    print(f"Published {manifest.name} {manifest.version} ({manifest.digest}) to {options.store}")
    if not options.no_report:
        print(f"Report: {Path(options.store) / manifest.name / manifest.version / report.REPORT_FILE}")
    return 0
