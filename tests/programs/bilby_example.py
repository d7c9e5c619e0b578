"""bilby's own example of a binary neutron star with two lines changed, sampled for a few hundred iterations.

    python tests/programs/bilby_example.py binary_neutron_star_example.py http://127.0.0.1:8000 --npool 2

The example is bilby's, from its source distribution; ``tests/programs.sh bilby`` fetches it and starts the server. Its
sampler is replaced by dynesty; with ``--whole-prior`` its prior by all of ``BNSPriorDict()``. The run fails where fewer
than one in a hundred likelihoods is finite, or where the likelihood evaluated in the service differs from bilby's own
with the service's waveforms by 0.05.
"""

import argparse
import copy
import inspect
import math
import multiprocessing
import os
import runpy
import sys
import tempfile
import time
from pathlib import Path

import bilby
import numpy as np

from bnserve_client.bilby import ServiceLikelihood

CHANGES = {
    "import bilby\n": "import bilby, bnserve_client.bilby\n",
    "frequency_domain_source_model=bilby.gw.source.lal_binary_neutron_star,": (
        "frequency_domain_source_model=bnserve_client.bilby.binary_neutron_star,"
    ),
}
"""What a user changes; the address of the server is in ``BNSERVE_URL``."""
LEAST_FINITE = 0.01
MOST_APART = 0.05
NEAR_CHIRP_MASS = bilby.core.prior.Uniform(1.205, 1.225)
SPINNING = {"a_1": 0.1, "tilt_1": 1.0, "phi_12": 0.5, "a_2": 0.05, "tilt_2": 0.8, "phi_jl": 1.0}
NOTHING = -1e300
"""bilby's -inf is the largest negative number."""

asked, finite = (multiprocessing.get_context("fork").Value("q", 0) for _ in range(2))
original_sampler = bilby.run_sampler
original_value = bilby.gw.likelihood.GravitationalWaveTransient.log_likelihood_ratio


def changed(example: str) -> str:
    """The example's text with both lines changed."""
    for line, instead in CHANGES.items():
        if example.count(line) != 1:
            sys.exit(f"This example does not have the line {line!r} once.")
        example = example.replace(line, instead)
        print(f"- {line.strip()}\n+ {instead.strip()}")
    return example


def counted(self: object, parameters: dict | None = None) -> float:
    """bilby's likelihood; how often it is asked, and how often it is finite."""
    value = value_of(self, parameters)
    for counter, more in ((asked, 1), (finite, int(value > NOTHING))):
        with counter.get_lock():
            counter.value += more
    return value


def value_of(likelihood: object, parameters: dict | None) -> float:
    """ln L; earlier releases hand parameters over as an attribute."""
    if "parameters" in inspect.signature(original_value).parameters:
        return original_value(likelihood, parameters)
    if parameters is None:
        return original_value(likelihood)
    before, likelihood.parameters = likelihood.parameters, dict(parameters)
    try:
        return original_value(likelihood)
    finally:
        likelihood.parameters = before


def agreement(likelihood: object, priors: dict, injection: dict, waveforms: dict) -> float:
    """The largest difference in ln L between both routes, at the signal and around it."""
    service = ServiceLikelihood.from_bilby(likelihood.interferometers, priors, waveform_arguments=waveforms)
    samples = [injection | {"phase": injection["phase"] + 0.1 * n, "lambda_1": injection["lambda_1"] + 20.0 * n}
               for n in range(10)]  # fmt: skip
    theirs = np.array([value_of(likelihood, sample) for sample in samples])
    found = float(np.abs(service.log_likelihood_ratios(samples) - theirs).max())
    print(f"ln L of the signal: {theirs[0]:.4f} by the source model; the service's likelihood differs by {found:.2g}")
    return found


def print_times(likelihood: object, injection: dict) -> None:
    """What a log-likelihood of this data costs: the best of several, each of another binary."""
    waveforms = likelihood.waveform_generator.waveform_arguments
    lals = copy.deepcopy(likelihood)
    lals.waveform_generator.frequency_domain_source_model = bilby.gw.source.lal_binary_neutron_star
    plain = {name: value for name, value in waveforms.items() if name != "waveform_approximant"}
    quadrupole = copy.deepcopy(likelihood)
    quadrupole.waveform_generator.waveform_arguments["mode_array"] = [[2, 2]]
    narrow = bilby.gw.prior.BNSPriorDict(dictionary={**bilby.gw.prior.BNSPriorDict(), "chirp_mass": NEAR_CHIRP_MASS})
    narrow["geocent_time"] = injection["geocent_time"]
    binned, of_22 = (
        ServiceLikelihood.from_bilby(
            likelihood.interferometers, copy.deepcopy(narrow), waveform_arguments=plain | modes,
            fiducial_parameters=injection, phase_marginalization=True,
        )
        for modes in ({}, {"mode_array": [[2, 2]]})
    )  # fmt: skip
    batch = [injection | {"lambda_1": injection["lambda_1"] + 0.01 * n} for n in range(1000)]
    turning = [{name: value for name, value in row.items() if not name.startswith("chi_")} | SPINNING for row in batch]
    rows = {
        f"bilby, LAL's {waveforms['waveform_approximant']}": lambda n: value_of(lals, batch[n]),
        "bilby, bnserve_client.bilby.binary_neutron_star": lambda n: value_of(likelihood, batch[n]),
        "the same, another phase of the last binary": lambda n: value_of(likelihood, batch[n] | {"phase": 0.1 * n}),
        "of the (2, 2) mode alone": lambda n: value_of(quadrupole, batch[n]),
        "of all modes, spins in the orbital plane": lambda n: value_of(likelihood, turning[n]),
        "ServiceLikelihood, relative binning, one": lambda n: binned.log_likelihood_ratios(batch[n : n + 1]),
        "ServiceLikelihood, relative binning, in 1000": lambda n: binned.log_likelihood_ratios(batch),
        "of the (2, 2) mode alone, one": lambda n: of_22.log_likelihood_ratios(batch[n : n + 1]),
        "of the (2, 2) mode alone, in 1000": lambda n: of_22.log_likelihood_ratios(batch),
    }
    best = dict.fromkeys(rows, math.inf)
    for n in range(1, 41):
        for name, ask in rows.items():  # in turn: a busy machine is as busy for all of them
            started = time.perf_counter()
            ask(n)
            best[name] = min(best[name], time.perf_counter() - started)
    for name, seconds in best.items():
        print(f"  {name:<56} {1e3 * seconds / (1000 if '1000' in name else 1):8.3f} ms")


def sampled(chosen: argparse.Namespace) -> object:
    """What takes the place of ``bilby.run_sampler`` in the example."""

    def run_sampler(
        likelihood: object, priors: dict, injection_parameters: dict, outdir: str, **given: object
    ) -> bilby.core.result.Result:
        if chosen.whole_prior:
            time_prior = bilby.core.prior.Uniform(*(injection_parameters["geocent_time"] + np.array([-0.1, 0.1])))
            priors = bilby.gw.prior.BNSPriorDict(
                dictionary={**bilby.gw.prior.BNSPriorDict(), "geocent_time": time_prior}
            )
        waveforms = likelihood.waveform_generator.waveform_arguments
        if agreement(likelihood, priors, injection_parameters, waveforms) > MOST_APART:
            sys.exit("The two differ by too much.")
        print_times(likelihood, injection_parameters)
        result = original_sampler(
            likelihood=likelihood, priors=priors, sampler="dynesty", nlive=100, sample="rwalk", walks=10, nact=1,
            maxmcmc=50,
            maxiter=chosen.iterations, npool=chosen.npool, check_point=False, resume=False, print_progress=False,
            use_ratio=True, outdir=outdir, label=f"npool_{chosen.npool}", injection_parameters=injection_parameters,
            conversion_function=given["conversion_function"],
        )  # fmt: skip
        result.plot_corner = lambda *_, **__: None  # so short a run has no contours
        return result

    return run_sampler


def main() -> None:
    """Run it, and check."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("example", type=Path)
    parser.add_argument("address")
    parser.add_argument("--npool", type=int, default=1)
    parser.add_argument("--iterations", type=int, default=500)
    parser.add_argument("--whole-prior", action="store_true", help="all of BNSPriorDict()")
    chosen = parser.parse_args()
    text = changed(chosen.example.read_text())
    multiprocessing.set_start_method("fork")
    os.environ["BNSERVE_URL"] = chosen.address
    bilby.run_sampler = sampled(chosen)
    bilby.gw.likelihood.GravitationalWaveTransient.log_likelihood_ratio = counted
    bilby.gw.GravitationalWaveTransient.log_likelihood_ratio = counted
    started = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "example.py"
        script.write_text(text)
        os.chdir(folder)
        result = runpy.run_path(str(script))["result"]
    seconds = time.perf_counter() - started
    print(
        f"bilby {bilby.__version__}, npool {chosen.npool}: {result.num_likelihood_evaluations} likelihoods in "
        f"{chosen.iterations} iterations, {seconds:.0f} s; {asked.value} asked, {finite.value} finite"
    )
    if finite.value < LEAST_FINITE * asked.value:
        sys.exit("Fewer than one likelihood in a hundred is finite.")


if __name__ == "__main__":
    main()
