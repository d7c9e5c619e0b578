"""bnserve in bilby: the likelihood of a service as a ``bilby.Likelihood``, its waveforms as a source model."""

from collections.abc import Callable, Mapping
from typing import Any

import bilby
import numpy as np
from together import Together

from bnserve_client import EvaluationOptions, Likelihood, Model

THEIR_NAMES = {
    "distance_mpc": "luminosity_distance", "inclination": "theta_jn", "right_ascension": "ra", "declination": "dec",
    "polarization_angle": "psi",
}  # fmt: skip
SAME_NAMES = ("lambda_1", "lambda_2", "chi_1", "chi_2")


def columns(samples: list[Mapping[str, float]], trigger_time: float) -> dict[str, Any]:
    """Samples by bilby's names as the columns that a likelihood of bnserve takes; spins are aligned."""
    theirs = {name: np.array([sample[name] for sample in samples]) for name in samples[0]}
    q = 1.0 / theirs["mass_ratio"]  # theirs is at most one, ours at least
    ours = {"mass_ratio": q, "total_mass": theirs["chirp_mass"] * ((1.0 + q) ** 2 / q) ** 0.6}
    ours |= {name: theirs[name] for name in SAME_NAMES}
    ours |= {name: theirs[their_name] for name, their_name in THEIR_NAMES.items()}
    ours |= {"coalescence_time": theirs["geocent_time"] - trigger_time}
    return ours | {"reference_phase": 2.0 * theirs["phase"]}  # theirs is of the orbit


class ServiceLikelihood(bilby.Likelihood):
    """A likelihood of a bnserve service for any sampler of bilby.

    Parameters
    ----------
    likelihood:
        From ``model.likelihood(analysis)``.
    threads:
        With more than one, :attr:`pool` is what ``bilby.run_sampler`` takes for ``pool``: bilby asks for one sample
        at a time, and the questions of all threads travel in one request.
    """

    def __init__(self, likelihood: Likelihood, threads: int = 1) -> None:
        super().__init__()
        self.likelihood = likelihood
        self.requests = 0
        self.pool = Together(self.log_likelihood_ratios, threads)

    def log_likelihood_ratios(self, samples: list[Mapping[str, float]]) -> np.ndarray:
        """Of many samples, ``(N,)``, in one request."""
        self.requests += 1
        return self.likelihood.log_likelihood(columns(samples, self.likelihood.analysis.settings.trigger_time))

    def log_likelihood_ratio(self, parameters: Mapping[str, float]) -> float:
        """Of one sample, by bilby's names, with ``chirp_mass`` and ``mass_ratio`` for the masses."""
        return self.pool.log_likelihood(parameters)

    def noise_log_likelihood(self) -> float:
        """That of no signal."""
        return self.likelihood.analysis.settings.noise_log_likelihood

    def log_likelihood(self, parameters: Mapping[str, float]) -> float:
        """That of the signal, not as a ratio."""
        return self.log_likelihood_ratio(parameters) + self.noise_log_likelihood()


def source_model(model: Model, f_min: float, f_max: float) -> Callable[..., dict[str, np.ndarray]]:
    """The waveforms of a server, for bilby's ``WaveformGenerator(frequency_domain_source_model=...)``.

    One waveform a call travels over the network: for what bilby alone can do. To sample, have the likelihood evaluated
    in the service.
    """

    def binary_neutron_star(
        frequency_array: np.ndarray,
        mass_1: float,
        mass_2: float,
        luminosity_distance: float,
        chi_1: float,
        chi_2: float,
        theta_jn: float,
        phase: float,
        lambda_1: float,
        lambda_2: float,
        **_: Any,
    ) -> dict[str, np.ndarray]:  # fmt: skip - bilby reads the names of the arguments
        band = (frequency_array >= f_min) & (frequency_array <= f_max)
        parameters = {
            "mass_ratio": mass_1 / mass_2, "total_mass": mass_1 + mass_2, "lambda_1": lambda_1, "lambda_2": lambda_2,
            "chi_1": chi_1, "chi_2": chi_2, "distance_mpc": luminosity_distance, "inclination": theta_jn,
            "reference_phase": 2.0 * phase,
        }  # fmt: skip
        waveforms = model.predict_batch(
            frequency_array[band], parameters, options=EvaluationOptions(alignment="merger")
        )
        strain = {name: np.zeros(len(band), dtype=complex) for name in ("plus", "cross")}
        strain["plus"][band], strain["cross"][band] = waveforms.plus[0], waveforms.cross[0]
        return strain

    return binary_neutron_star
