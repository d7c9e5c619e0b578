"""Counts what a reader of the code meets, and prints one table.

    python -m benchmarks.structure [--against COMMIT] [--list]

- modules that one warm remote ``predict``, one warm batch of remote log-likelihoods and one training enter (every
  module of the product of which a function is called, in client, server and their threads);
- files in the root of the service and in its largest folder; circles among the children of a package, imports for
  types alone included;
- lines of the product, with ``--against`` beside those of a commit; lengths of modules; long functions, large classes.

``--list`` names what is counted.
"""

from __future__ import annotations

import argparse
import io
import subprocess
import tarfile
import tempfile
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from benchmarks.structure import sources, ways
from benchmarks.structure.entering import Entered
from benchmarks.workers import ROOT
from tests.architecture.rooms import ROOMS


def lines_at(commit: str) -> int:
    """Lines of the product at a commit."""
    archived = subprocess.run(["git", "archive", commit, *ROOMS], cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout
    with tempfile.TemporaryDirectory() as folder, tarfile.open(fileobj=io.BytesIO(archived)) as archive:
        archive.extractall(folder, filter="data")
        places = [Path(folder) / room / package for room, package in ROOMS.items()]
        return sum(len(path.read_text().splitlines()) for place in places for path in place.rglob("*.py"))


def counted(title: str, found: Iterable[str], listed: bool) -> None:
    """One row; what it counts below it, when asked."""
    names = sorted(found)
    print(f"{title:<72} {len(names):>7,}")
    if listed:
        print("".join(f"    {name}\n" for name in names), end="")


def main() -> None:
    """Count and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--against", metavar="COMMIT", help="lines of the product there")
    parser.add_argument("--list", action="store_true", help="name what is counted")
    options = parser.parse_args()
    entered = Entered()
    counted("modules that a warm remote predict enters", ways.waveform(entered), options.list)
    counted("modules that a warm remote likelihood batch enters", ways.likelihoods(entered), options.list)
    counted("modules that a training enters", ways.training(entered), options.list)
    folders = sources.folder_sizes(ROOT / "service" / "bnserve_service")
    root, (largest, count) = folders[Path("bnserve_service")], folders.most_common(1)[0]
    print(f"{'service: files in its root':<72} {root:>7,}")
    print(f"{f'service: files in its largest folder, {largest}':<72} {count:>7,}")
    counted("packages whose children import each other in a circle", sources.circles(), options.list)
    product = sources.modules()
    lengths = sources.lines(product)
    print(f"{'lines of the product':<72} {sum(lengths):>7,}")
    if options.against:
        print(f"{f'  more than at {options.against}':<72} {sum(lengths) - lines_at(options.against):>+7,}")
    print(f"{'lines of a module: 90 %, largest':<72} {np.quantile(lengths, 0.9):>7.0f} {lengths[-1]:>7}")
    counted(f"functions of more than {sources.LONG_FUNCTION} lines", sources.long_functions(product), options.list)
    counted(f"classes of more than {sources.LARGE_CLASS} methods", sources.large_classes(product), options.list)


if __name__ == "__main__":
    main()
