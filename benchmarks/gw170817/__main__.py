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
from dataclasses import replace
from pathlib import Path
from typing import Any

from benchmarks.gw170817 import results, setting
from benchmarks.gw170817.analyses import kept
from benchmarks.gw170817.annealing import Annealing
from benchmarks.gw170817.drawing import draw_corner
from benchmarks.gw170817.keeping import keep_posterior, kept_posterior
from benchmarks.gw170817.marginals import Shown, physical
from benchmarks.gw170817.priors import UnitCube
from benchmarks.gw170817.sampling import SETTINGS, Posterior, SamplerSettings, sample_annealed, sample_nautilus
from benchmarks.servers import bnserve_server
from bnserve_client import Model
from bnserve_inference import likelihood
from bnserve_protocol import BnserveError, Likelihood
from bnserve_surrogate import Model as LocalModel

UNFINISHED = 3
"""Exit status of a run that ``--stop-after`` ended."""


def arguments() -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--strain", action="append", default=[], metavar="DETECTOR=FILE", help="GWOSC HDF5 strain")
    parser.add_argument("--work", type=Path, default=Path("runs/gw170817"), help="checkpoints and results")
    parser.add_argument("--kind", choices=("roq", "relative_binning"), default="roq", help="the likelihood to sample")
    parser.add_argument("--sampler", choices=("annealing", "nautilus"), default="annealing")
    parser.add_argument("--particles", type=int, default=SETTINGS.particles, help="of the annealed population")
    parser.add_argument("--pool", type=int, default=SETTINGS.pool, help="draws from the prior that they begin with")
    parser.add_argument("--live", type=int, default=SamplerSettings.live, help="points of nautilus")
    parser.add_argument("--networks", type=int, default=SamplerSettings.networks)
    parser.add_argument("--effective", type=int, default=SamplerSettings.effective)
    parser.add_argument("--seed", type=int, default=SamplerSettings.seed, help="of the sampler")
    parser.add_argument("--snr", type=float, default=setting.SNR, help="of the injection")
    parser.add_argument("--stop-after", type=float, default=float("inf"), metavar="SECONDS", help="nautilus leaves off")
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
        posteriors: dict[str, Posterior] = {}
        found: dict[str, Any] = {"snr": options.snr, "injected": not files}
        for kind in (options.kind, results.OTHER[options.kind]) if options.sample_both else (options.kind,):
            bound = likelihood(model, kept(kind, event, local, options.work))
            posterior = sample(options, bound, cube, options.work / kind)
            if posterior is None:
                print(json.dumps({"finished": False, "work": options.work.name}))
                return UNFINISHED
            posteriors[kind] = posterior
            summary = results.summary(posterior)
            found |= {"kind": kind} | summary if kind == options.kind else {kind: summary}
        if options.sample_only:
            shown = {kind: Shown(physical(cube(each.points)), each.weights) for kind, each in posteriors.items()}
        else:
            checked, shown = results.check(posteriors, event, local, model, cube, options)
            found |= checked
    if options.figure:
        draw_corner(shown, event.truth, options.figure)
    (options.work / "result.json").write_text(json.dumps(found, indent=1))
    print(json.dumps(found))
    return 0


def sample(options: argparse.Namespace, bound: Likelihood, cube: UnitCube, folder: Path) -> Posterior | None:
    """With the sampler that was asked for; what it found is kept in the folder, and taken from there the next time."""
    annealing = replace(SETTINGS, pool=options.pool, particles=options.particles, seed=options.seed)
    nautilus = SamplerSettings(options.live, options.networks, options.effective, options.seed)
    settings: Annealing | SamplerSettings = annealing if options.sampler == "annealing" else nautilus
    if (found := kept_posterior(folder, settings)) is not None:
        return found
    if options.sampler == "annealing":
        posterior: Posterior | None = sample_annealed(bound, cube, folder, annealing)
    else:
        posterior = sample_nautilus(bound, cube, folder, nautilus, options.stop_after)
    if posterior is not None:
        keep_posterior(folder, posterior)
    return posterior


if __name__ == "__main__":
    sys.exit(main())
