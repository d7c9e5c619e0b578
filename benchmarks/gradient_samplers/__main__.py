"""NUTS and jim on an event, beside the sampler of ``bnserve analyse``: effective samples per second of CPU.

    pip install '.[benchmarks]' blackjax
    bnserve analyse examples/gw170817.toml
    python -m benchmarks.gradient_samplers

NUTS samples the posterior of a finished run (phase and distance are integrated over) again, with the same likelihood
and priors. It begins where the injection is, as if a search had found it; its warm-up and what JAX compiles count. The
last tables compare the posteriors, by errors of their means and widths. jim's detectors stand still, so that it has an
event of its own:

    pip install ./protocol ./model_store ./surrogate ./jax_model jimgw
    bnserve analyse benchmarks/gradient_samplers/event.toml
    python -m benchmarks.gradient_samplers --event benchmarks/gradient_samplers/event.toml --samplers nuts jim

It has the same data and priors, its own relative binning with our waveform in JAX, and its sampler flowMC.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import jax
import numpy as np
from numpy.typing import NDArray

from benchmarks.gradient_samplers.density import Density
from benchmarks.gradient_samplers.nuts import Nuts, Settings, effective, start_of
from bnserve_posterior.events import Event, changed_event, read_event
from bnserve_posterior.running import Folder, Prepared, prepare
from bnserve_surrogate import Model

Floats = NDArray[np.float64]
SMOOTH = 0.2
"""Of the widths at the start: the part over which the force of the prior is smoothed."""


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

    @classmethod
    def of(
        cls,
        name: str,
        columns: dict[str, Floats],
        many: dict[str, float],
        likelihoods: int,
        seconds: float,
        remark: str,
    ) -> Found:
        """Of samples that count alike."""
        means = {key: float(column.mean()) for key, column in columns.items()}
        widths = {key: float(column.std()) for key, column in columns.items()}
        return cls(name, likelihoods, seconds, means, widths, many, remark)


def main() -> None:
    """Sample, and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--event", type=Path, default=Path("examples/gw170817.toml"), help="with an injection")
    parser.add_argument("--run", type=Path, help="folder of the finished run; by default that of the event")
    parser.add_argument("--chains", type=int, default=Settings.chains, help="of NUTS")
    parser.add_argument("--draws", type=int, default=Settings.draws, help="of each chain")
    parser.add_argument("--samplers", nargs="+", choices=["nuts", "jim"], default=["nuts"], help="(nuts)")
    options = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    event = changed_event(read_event(options.event), folder=options.run)
    with Folder(event.output, resume=True) as folder:
        prepared = prepare(event, Model.default(), folder)
        ours = finished(prepared, folder.result)
    prepared.try_likelihood(64)  # code that is made when it is first asked for
    settings = Settings(chains=options.chains, draws=options.draws)
    found = [
        by_jim(prepared, event) if name == "jim" else by_nuts(prepared, event, settings) for name in options.samplers
    ]
    report(ours, found)


def finished(prepared: Prepared, path: Path) -> Found:
    """The posterior of a run of ``bnserve analyse``."""
    result = json.loads(path.read_text())
    told, samples = result["meta_data"]["bnserve"], result["posterior"]["content"]
    if "coalescence_time" in prepared.cube.names:
        samples["coalescence_time"] = np.array(samples["geocent_time"]) - prepared.cube.trigger_time
    columns = {name: np.array(samples[name]) for name in prepared.cube.names}
    if prepared.cube.folded:
        columns["psi"] = columns["psi"] % (0.5 * np.pi)
    remark = f"ln of the evidence ratio {told['log_evidence']:.2f} +- {told['log_evidence_error']:.2f}"
    many = dict.fromkeys(columns, float(told["effective_samples"]))
    return Found.of("bnserve analyse", columns, many, told["likelihoods"], told["processor_seconds"], remark)


def by_nuts(prepared: Prepared, event: Event, settings: Settings) -> Found:
    """The posterior by NUTS."""
    density = Density(prepared)
    place = density.coordinates(injected(prepared, event))[0]
    begun = time.process_time()
    run = Nuts(density, place, density.spread(), density.turns, settings)
    density.smooth = SMOOTH * np.sqrt(np.diag(run.metric.covariance))
    run.warm_up()
    warm, asked = time.process_time() - begun, density.evaluated
    chains = run.sample()
    seconds = time.process_time() - begun
    shape = chains.draws.shape[:2]
    values = prepared.cube(density.points(chains.draws.reshape(-1, density.dimensions))[0])
    columns = {name: values[name] for name in prepared.cube.names}
    remark = (
        f"{shape[0]} chains of {shape[1]} draws, {chains.leapfrogs:.1f} gradients each, step {chains.step:.2f}, "
        f"acceptance {chains.acceptance:.2f}, {chains.divergent} divergent; warm-up {warm:.1f} s, {asked:,} gradients"
    )
    many = {name: effective(column.reshape(shape)) for name, column in columns.items()}
    return Found.of("NUTS", columns, many, density.evaluated, seconds, remark)


def by_jim(prepared: Prepared, event: Event) -> Found:
    """The posterior by jim, whose chains begin where those of NUTS do."""
    from benchmarks.gradient_samplers import jim

    settings = jim.Settings()
    density = Density(prepared)
    place = density.coordinates(injected(prepared, event))[0]
    begin, _ = start_of(density, place, density.spread(), Settings(chains=settings.chains))
    values = prepared.cube(np.clip(density.points(begin)[0], 1e-6, 1.0 - 1e-6))
    begun = time.process_time()
    found = jim.sampled(prepared, event, {name: values[name] for name in prepared.cube.names}, settings)
    seconds = time.process_time() - begun
    shape = found.columns["psi"].shape
    remark = (
        f"{shape[0]} chains of {shape[1]} draws, {found.gradients:,} of the likelihoods with gradients, acceptance "
        f"{found.local:.2f}, of its flow's proposals {found.of_flow:.2f}; warm-up {found.warm_up:.0%} of it"
    )
    columns = {name: found.columns[name].reshape(-1) for name in prepared.cube.names}
    many = {name: effective(found.columns[name]) for name in columns}
    return Found.of("jim (flowMC)", columns, many, found.likelihoods, seconds, remark)


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


def report(first: Found, others: Sequence[Found]) -> None:
    """Print who found what at which cost, and how far they are apart."""
    print("| sampler | likelihoods or gradients | CPU s | effective samples, least | a CPU second | |")
    print("|---|---|---|---|---|---|")
    for one in (first, *others):
        least = min(one.effective.values())
        print(
            f"| {one.name} | {one.likelihoods:,} | {one.seconds:.1f} | {least:,.0f} | {least / one.seconds:,.2f} | "
            f"{one.remark} |"
        )
    for second in others:
        compare(first, second)


def compare(first: Found, second: Found) -> None:
    """Print the posteriors of two, by errors of the second."""
    print(f"\n| parameter | {first.name} | {second.name} | effective | means differ by | widths by |")
    print("|---|---|---|---|---|---|")
    for name, mean in first.means.items():
        other, widths = second.means[name], (first.widths[name], second.widths[name])
        many = first.effective[name], second.effective[name]
        error = float(np.hypot(widths[0] / many[0] ** 0.5, widths[1] / many[1] ** 0.5))
        print(
            f"| {name} | {mean:.6g} +- {widths[0]:.3g} | {other:.6g} +- {widths[1]:.3g} | {many[1]:.0f} | "
            f"{(other - mean) / error:+.1f} errors | {(widths[1] - widths[0]) / (error / 2.0**0.5):+.1f} errors |"
        )


if __name__ == "__main__":
    main()
