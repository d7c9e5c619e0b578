"""bilby through a running server: its detectors, priors, dynesty and result; the likelihood is the server's.

    pip install '.[bilby]'
    python examples/samplers/with_bilby.py http://127.0.0.1:8000

Beside the server's likelihood is printed what bilby's own says, on the full grid with waveforms of the same server.
"""

import logging
import tempfile
import time

import bilby
import numpy as np
from bilby.core.prior import PowerLaw, PriorDict, Uniform
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
    report,
    simulate,
)

from bnserve_client import Model
from bnserve_client.bilby import ServiceLikelihood, binary_neutron_star
from bnserve_inference import DetectorData

THEIR_NAMES = {
    "distance_mpc": "luminosity_distance", "inclination": "theta_jn", "right_ascension": "ra", "declination": "dec",
    "polarization_angle": "psi",
}  # fmt: skip
SAME_NAMES = ("lambda_1", "lambda_2", "chi_1", "chi_2")


def prior() -> PriorDict:
    """The same as of the other examples, by bilby's names; its mass ratio is at most one."""
    low, high = PRIOR["coalescence_time"]
    sampled = {
        "chirp_mass": Uniform(*PRIOR["chirp_mass"]),
        "mass_ratio": PowerLaw(-2.0, 1.0 / PRIOR["mass_ratio"][1], 1.0 / PRIOR["mass_ratio"][0]),  # 1 / it is uniform
        "luminosity_distance": PowerLaw(2.0, *PRIOR["distance_mpc"]),
        "geocent_time": Uniform(TRIGGER + low, TRIGGER + high),
        "phase": Uniform(0.0, 2.0 * np.pi),
    }
    known = {name: value for name, value in injection().items() if name not in sampled}
    return PriorDict(sampled | known)


def injection() -> dict[str, float]:
    """The signal by bilby's names."""
    named = {theirs: SIGNAL[ours] for ours, theirs in THEIR_NAMES.items()} | {name: SIGNAL[name] for name in SAME_NAMES}
    named |= {"chirp_mass": SIGNAL["chirp_mass"], "mass_ratio": 1.0 / SIGNAL["mass_ratio"], "phase": 0.0}
    return named | {"geocent_time": TRIGGER + SIGNAL["coalescence_time"]}


def detectors(data: list[DetectorData]) -> bilby.gw.detector.InterferometerList:
    """The simulated data as bilby's detectors."""
    interferometers = bilby.gw.detector.InterferometerList(list(DETECTORS))
    for theirs, ours in zip(interferometers, data, strict=True):
        theirs.minimum_frequency, theirs.maximum_frequency = F_MIN, F_MAX
        grid = np.arange(len(ours.strain)) / DURATION
        theirs.set_strain_data_from_frequency_domain_strain(ours.strain, frequency_array=grid, start_time=START)
        theirs.power_spectral_density = bilby.gw.detector.PowerSpectralDensity(grid, asd_array=ours.asd)
    return interferometers


def bilbys_likelihood(
    interferometers: bilby.gw.detector.InterferometerList, waveforms: dict[str, object]
) -> bilby.Likelihood:
    """bilby's own on the full grid, for which every waveform comes from the server; its phase is not integrated over,
    because bilby's rule for that is the (2, 2) mode's."""
    generator = bilby.gw.WaveformGenerator(
        duration=DURATION, sampling_frequency=SAMPLING, start_time=START,
        frequency_domain_source_model=binary_neutron_star, waveform_arguments=waveforms,
        parameter_conversion=bilby.gw.conversion.convert_to_lal_binary_neutron_star_parameters,
    )  # fmt: skip
    return bilby.gw.GravitationalWaveTransient(interferometers, generator)


def mean_over_phases(likelihood: bilby.Likelihood, count: int = 512) -> float:
    """ln of the mean likelihood of the injection over the phase."""
    phases = 2.0 * np.pi * np.arange(count) / count
    values = np.array([likelihood.log_likelihood_ratio(injection() | {"phase": phase}) for phase in phases])
    return float(values.max() + np.log(np.exp(values - values.max()).mean()))


def sample(
    likelihood: ServiceLikelihood, priors: PriorDict, live: int, seed: int = 1
) -> tuple[bilby.core.result.Result, int]:
    """A seeded run of dynesty through bilby, as many at a time as half of the live points; and how many requests."""
    bilby.core.utils.random.seed(seed)
    pool = likelihood.together(threads=live // 2)
    with tempfile.TemporaryDirectory() as folder:
        result = bilby.run_sampler(
            likelihood, priors, sampler="dynesty", outdir=folder, label="bnserve", save=False, use_ratio=True,
            nlive=live, sample="unif", bound="multi", dlogz=0.5, pool=pool, queue_size=pool.size,
            rstate=np.random.default_rng(seed), check_point=False, resume=False, print_progress=False,
        )  # fmt: skip
    return result, pool.requests


def main() -> None:
    """Sample, and report."""
    chosen = arguments(__doc__)
    logging.getLogger("bilby").setLevel(logging.WARNING)
    with Model.connect(chosen.address) as model:
        interferometers = detectors(simulate(model, chosen.asd))
    waveforms = {"bnserve_url": chosen.address, "minimum_frequency": F_MIN, "maximum_frequency": F_MAX}
    priors = prior()
    likelihood = ServiceLikelihood.from_bilby(
        interferometers, priors, waveform_arguments=waveforms, fiducial_parameters=injection(), trigger_time=TRIGGER,
        phase_marginalization=True,
    )  # fmt: skip
    ours = likelihood.log_likelihood_ratio(injection())
    theirs = mean_over_phases(bilbys_likelihood(interferometers, waveforms))
    print(f"ln L of the injection: {ours:.4f} from the service, {theirs:.4f} from bilby")
    if abs(ours - theirs) > 0.05:
        raise SystemExit("The two differ by more than relative binning costs.")
    started = time.perf_counter()
    result, requests = sample(likelihood, priors, 40 if chosen.short else 1000)
    seconds = time.perf_counter() - started
    found = result.posterior
    samples = np.column_stack(
        [found.chirp_mass, 1.0 / found.mass_ratio, found.luminosity_distance, found.geocent_time - TRIGGER]
    )
    counts = f"bilby: {likelihood.likelihood.counts.rows} likelihoods in {requests} requests"
    report(samples, None, seconds, counts, f"{result.log_bayes_factor:.2f} +- {result.log_evidence_err:.2f}")


if __name__ == "__main__":
    main()
