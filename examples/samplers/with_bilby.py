"""bilby through a running server: its priors, its dynesty, its result; the likelihood is the server's.

    pip install bilby '.[detectors]'
    python examples/samplers/with_bilby.py http://127.0.0.1:8000

Beside the server's likelihood is printed what bilby's own says, on the full grid with waveforms of the same server.
"""

import logging
import tempfile
import time

import bilby
import numpy as np
from bilby.core.prior import PowerLaw, PriorDict, Uniform
from bilby_adapter import SAME_NAMES, THEIR_NAMES, ServiceLikelihood, source_model
from problem import (
    DETECTORS,
    DURATION,
    F_MAX,
    F_MIN,
    PRIOR,
    SAMPLING,
    SIGNAL,
    START,
    TRIGGER,
    arguments,
    build_analysis,
    report,
    simulate,
)

from bnserve_client import Model
from bnserve_inference import DetectorData


def prior() -> PriorDict:
    """The same as of the other examples, by bilby's names; its mass ratio is at most one."""
    low, high = PRIOR["coalescence_time"]
    sampled = {
        "chirp_mass": Uniform(*PRIOR["chirp_mass"]),
        "mass_ratio": PowerLaw(-2.0, 1.0 / PRIOR["mass_ratio"][1], 1.0 / PRIOR["mass_ratio"][0]),  # 1 / it is uniform
        "luminosity_distance": PowerLaw(2.0, *PRIOR["distance_mpc"]),
        "geocent_time": Uniform(TRIGGER + low, TRIGGER + high),
    }
    known = {name: SIGNAL[name] for name in SAME_NAMES} | {"phase": 0.0}  # the phase is integrated out
    known |= {theirs: SIGNAL[ours] for ours, theirs in THEIR_NAMES.items() if theirs not in sampled}
    return PriorDict(sampled | known)


def injection() -> dict[str, float]:
    """The signal by bilby's names."""
    named = {theirs: SIGNAL[ours] for ours, theirs in THEIR_NAMES.items()} | {name: SIGNAL[name] for name in SAME_NAMES}
    named |= {"chirp_mass": SIGNAL["chirp_mass"], "mass_ratio": 1.0 / SIGNAL["mass_ratio"], "phase": 0.0}
    return named | {"geocent_time": TRIGGER + SIGNAL["coalescence_time"]}


def bilbys_likelihood(model: Model, data: list[DetectorData]) -> bilby.Likelihood:
    """bilby's own on the full grid, for which every waveform comes from the server."""
    interferometers = bilby.gw.detector.InterferometerList(list(DETECTORS))
    for theirs, ours in zip(interferometers, data, strict=True):
        theirs.minimum_frequency, theirs.maximum_frequency = F_MIN, F_MAX
        grid = np.arange(len(ours.strain)) / DURATION
        theirs.set_strain_data_from_frequency_domain_strain(ours.strain, frequency_array=grid, start_time=START)
        theirs.power_spectral_density = bilby.gw.detector.PowerSpectralDensity(grid, asd_array=ours.asd)
    generator = bilby.gw.WaveformGenerator(
        duration=DURATION, sampling_frequency=SAMPLING, start_time=START,
        frequency_domain_source_model=source_model(model, F_MIN, F_MAX),
        parameter_conversion=bilby.gw.conversion.convert_to_lal_binary_neutron_star_parameters,
    )  # fmt: skip
    priors = PriorDict({"phase": Uniform(0.0, 2.0 * np.pi)})
    return bilby.gw.GravitationalWaveTransient(interferometers, generator, priors=priors, phase_marginalization=True)


def sample(likelihood: ServiceLikelihood, live: int, seed: int = 1) -> bilby.core.result.Result:
    """A seeded run of dynesty through bilby, as many at a time as the pool has threads."""
    bilby.core.utils.random.seed(seed)
    with tempfile.TemporaryDirectory() as folder:
        return bilby.run_sampler(
            likelihood, prior(), sampler="dynesty", outdir=folder, label="bnserve", save=False, use_ratio=True,
            nlive=live, sample="unif", bound="multi", dlogz=0.5,
            pool=likelihood.pool, queue_size=likelihood.pool.size, rstate=np.random.default_rng(seed),
            check_point=False, resume=False, print_progress=False,
        )  # fmt: skip


def main() -> None:
    """Sample, and report."""
    chosen = arguments(__doc__)
    logging.getLogger("bilby").setLevel(logging.WARNING)
    live = 40 if chosen.short else 1000
    with Model.connect(chosen.address) as model:
        data = simulate(model, chosen.asd)
        likelihood = ServiceLikelihood(model.likelihood(build_analysis(model, data)), threads=live // 2)
        ours = likelihood.log_likelihood_ratio(injection())
        theirs = bilbys_likelihood(model, data).log_likelihood_ratio(injection())
        print(f"ln L of the injection: {ours:.4f} from the service, {theirs:.4f} from bilby")
        if abs(ours - theirs) > 0.05:
            raise SystemExit("The two differ by more than relative binning costs.")
        started = time.perf_counter()
        result = sample(likelihood, live)
        seconds = time.perf_counter() - started
    found = result.posterior
    samples = np.column_stack(
        [found.chirp_mass, 1.0 / found.mass_ratio, found.luminosity_distance, found.geocent_time - TRIGGER]
    )
    counts = f"bilby: {likelihood.likelihood.counts.rows} likelihoods in {likelihood.requests} requests"
    report(samples, None, seconds, counts, f"{result.log_bayes_factor:.2f} +- {result.log_evidence_err:.2f}")


if __name__ == "__main__":
    main()
