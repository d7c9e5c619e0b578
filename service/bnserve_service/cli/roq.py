"""``bnserve roq``: reduced-order quadratures: build, look at, validate and convert them."""

from __future__ import annotations

import argparse
import os
from functools import partial
from pathlib import Path
from typing import Any

BASIS_HELP = "a file that `bnserve roq build` wrote, or the name of a basis that comes with bnserve, as gw170817_fine"


def add_parser(subparsers: Any) -> None:
    """Add the subcommand and its own subcommands."""
    parser = subparsers.add_parser(
        "roq",
        help="build and convert reduced-order quadratures",
        description="A reduced-order quadrature tells at which few frequencies waveforms are enough for a likelihood.",
    )
    actions = parser.add_subparsers(title="actions", metavar="ACTION", required=True)
    _add_build(actions)
    _add_show(actions)
    _add_validate(actions)
    _add_export(actions)


def _add_build(actions: Any) -> None:
    build = actions.add_parser(
        "build",
        help="build a basis from a configuration",
        description="Build the linear and the quadratic basis of a configuration, validate them on fresh binaries and "
        "write the compact file, some hundred kilobytes. What is finished is kept: run the same command again after an "
        "interruption and it goes on, to the same result.",
    )
    build.add_argument("configuration", type=Path, metavar="CONFIG.toml")
    build.add_argument("--output", type=Path, metavar="FILE.h5", help="the basis (WORK/NAME.h5)")
    build.add_argument("--store", type=Path, action="append", metavar="DIR", help="searched before the shipped models")
    build.add_argument("--work", type=Path, default=Path("runs"), metavar="DIR", help="for checkpoints (runs)")
    build.add_argument("--jobs", type=int, default=-1, metavar="N", help="workers at once (all cores)")
    build.add_argument(
        "--backend", default="threading", metavar="NAME", help="joblib backend, or ray[:ADDRESS] (threading)"
    )
    build.add_argument("--no-progress", action="store_true", help="no progress bars")
    build.add_argument("--no-report", action="store_true", help="no page with plots (it needs matplotlib)")
    build.set_defaults(run=run_build)


def _add_show(actions: Any) -> None:
    show = actions.add_parser("show", help="describe a basis", description="Print what a basis holds.")
    show.add_argument("basis", metavar="BASIS", help=BASIS_HELP)
    show.add_argument("--json", action="store_true", help="print one JSON object")
    show.set_defaults(run=run_show)


def _add_validate(actions: Any) -> None:
    validate = actions.add_parser(
        "validate",
        help="measure a basis on fresh binaries",
        description="Interpolation errors, squared and relative, of fresh uniform draws from the basis' prior, summed "
        "over the full grid.",
    )
    validate.add_argument("basis", metavar="BASIS", help=BASIS_HELP)
    validate.add_argument("--count", type=int, default=64, metavar="N", help="binaries (64)")
    validate.add_argument("--seed", type=int, default=2024, metavar="N", help="of the draws (2024)")
    validate.add_argument(
        "--store", type=Path, action="append", metavar="DIR", help="model store, searched before the shipped models"
    )
    validate.add_argument("--json", action="store_true", help="print one JSON object")
    validate.set_defaults(run=run_validate)


def _add_export(actions: Any) -> None:
    export = actions.add_parser(
        "export",
        help="write a basis in the layout of another program",
        description="Tabulate a compact basis on its full grid: for bilby one *.hdf5 file, for bajes a directory. "
        "Either takes about a gigabyte for GW170817.",
    )
    export.add_argument("basis", metavar="BASIS", help=BASIS_HELP)
    export.add_argument("format", choices=("bilby", "bajes"))
    export.add_argument("output", type=Path, metavar="PATH")
    export.add_argument(
        "--store", type=Path, action="append", metavar="DIR", help="model store, searched before the shipped models"
    )
    export.set_defaults(run=run_export)


def run_build(options: argparse.Namespace) -> int:
    """Build, save, report."""
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):  # before numpy: the workers are many
        os.environ.setdefault(name, "1")
    from bnserve_inference.roq import build_basis, describe, read_roq_configuration, write_roq_report
    from bnserve_protocol import require
    from bnserve_service.cli.places import check_place

    if not options.no_report:
        require("matplotlib", "The report (or --no-report)", "roq")  # better missed now than at the end
    configuration = read_roq_configuration(options.configuration)
    output = options.output or options.work / f"{configuration.name}.h5"
    check_place(output, "--output")
    opener = partial(_open_model, configuration.model.name, configuration.model.version, options.store)
    built = build_basis(
        configuration,
        opener(),
        options.work,
        n_jobs=options.jobs,
        backend=options.backend,
        opener=opener,
        progress=False if options.no_progress else None,
    )
    built.quadrature.save(output)
    print(describe(built.quadrature))
    print(f"time        {sum(built.seconds.values()) / 60.0:.1f} minutes\nBasis: {output}")
    if not options.no_report:
        page = output.with_suffix(".html")
        write_roq_report(page, configuration.name, built, opener())
        print(f"Report: {page}")
    return 0


def run_show(options: argparse.Namespace) -> int:
    """Describe."""
    from bnserve_inference.roq import describe

    basis = _basis(options.basis)
    if not options.json:
        print(describe(basis))
        return 0
    from bnserve_service.cli.places import print_json

    names = ("model_name", "model_version", "model_digest", "f_min", "f_max", "duration", "alignment")
    known = {name: getattr(basis, name) for name in names} | {
        "frequencies": len(basis.grid),
        "prior": {name: [*map(float, bounds)] for name, bounds in basis.prior.items()},
        "linear_nodes": len(basis.linear_nodes),
        "quadratic_nodes": len(basis.quadratic_nodes),
        "diagnostics": basis.diagnostics,
    }
    print_json(known)
    return 0


def run_validate(options: argparse.Namespace) -> int:
    """Measure, print."""
    from bnserve_inference.roq import validate_basis
    from bnserve_service.cli.places import print_json

    basis = _basis(options.basis)
    model = _open_model(basis.model_name, basis.model_version, options.store)
    found = validate_basis(basis, model, options.count, options.seed)
    if options.json:
        print_json({term: {name: float(value) for name, value in figures.items()} for term, figures in found.items()})
        return 0
    for term, figures in found.items():
        print(f"{term:10}" + "".join(f"  {name} {value:.3g}" for name, value in figures.items()))
    return 0


def run_export(options: argparse.Namespace) -> int:
    """Convert."""
    from bnserve_inference.roq import save_bajes, save_bilby

    basis = _basis(options.basis)
    model = _open_model(basis.model_name, basis.model_version, options.store)
    save = {"bilby": save_bilby, "bajes": save_bajes}[options.format]
    save(options.output, basis, model)
    print(f"Wrote {options.output}")
    return 0


def _basis(given: str) -> Any:
    """A basis from its file, or by name one of those that come with the package; a file of that name comes first."""
    from bnserve_inference.roq import load_basis, load_shipped_basis, shipped_bases
    from bnserve_protocol import InvalidRequest

    if Path(given).exists():
        return load_basis(given)
    if given not in shipped_bases():
        known = ", ".join(shipped_bases())
        raise InvalidRequest(
            f"There is no file '{given}', and no basis of this name comes with bnserve: those are {known}. "
            "`bnserve roq build` makes one."
        )
    return load_shipped_basis(given)


def _open_model(name: str, version: str, stores: list[Path] | None) -> Any:
    from bnserve_store import ModelStore
    from bnserve_surrogate import Model

    return Model.load(name, version, store=ModelStore.default(stores or ()))
