"""NUTS on the likelihood of an event, beside the sampler of ``bnserve analyse``: effective samples per second of CPU.

    pip install '.[benchmarks]' blackjax
    python -m benchmarks.gradient_samplers

Both sample the posterior of ``examples/gw170817.toml`` (phase and distance integrated over), over the same priors and
with the same likelihood. NUTS begins where the injection is, as if a search had found it, and its warm-up counts.
The last lines compare the two posteriors, by errors of their means and widths.
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from typing import NamedTuple

import jax
import numpy as np
from numpy.typing import NDArray

from benchmarks.gradient_samplers.density import Density
from benchmarks.gradient_samplers.nuts import Nuts, Settings, effective
from bnserve_posterior.events import Event, changed_event, read_event
from bnserve_posterior.running import Folder, Prepared, prepare
from bnserve_posterior.sampling import Settings as OurSettings
from bnserve_posterior.sampling import sample
from bnserve_surrogate import Model

Floats = NDArray[np.float64]


class Found(NamedTuple):
    """What a sampler found: means, widths and effective samples by parameter, and what it cost."""

    name: str
    likelihoods: int
    seconds: float
    """Of CPU."""
    means: dict[str, float]
    widths: dict[str, float]
    effective: dict[str, float]
    remark: str


def main() -> None:
    """Sample with both, and print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--event", type=Path, default=Path("examples/gw170817.toml"), help="with an injection")
    parser.add_argument("--work", type=Path, default=Path("runs/gradient_samplers"), help="for the analysis")
    parser.add_argument("--chains", type=int, default=Settings.chains, help="of NUTS")
    parser.add_argument("--draws", type=int, default=Settings.draws, help="of each chain")
    parser.add_argument("--effective", type=int, default=OurSettings.effective, help="samples of ours")
    parser.add_argument("--particles", type=int, default=OurSettings.particles, help="of each of our populations")
    options = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    event = changed_event(read_event(options.event), folder=options.work)
    with Folder(event.output, resume=True) as folder:
        prepared = prepare(event, Model.default(), folder)
    prepared.try_likelihood(64)  # code that is made when it is first asked for
    chosen = Settings(chains=options.chains, draws=options.draws)
    ours = by_populations(prepared, OurSettings(effective=options.effective, particles=options.particles))
    report(ours, by_nuts(prepared, event, chosen))


def by_nuts(prepared: Prepared, event: Event, settings: Settings) -> Found:
    """The posterior by NUTS."""
    density = Density(prepared)
    place = density.coordinates(injected(prepared, event))[0]
    begun = time.process_time()
    run = Nuts(density, place, density.spread(), density.turns, settings)
    run.warm_up()
    warm, asked = time.process_time(), density.evaluated
    chains = run.sample()
    seconds = time.process_time() - begun
    shape = chains.draws.shape[:2]
    values = prepared.cube(density.points(chains.draws.reshape(-1, density.dimensions))[0])
    columns = {name: values[name] for name in prepared.cube.names}
    remark = (
        f"{settings.chains} chains of {settings.draws} draws, {chains.leapfrogs:.1f} steps each, acceptance "
        f"{chains.acceptance:.2f}; {chains.divergent} divergent; warm-up {warm - begun:.1f} s and {asked} gradients"
    )
    return Found(
        "NUTS", density.evaluated, seconds,
        {name: float(column.mean()) for name, column in columns.items()},
        {name: float(column.std()) for name, column in columns.items()},
        {name: effective(column.reshape(shape)) for name, column in columns.items()},
        remark,
    )  # fmt: skip


def by_populations(prepared: Prepared, settings: OurSettings) -> Found:
    """The posterior by the sampler of ``bnserve analyse``."""
    begun = time.process_time()
    posterior = sample(prepared.problem(), settings)
    seconds = time.process_time() - begun
    values, weights = prepared.cube(posterior.points), posterior.weights
    columns = {name: values[name] for name in prepared.cube.names}
    means = {name: float(np.average(column, weights=weights)) for name, column in columns.items()}
    widths = {
        name: float(np.sqrt(np.average((column - means[name]) ** 2, weights=weights)))
        for name, column in columns.items()
    }
    many = dict.fromkeys(columns, float(posterior.effective))
    remark = f"ln of the evidence {posterior.log_evidence:.2f} +- {posterior.log_evidence_error:.2f}"
    return Found("bnserve analyse", posterior.likelihoods, seconds, means, widths, many, remark)


def injected(prepared: Prepared, event: Event) -> Floats:
    """The injection as a point of the unit cube, ``(1, D)``; what it leaves open is 0."""
    cube, injection = prepared.cube, event.data.injection
    assert injection is not None, "an event with an injection"
    found = []
    for name in cube.names:
        prior, value = cube.priors[name], injection.parameters.get(name, 0.0)
        if name == "psi" and cube.folded:
            found.append((value - prior.minimum) / (0.5 * np.pi) % 1.0)
        else:
            found.append(float(prior.cdf(value)))
    return np.array([found])


def report(first: Found, second: Found) -> None:
    """Print who found what at which cost, and how far they are apart."""
    print("| sampler | likelihoods or gradients | CPU s | effective samples, least | a CPU second | |")
    print("|---|---|---|---|---|---|")
    for one in (first, second):
        least = min(one.effective.values())
        print(
            f"| {one.name} | {one.likelihoods:,} | {one.seconds:.1f} | {least:,.0f} | {least / one.seconds:,.0f} | "
            f"{one.remark} |"
        )
    print(f"\n| parameter | {first.name} | {second.name} | effective | means differ by | widths by |")
    print("|---|---|---|---|---|---|")
    for name, mean in first.means.items():
        other, widths = second.means[name], (first.widths[name], second.widths[name])
        many = first.effective[name], second.effective[name]
        error = np.hypot(widths[0] / many[0] ** 0.5, widths[1] / many[1] ** 0.5)
        error_of_width = error / 2.0**0.5
        print(
            f"| {name} | {mean:.6g} +- {widths[0]:.3g} | {other:.6g} +- {widths[1]:.3g} | {many[1]:.0f} | "
            f"{(other - mean) / error:+.1f} errors | {(widths[1] - widths[0]) / error_of_width:+.1f} errors |"
        )


if __name__ == "__main__":
    main()
