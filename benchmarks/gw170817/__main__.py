"""GW170817 as the paper analysed it, with the likelihood evaluated by a service on this machine.

    pip install '.[benchmarks]'
    python -m benchmarks.gw170817                       # injection in noise of the event's ASDs
    python -m benchmarks.gw170817 --strain H1=H.hdf5 --strain L1=L.hdf5 --strain V1=V.hdf5

The event's noise curves and calibration envelopes are in ``benchmarks/data``. Without ``--strain`` the data is a
TEOBResumSPA signal with the event's parameters in seeded Gaussian noise; with the GWOSC strain files (HDF5, 4096 Hz) it
is the event. Everything finished is kept in ``--work``: the same command goes on where it was stopped.
"""

from __future__ import annotations

import argparse
import json
import sys
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from benchmarks.gw170817 import results, setting
from benchmarks.gw170817.analyses import kept
from benchmarks.gw170817.drawing import draw_corner
from benchmarks.gw170817.priors import UnitCube
from benchmarks.gw170817.sampling import Sampled, sample_event
from benchmarks.servers import bnserve_server
from bnserve_client import Model
from bnserve_inference import likelihood
from bnserve_posterior.sampling import Settings
from bnserve_protocol import BnserveError
from bnserve_surrogate import Model as LocalModel


def arguments() -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--strain", action="append", default=[], metavar="DETECTOR=FILE", help="GWOSC HDF5 strain")
    parser.add_argument("--work", type=Path, default=Path("runs/gw170817"), help="checkpoints and results")
    parser.add_argument("--kind", choices=("roq", "relative_binning"), default="roq", help="the likelihood to sample")
    parser.add_argument("--particles", type=int, default=Settings.particles, help="of each population of the sampler")
    parser.add_argument("--effective", type=int, default=Settings.effective, help="effective samples")
    parser.add_argument("--seed", type=int, default=Settings.seed, help="of the sampler")
    parser.add_argument("--snr", type=float, default=setting.SNR, help="of the injection")
    parser.add_argument("--url", help="a running service; without it one is started")
    parser.add_argument("--checks", type=int, default=5000, help="posterior samples for the other likelihoods")
    parser.add_argument("--generator-checks", type=int, default=200, help="of these, for TEOBResumSPA itself")
    parser.add_argument("--calibration-checks", type=int, default=1000, help="of these, for calibration errors")
    parser.add_argument("--calibration-draws", type=int, default=100, help="per posterior sample; 0 leaves it out")
    parser.add_argument("--sample-both", action="store_true", help="the other kind by itself, not by weights")
    parser.add_argument("--sample-only", action="store_true", help="no checks")
    parser.add_argument("--figure", type=Path, help="write the corner plot here")
    return parser.parse_args()


def main() -> int:
    """Sample, check, report; the last line is a JSON object."""
    options = arguments()
    try:
        return run(options)
    except BnserveError as error:
        print(f"{error.title}: {error}", file=sys.stderr)
        return 1


def run(options: argparse.Namespace) -> int:
    """As :func:`main`; raises ``BnserveError``."""
    asds = setting.read_asds()
    files = dict(text.partition("=")[::2] for text in options.strain)
    if files:
        event = setting.read_event(asds, {name: Path(path) for name, path in files.items()})
    else:
        event = setting.inject(asds, setting.effective_one_body(), options.snr)
    local, cube = LocalModel.default(), UnitCube()
    with ExitStack() as stack:
        url = options.url or stack.enter_context(bnserve_server())[0]
        model = stack.enter_context(Model.connect(url))
        settings = Settings(effective=options.effective, particles=options.particles, seed=options.seed)
        sampled: dict[str, Sampled] = {}
        found: dict[str, Any] = {"snr": options.snr, "injected": not files}
        for kind in (options.kind, results.OTHER[options.kind]) if options.sample_both else (options.kind,):
            bound = likelihood(model, kept(kind, event, local, options.work))
            sampled[kind] = sample_event(bound, cube, options.work / kind, settings)
            summary = results.summary(sampled[kind], cube)
            found |= {"kind": kind} | summary if kind == options.kind else {kind: summary}
        posteriors = {kind: each.posterior for kind, each in sampled.items()}
        if options.sample_only:
            shown = {kind: results.of_posterior(each, cube) for kind, each in posteriors.items()}
        else:
            checked, shown = results.check(posteriors, event, local, model, cube, options)
            found |= checked
    if options.figure:
        draw_corner(shown, event.truth, options.figure)
    (options.work / "result.json").write_text(json.dumps(found, indent=1))
    print(json.dumps(found))
    return 0


if __name__ == "__main__":
    sys.exit(main())
