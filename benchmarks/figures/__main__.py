"""``python -m benchmarks.figures``: draw the figures and write their numbers beside them."""

from __future__ import annotations

import argparse
import importlib
import sys
import time
from importlib import resources
from pathlib import Path

from benchmarks.figures import style
from benchmarks.figures.drawing import DataMissing, Drawing, save
from benchmarks.figures.workspace import VALIDATION_SEED, Workspace
from benchmarks.page import fill
from bnserve_protocol import BnserveError
from bnserve_store import ModelStore
from bnserve_surrogate.training.config import read_configuration

FIGURES = {
    "residuals": "100 waveforms less the post-Newtonian baseline, and less the trained model",
    "sampling": "points of the four ways to sample a waveform, and where they lie",
    "pareto": "validation error against cost: the front of the hyper-parameter search",
    "mismatch_by_size": "distributions of the mismatch by number of training waveforms, the paper's recipe and ours",
    "reconstruction": "differences of 100 reconstructed waveforms to the generator's, best match",
    "parameter_space": "mismatch of the trained model across its parameters",
    "modes": "the strain of every mode of one binary",
    "higher_modes": "mismatch by inclination and mass ratio, with and without the higher modes",
}
_ROOT = Path(__file__).resolve().parents[2]
_SHIPPED = Path(str(resources.files("bnserve_surrogate") / "data"))


def main(arguments: list[str] | None = None) -> int:
    """Draw what was asked for; returns the exit status."""
    options = _parser().parse_args(arguments)
    if options.list or not options.names:
        print("\n".join(f"{name:<18}{what}" for name, what in FIGURES.items()))
        return 0
    names = list(FIGURES) if "all" in options.names else options.names
    try:
        workspace = _workspace(options)
        failed = [name for name in names if not _drawn(name, workspace, options)]
    except BnserveError as error:
        print(error.detail, file=sys.stderr)
        return 1
    return 1 if failed else 0


def _drawn(name: str, workspace: Workspace, options: argparse.Namespace) -> bool:
    """Draw one figure; False if what it needs is missing, and the others can go on."""
    started = time.perf_counter()
    module = importlib.import_module(f"benchmarks.figures.{name}")
    with style.talk():
        try:
            drawing: Drawing = module.draw(workspace)
        except DataMissing as error:
            print(f"{name}: {error.detail}", file=sys.stderr)
            return False
        command = _command(name, options)
        picture, _ = save(drawing, name, options.output, {"command": command, "model": workspace.model_name})
    print(f"{name}: {picture}, {time.perf_counter() - started:.0f} s", file=sys.stderr)
    print("\n".join(drawing.summary), flush=True)
    if options.page:
        fill(options.page, f"figure {name}", ["```text", f"$ {command}", *drawing.summary, "```"])
    return True


def _command(name: str, options: argparse.Namespace) -> str:
    """What to type for the same numbers; where files lie does not matter."""
    parser = _parser()
    chosen = {option: getattr(options, option) for option in ("fresh", "largest", "paper_largest", "seed")}
    given = [f"--{k.replace('_', '-')} {v}" for k, v in chosen.items() if v != parser.get_default(k)]
    return " ".join(["python -m benchmarks.figures", name, *(["--short"] if options.short else given)])


def _workspace(options: argparse.Namespace) -> Workspace:
    name, _, version = options.model.partition("@")
    return Workspace(
        recipe=read_configuration(options.recipe),
        paper=read_configuration(options.paper),
        artifact=ModelStore.default(options.store or ()).load(name, version or "stable"),
        directory=options.work,
        pareto=options.pareto,
        short=options.short,
        largest=options.largest,
        paper_largest=options.paper_largest,
        fresh=options.fresh,
        jobs=options.jobs,
        seed=options.seed,
        again=options.again,
    )


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.figures", description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", choices=[*FIGURES, "all"], metavar="NAME", help="of --list, or all")
    parser.add_argument("--list", action="store_true", help="name the figures and end")
    parser.add_argument("--short", action="store_true", help="small numbers: every figure within a minute or two")
    parser.add_argument("--work", type=Path, default=Path("runs"), metavar="DIR", help="where data are kept (runs)")
    parser.add_argument("--output", type=Path, default=_ROOT / "docs" / "images", metavar="DIR", help="(docs/images)")
    parser.add_argument("--page", type=Path, metavar="FILE.md", help="put the numbers into this page, too")
    parser.add_argument("--model", default="default", metavar="NAME[@VERSION]", help="the trained model (default)")
    parser.add_argument("--store", type=Path, action="append", metavar="DIR", help="searched before the shipped models")
    parser.add_argument("--recipe", type=Path, default=_ROOT / "configs" / "default.toml", metavar="FILE.toml")
    parser.add_argument("--paper", type=Path, default=_ROOT / "configs" / "paper.toml", metavar="FILE.toml")
    parser.add_argument("--pareto", type=Path, default=_SHIPPED, metavar="DIR", help="of pareto_*.toml (the shipped)")
    parser.add_argument("--largest", type=int, default=2**14, metavar="N", help="most waveforms to train on (2^14)")
    parser.add_argument("--paper-largest", type=int, default=2**15, metavar="N", help="with the paper's recipe (2^15)")
    parser.add_argument("--fresh", type=int, default=4096, metavar="N", help="waveforms to measure on (4096)")
    parser.add_argument("--seed", type=int, default=VALIDATION_SEED, metavar="N", help="of higher_modes (2024)")
    parser.add_argument("--jobs", type=int, default=-1, metavar="N", help="processes at once (all cores)")
    parser.add_argument("--again", action="store_true", help="compute anew what is kept")
    return parser


if __name__ == "__main__":
    sys.exit(main())
