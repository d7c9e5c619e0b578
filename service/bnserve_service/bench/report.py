"""The tables of a measurement."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

Say = Callable[[str], None]
_UNITS = (("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9))


def duration(seconds: float) -> str:
    """A time with three digits or so, in the unit that suits it."""
    unit, size = next((each for each in _UNITS if seconds >= each[1]), _UNITS[-1])
    value = seconds / size
    return f"{value:,.0f} {unit}" if value >= 100 else f"{value:.1f} {unit}" if value >= 10 else f"{value:.2f} {unit}"


def print_report(document: dict[str, Any], say: Say) -> None:
    """Say everything that was measured, in tables."""
    setup = document["setup"]
    say(f"bnserve {setup['bnserve']}, {setup['model']}, {setup['where']}, Python {setup['python']}, {setup['machine']}")
    for part, write in _WRITERS.items():
        if document.get(part) is not None:
            say("")
            write(document[part], say)


def _single(found: dict[str, Any], say: Say) -> None:
    say("One waveform (h+ and hx, complex128; medians over parameters and shuffled epochs)")
    say(f"  fit  t = t_o + t_p N   overhead {duration(found['overhead_seconds'])}, "
        f"per point {1e9 * found['per_point_seconds']:.2f} ns")  # fmt: skip
    say(f"  {'points':>9}{'time':>11}{'fit':>11}")
    for points, seconds, fit in zip(found["points"], found["seconds"], found["fit_seconds"], strict=True):
        say(f"  {points:>9,}{duration(seconds):>11}{duration(fit):>11}")


def _breakdown(found: dict[str, Any], say: Say) -> None:
    say(f"Where the time of one waveform goes ({found['points']:,} points)")
    for name, seconds in found["parts"].items():
        say(f"  {name:<46}{duration(seconds):>10}{seconds / found['total']:>7.0%}")
    say(f"  {'total':<46}{duration(found['total']):>10}")
    if "new_grid" in found:
        say(f"  {'once for every new grid, besides':<46}{duration(found['new_grid']):>10}")


def _batches(found: list[dict[str, Any]], say: Say) -> None:
    say("Batches: time for each waveform, and waveforms per second")
    grids = sorted({each["points"] for each in found})
    rates = {(each["rows"], each["points"]): each["rows_per_second"] for each in found}
    say(f"  {'rows':>6}" + "".join(f"{f'{points:,} points':>24}" for points in grids))
    for rows in sorted({each["rows"] for each in found}):
        cells = [_batch_cell(rates.get((rows, points))) for points in grids]
        say(f"  {rows:>6,}" + "".join(f"{cell:>24}" for cell in cells))


def _batch_cell(rate: float | None) -> str:
    return "" if rate is None else f"{duration(1.0 / rate)}{rate:>11,.0f} / s"


def _concurrency(found: list[dict[str, Any]], say: Say) -> None:
    say(f"Clients that ask for one waveform after another ({found[0]['points']:,} points): waveforms per second")
    for each in found:
        say(f"  {each['clients']:>6,} clients{each['rows_per_second']:>12,.0f} / s")


def _threads(found: dict[str, Any], say: Say) -> None:
    say(f"{found['threads']} threads against one (batches of 256 x 1,000)")
    say(f"  {found['speedup']:.2f} times as many waveforms")


def _fresh(found: dict[str, Any], say: Say) -> None:
    say("A fresh process, from the start of its interpreter")
    say(f"  imports done after {duration(found['imported'])}, model loaded after {duration(found['loaded'])}, "
        f"first waveform after {duration(found['first_waveform'])}")  # fmt: skip


def _memory(found: dict[str, Any], say: Say) -> None:
    say(f"A server of the shipped models, after 100 single requests and a batch: {found['bytes'] / 1e6:.0f} MB")


_WRITERS: dict[str, Callable[[Any, Say], None]] = {
    "single": _single,
    "breakdown": _breakdown,
    "batches": _batches,
    "concurrency": _concurrency,
    "threads": _threads,
    "fresh_process": _fresh,
    "server_memory": _memory,
}
