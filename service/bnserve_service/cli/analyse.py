"""``bnserve analyse``: from strain to posterior."""

from __future__ import annotations

import argparse
import os
import signal
import sys
import time
from pathlib import Path
from types import FrameType
from typing import Any, NoReturn

_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
_QUIET = 10.0
"""Seconds between two lines of progress where nobody watches."""


def add_parser(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "analyse",
        help="from strain, or an injection, to a posterior",
        description="Read the data of an event, build the cheapest likelihood that is exact enough, sample it, and "
        "write the result as bilby's with a page of pictures. What is finished is kept: after an interruption, "
        "--resume goes on from there to the same result.",
    )
    add = parser.add_argument
    add("event", type=Path, metavar="EVENT.toml", help="what is analysed, and how")
    add("--output", type=Path, metavar="DIR", help="in place of the configuration's folder")
    add("--seed", type=int, metavar="N", help="of the sampler, in place of the configuration's")
    add("--particles", type=int, metavar="N", help="of each population of the sampler, in place of the configuration's")
    add("--resume", action="store_true", help="go on with the run that is in the folder")
    add("--force", action="store_true", help="throw away the run that is in the folder")
    add(
        "--check", action="store_true", help="read the data and build the likelihood, and say what is doubtful; no more"
    )
    add("--store", type=Path, action="append", metavar="DIR", help="model store, searched before the shipped models")
    add("--token", metavar="TOKEN", help="where a server wants one ($BNSERVE_TOKEN or $BNSERVE_TOKEN_FILE)")
    add("--json", action="store_true", help="print one JSON object in place of text")
    add("--no-progress", action="store_true", help="say nothing while sampling")
    add("--no-report", action="store_true", help="no page with pictures")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Analyse, or say why not."""
    for name in _THREADS:  # before numpy: batches are large enough for one thread to be busy
        os.environ.setdefault(name, "1")
    stopped = _Stopped()
    before = signal.signal(signal.SIGTERM, stopped)
    try:
        return _analyse(options)
    except KeyboardInterrupt:
        print(
            f"\nStopped. What is finished is kept: `bnserve analyse {options.event} --resume` goes on.", file=sys.stderr
        )
        return 128 + stopped.number
    finally:
        signal.signal(signal.SIGTERM, before or signal.SIG_DFL)


class _Stopped:
    """SIGTERM ends a run as SIGINT does; ``number`` is that of the one that came."""

    number = int(signal.SIGINT)

    def __call__(self, number: int, frame: FrameType | None) -> NoReturn:
        self.number = number
        raise KeyboardInterrupt


def _analyse(options: argparse.Namespace) -> int:
    from bnserve_protocol import InvalidRequest, require
    from bnserve_service.cli.places import open_model
    from bnserve_service.process.system import available_cpus

    purpose = "Analysing an event"
    require("bilby", purpose, "analyse")
    events, running, report = (
        require(f"bnserve_posterior.{name}", purpose, "analyse") for name in ("events", "running", "report")
    )
    if options.resume and options.force:
        raise InvalidRequest("--resume goes on with a run and --force throws it away: leave out one of the two.")
    event = events.changed_event(
        events.read_event(options.event), folder=options.output, seed=options.seed, particles=options.particles
    )
    model = open_model(
        event.model.name, options.store, url=event.model.url, token=options.token, purpose="A model of a server"
    )
    say = _silent if options.json else print
    with running.Folder(event.output, resume=options.resume, force=options.force) as folder:
        prepared = running.prepare(event, model, folder)
        for sentence in prepared.facts:
            say(sentence)
        for sentence in prepared.doubts:
            say(f"Doubtful: {sentence}")
        if options.check:
            return _checked(options, prepared)
        progress = None if options.no_progress else _Progress()
        outcome = running.run(prepared, folder, progress, threads=available_cpus())
        if progress is not None:
            progress.end()
        written = report.save_outcome(outcome, folder, page=not options.no_report)
    _print_outcome(options, running.describe(outcome), written)
    return 0


def _checked(options: argparse.Namespace, prepared: Any) -> int:
    from bnserve_service.cli.places import print_json

    found = prepared.try_likelihood()
    if options.json:
        print_json({"facts": prepared.facts, "doubts": prepared.doubts, **found})
        return 0
    print(
        f"Likelihood at {found['draws']} draws from the prior: {found['possible']} possible, largest ln L "
        f"{found['largest_log_likelihood']:.3f}, {found['microseconds']:.1f} us each."
    )
    return 0


def _print_outcome(options: argparse.Namespace, found: dict[str, Any], written: list[Path]) -> None:
    from bnserve_service.cli.places import print_json

    if options.json:
        print_json({**found, "written": [str(path) for path in written]})
        return
    each = zip(found["log_evidences"], found["log_evidence_errors"], strict=True)
    halves = ", ".join(f"{value:.3f} +- {error:.3f}" for value, error in each)
    print(
        f"ln of the evidence ratio   {found['log_evidence']:.3f} +- {found['log_evidence_error']:.3f}"
        f" (either half alone: {halves})\n"
        f"effective samples          {found['effective_samples']}\n"
        f"k-hat                      {found['k_hat']:.2f}\n"
        f"likelihoods                {found['likelihoods']}"
    )
    if (errors := found["calibration"]) is not None:
        print(
            f"calibration errors         {errors['draws']} draws a sample: ln of the evidence shifts by "
            f"{errors['shift']:.3f} +- {errors['shift_error']:.3f}, efficiency {errors['efficiency']:.4f}"
        )
    if (check := found["check"]) is not None:
        print(
            f"against the full grid      {check['samples']} samples: largest difference of ln L "
            f"{check['largest']:.2g}, ln of the evidence shifts by {check['shift']:.2g}, efficiency "
            f"{check['efficiency']:.4f}"
        )
    seconds = ", ".join(f"{name} {value}" for name, value in found["seconds"].items())
    print(f"seconds                    {seconds}; of the processor {found['processor_seconds']}")
    for path in written:
        print(f"Written: {path}")


class _Progress:
    """A line that is written over where somebody watches, and now and then one where not."""

    def __init__(self) -> None:
        self._watched, self._started, self._last = sys.stderr.isatty(), time.monotonic(), 0.0

    def __call__(self, progress: Any) -> None:
        now = time.monotonic() - self._started
        known = ""
        if progress.effective == progress.effective:  # not NaN
            known = f", ln Z {progress.log_evidence:.2f}, {progress.effective:.0f} effective samples"
        line = (
            f"{progress.stage}, step {progress.step}: power {progress.power:.3g}{known}, {progress.likelihoods} "
            f"likelihoods, {now:.0f} s"
        )
        if self._watched:
            print(f"\r\033[K{line}", end="", file=sys.stderr, flush=True)
        elif now - self._last > _QUIET or self._last == 0.0:
            self._last = now
            print(line, file=sys.stderr, flush=True)

    def end(self) -> None:
        """What comes next is on a line of its own."""
        if self._watched:
            print(file=sys.stderr)


def _silent(_: str) -> None:
    pass
