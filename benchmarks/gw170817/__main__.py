"""The paper's analysis of GW170817 with three likelihoods, all evaluated by a service on this machine.

    pip install '.[benchmarks]'
    python -m benchmarks.gw170817

Data, prior and sampler are those of ``bnserve analyse examples/gw170817.toml``, but for three things, in which it
follows the paper: the signal is one of TEOBResumSPA itself, and not of the surrogate; detectors stand still; and the
likelihood is a reduced-order quadrature. Relative binning is sampled beside it, without calibration errors and with the
event's envelopes of them. All are held against the full grid, and that against TEOBResumSPA's. What is finished is kept
in ``--work``: the same command goes on where it was stopped. Prints a table in Markdown; ``result.json`` has all of it.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from msgspec.structs import replace

from benchmarks.gw170817 import comparing, setting
from benchmarks.gw170817.drawing import draw_corner
from benchmarks.servers import bnserve_server
from bnserve_client import Model
from bnserve_posterior.events import CalibrationSection, Event
from bnserve_posterior.priors import derived_parameters
from bnserve_posterior.running import Folder, Outcome, describe, prepare, run
from bnserve_protocol import BnserveError

KINDS = {
    "quadrature": "reduced-order quadrature",
    "binning": "relative binning",
    "calibration": "relative binning, calibration errors",
}
_LIKELIHOODS: dict[str, dict[str, Any]] = {
    "quadrature": {"kind": "roq", "basis": setting.BASIS},
    "binning": {"kind": "relative_binning"},
    "calibration": {"kind": "relative_binning"},
}


@dataclass(frozen=True)
class Sizes:
    """Of a run: particles and effective samples of the sampler, and samples for the full grid and for TEOBResumSPA."""

    particles: int
    effective: int
    checks: int
    generator_checks: int
    seed: int


def event_of(kind: str, work: Path, sizes: Sizes) -> Event:
    """The configuration of a run."""
    sampler = {"particles": sizes.particles, "effective": sizes.effective, "seed": sizes.seed}
    event = setting.paper_event(
        work / kind, likelihood=_LIKELIHOODS[kind], sampler=sampler, output={"checks": sizes.checks}
    )
    if kind != "calibration":
        return event
    files = {name: str(setting.DATA / f"{name}_CalEnv.txt") for name in event.detectors}
    detectors = {name: replace(one, calibration=files[name]) for name, one in event.detectors.items()}
    # bajes, whose files these are, multiplies the template with them.
    return replace(event, detectors=detectors, calibration=CalibrationSection(correction="template"))


def analysed(event: Event, model: Any) -> tuple[Outcome, dict[str, Any]]:
    """A finished run, and what is said of it; seconds are those of the process that sampled."""
    with Folder(event.output, resume=True) as folder:
        prepared = prepare(event, model, folder, signals=setting.effective_one_body())
        outcome = run(prepared, folder)
        kept = folder.path / "summary.json"
        if not kept.exists():
            found = describe(outcome) | {"load": os.getloadavg()[1], "tails": comparing.tails(outcome.samples)}
            kept.write_text(json.dumps(found))
        # Points for other benchmarks, as likelihoods take them.
        np.savez(folder.path / "draws.npz", allow_pickle=False, values=outcome.samples.whole.values[:1000])
    return outcome, json.loads(kept.read_text())


def apart(posteriors: dict[str, dict[str, Any]]) -> dict[str, tuple[str, float]]:
    """Of each posterior to the first: the marginal distribution that differs most, and its divergence."""
    (_, first), *others = posteriors.items()
    found = {}
    for name, other in others:
        each = comparing.divergences(first, other)
        worst = max(each, key=lambda one: each[one])
        found[name] = worst.partition("\n")[0].partition(" [")[0], each[worst]
    return found


def table(found: dict[str, dict[str, Any]]) -> str:
    """A row for each figure, a column for each likelihood."""

    def pair(value: float, error: float) -> str:
        return f"{value:.3f} +- {error:.3f}"

    def halves(one: dict[str, Any]) -> str:
        return ", ".join(pair(*each) for each in zip(one["log_evidences"], one["log_evidence_errors"], strict=True))

    rows = {
        "seconds of sampling, wall clock": lambda one: f"{one['seconds']['sampling']:.0f}",
        "seconds of the sampler's processor, checks included": lambda one: f"{one['processor_seconds']:.0f}",
        "load average": lambda one: f"{one['load']:.0f}",
        "likelihoods": lambda one: f"{one['likelihoods']:,}",
        "ln of the evidence ratio": lambda one: pair(one["log_evidence"], one["log_evidence_error"]),
        "the same by either half": halves,
        "k-hat": lambda one: f"{one['k_hat']:.2f}",
        "effective samples": lambda one: f"{one['effective_samples']:,}",
        "largest ln L": lambda one: f"{one['largest_log_likelihood']:.3f}",
        "part with abs(chi_1) > 0.2": lambda one: f"{one['tails']['abs(chi_1) > 0.2']:.3f}",
        "part with masses of a ratio above 2": lambda one: f"{one['tails']['heavier over lighter mass > 2']:.3f}",
        "calibration errors: shift of ln evidence": lambda one: (
            pair(one["calibration"]["shift"], one["calibration"]["shift_error"]) if one["calibration"] else ""
        ),
        "full grid: largest, median difference of ln L": lambda one: (
            f"{one['check']['largest']:.5f}, {one['check']['median']:.5f} of {one['check']['samples']}"
        ),
        "full grid: shift of ln evidence, efficiency": lambda one: (
            f"{one['check']['shift']:.5f}, {one['check']['efficiency']:.4f}"
        ),
    }
    lines = [f"| | {' | '.join(KINDS[kind] for kind in found)} |", f"|---|{'---|' * len(found)}"]
    lines += [f"| {name} | {' | '.join(map(cell, found.values()))} |" for name, cell in rows.items()]
    return "\n".join(lines)


def arguments() -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=Path, default=Path("runs/gw170817_paper"), help="checkpoints and results")
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS), help="the likelihoods to sample")
    parser.add_argument("--particles", type=int, default=3000, help="of each population of the sampler (3000)")
    parser.add_argument("--effective", type=int, default=10_000, help="effective samples (10000)")
    parser.add_argument("--seed", type=int, default=1, help="of the sampler (1)")
    parser.add_argument("--url", help="a running service; without it one is started")
    parser.add_argument("--checks", type=int, default=1000, help="samples for the full grid (1000)")
    parser.add_argument("--generator-checks", type=int, default=200, help="samples for TEOBResumSPA (200); 0: none")
    parser.add_argument("--figure", type=Path, help="write the corner plot here")
    return parser.parse_args()


def main() -> int:
    """Sample, check and print."""
    options = arguments()
    sizes = Sizes(options.particles, options.effective, options.checks, options.generator_checks, options.seed)
    try:
        return compare(options, sizes)
    except BnserveError as error:
        print(f"{error.title}: {error}", file=sys.stderr)
        return 1


def compare(options: argparse.Namespace, sizes: Sizes) -> int:
    """As :func:`main`; raises ``BnserveError``."""
    outcomes: dict[str, Outcome] = {}
    found: dict[str, Any] = {}
    with ExitStack() as stack:
        url = options.url or stack.enter_context(bnserve_server())[0]
        model = stack.enter_context(Model.connect(url))
        for kind in options.kinds:
            outcomes[kind], found[kind] = analysed(event_of(kind, options.work, sizes), model)
        first = outcomes[options.kinds[0]]
        generator = (
            comparing.with_the_generator(first, model, sizes.generator_checks) if sizes.generator_checks else None
        )
    posteriors = {KINDS[kind]: comparing.shown(outcome.samples.values) for kind, outcome in outcomes.items()}
    print(table(found))
    result: dict[str, Any] = {"runs": found}
    if generator is not None:
        print(
            f"\nTEOBResumSPA itself, full grid, at {generator.samples} samples: largest and median difference of ln L "
            f"{generator.largest:.4f}, {generator.median:.4f}; shift of ln evidence {generator.shift:.4f}, efficiency "
            f"{generator.efficiency:.4f}."
        )
        result["generator"] = generator._asdict()
    result["divergences"] = apart(posteriors)
    for name, (parameter, value) in result["divergences"].items():
        print(
            f"Largest divergence of a marginal distribution to the first, {name}: {value:.5f} nats, of the {parameter}."
        )
    if options.figure:
        injection = {name: np.array([value]) for name, value in (first.prepared.data.injection or {}).items()}
        truth = comparing.shown(derived_parameters(injection))
        draw_corner(posteriors, {name: float(value[0]) for name, value in truth.items()}, options.figure)
    (options.work / "result.json").write_text(json.dumps(result, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
