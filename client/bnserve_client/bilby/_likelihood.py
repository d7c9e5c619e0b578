"""A likelihood of bnserve as bilby's: its value comes from where the model is, all else is bilby's own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from bilby.core import utils
from bilby.gw.conversion import convert_to_lal_binary_neutron_star_parameters
from bilby.gw.detector import InterferometerList
from bilby.gw.likelihood import GravitationalWaveTransient
from bilby.gw.waveform_generator import WaveformGenerator
from numpy.typing import NDArray

from bnserve_client._lal_meaning import QUADRUPOLE, is_single, modes_of, orbital_turn
from bnserve_client._together import Together
from bnserve_client.bilby._analysis import Marginalised, build_analysis
from bnserve_client.bilby._arguments import Choice, read_choice, stated
from bnserve_client.bilby._calibration import calibration_columns
from bnserve_client.bilby._source import binary_neutron_star
from bnserve_client.bilby._waveforms import binaries
from bnserve_protocol import DEFAULT_ERROR_BOUND, DetectorFrame, EvaluationOptions, Likelihood, WaveformModel

Floats = NDArray[np.float64]

_SAME = {"polarization_angle": "psi", "inclination": "theta_jn", "distance_mpc": "luminosity_distance"}
_NOTHING = float(np.nan_to_num(-np.inf))
"""What bilby's likelihoods say outside of a model's range."""


class ServiceLikelihood(GravitationalWaveTransient):  # type: ignore[misc]  # bilby has no annotations
    """A likelihood of bnserve for any sampler of bilby; made by :meth:`from_bilby`.

    It takes bilby's parameters, and is all that ``bilby.gw.GravitationalWaveTransient`` is: it can be pickled and
    copied, and reconstructs what it integrates over. Its values come from the service, eight bytes for each sample,
    many in one request where a sampler asks for many (:meth:`log_likelihood_ratios`, :meth:`together`).
    """

    @classmethod
    def from_bilby(
        cls,
        interferometers: Any,
        priors: Any,
        *,
        waveform_arguments: Mapping[str, Any] | None = None,
        fiducial_parameters: Mapping[str, float] | None = None,
        trigger_time: float | None = None,
        time_marginalization: bool = False,
        phase_marginalization: bool = False,
        distance_marginalization: bool = False,
        error_bound: float = DEFAULT_ERROR_BOUND,
        reference_frame: str = "sky",
        time_reference: str = "geocenter",
        parameter_conversion: Any = convert_to_lal_binary_neutron_star_parameters,
    ) -> ServiceLikelihood:
        """The likelihood of bilby's data, uploaded to the service that ``waveform_arguments`` name.

        Parameters
        ----------
        interferometers
            bilby's, with strain and noise; their bands, notches, geometry and calibration errors
            (``bilby.gw.calibration.CubicSpline``, the same nodes in all of them) are kept.
        priors
            bilby's, in whatever it can convert: chirp mass and mass ratio, component masses, symmetric mass ratio,
            Lambda-tilde. As in bilby, what is integrated over is fixed in them.
        waveform_arguments
            As of :func:`binary_neutron_star`.
        fiducial_parameters
            A binary near the maximum, by bilby's names: the likelihood is then by relative binning, right to
            ``error_bound``. Without it, it is that on the full grid.
        trigger_time
            GPS seconds near the merger; None for the middle of the prior of ``geocent_time``.
        time_marginalization, phase_marginalization, distance_marginalization
            As in bilby. Time and distance are integrated exactly, over priors that are uniform, and any smooth one of
            the distance, such as ``UniformSourceFrame``.
        error_bound
            By how much ln L by relative binning may differ from that on the full grid.
        reference_frame, time_reference
            As in bilby, ``"H1L1"`` and ``"H1"``: samples have ``zenith`` and ``azimuth``, and ``H1_time``. Times of a
            detector are not integrated over.
        parameter_conversion
            From the priors' parameters to bilby's source model's.

        Raises
        ------
        InvalidRequest
            Priors or detectors that a service's likelihood cannot have; says what to do.
        AnalysisInvalid
            As :func:`bnserve_inference.full_analysis` and ``relative_binning_analysis``.
        PackageMissing
            What builds analyses is not installed.
        """
        interferometers = InterferometerList(interferometers)
        arguments = dict(waveform_arguments or {})
        choice = read_choice(arguments)
        model = choice.find()
        marginalised = Marginalised(time_marginalization, phase_marginalization, distance_marginalization)
        fiducial = None if fiducial_parameters is None else parameter_conversion(dict(fiducial_parameters))[0]
        bound = build_analysis(
            interferometers, priors, model, arguments, choice, marginalised,
            fiducial=None if fiducial is None else binaries(fiducial), trigger_time=trigger_time,
            error_bound=error_bound, time_reference=time_reference,
        )  # fmt: skip
        frame = DetectorFrame(bound.analysis, reference_frame=reference_frame, time_reference=time_reference)
        generator = WaveformGenerator(
            duration=interferometers.duration, sampling_frequency=interferometers.sampling_frequency,
            start_time=interferometers.start_time, frequency_domain_source_model=binary_neutron_star,
            parameter_conversion=parameter_conversion, waveform_arguments=arguments,
        )  # fmt: skip
        frames = {"reference_frame": reference_frame, "time_reference": time_reference}
        return cls(interferometers, generator, bound, model, choice, marginalised, priors, frame, frames)

    def __init__(
        self,
        interferometers: Any,
        waveform_generator: Any,
        bound: Likelihood,
        model: WaveformModel,
        choice: Choice,
        marginalised: Marginalised,
        priors: Any,
        frame: DetectorFrame,
        frames: Mapping[str, str],
    ) -> None:
        self._bound, self._model, self._choice, self._frame = bound, model, choice, frame
        self._together: Together | None = None
        super().__init__(
            interferometers, waveform_generator, time_marginalization=marginalised.time,
            phase_marginalization=marginalised.phase, distance_marginalization=marginalised.distance, priors=priors,
            jitter_time=False, **frames,
        )  # fmt: skip

    @property
    def likelihood(self) -> Likelihood:
        """That of bnserve, which takes its names and counts what it was asked."""
        return self._bound

    def log_likelihood_ratio(self, parameters: Mapping[str, float] | None = None) -> float:
        """ln of the ratio to the likelihood of no signal, of one sample by bilby's names."""
        sample = self.parameters if parameters is None else parameters
        if self._together is not None:
            return self._together.log_likelihood(dict(sample))
        return float(self.log_likelihood_ratios([sample])[0])

    def log_likelihood_ratios(self, samples: Sequence[Mapping[str, float]] | Mapping[str, Any]) -> Floats:
        """As :meth:`log_likelihood_ratio` of N samples, ``(N,)``, in one request (two where the phase is not
        integrated over: its meaning depends on the waveform at the reference frequency).

        Parameters
        ----------
        samples
            A list of dictionaries, or a dictionary (or data frame) of vectors and numbers.
        """
        values = self._bound.log_likelihood(self._columns(samples))
        return np.where(np.isfinite(values), values, _NOTHING)

    def together(self, threads: int) -> Together:
        """A ``pool`` for ``bilby.run_sampler``, with ``queue_size=threads``: questions of all threads are one request.

        It is left behind when the likelihood is pickled or copied.
        """
        self._together = Together(self.log_likelihood_ratios, threads)
        return self._together

    def reconstructed(self, samples: Sequence[Mapping[str, float]] | Mapping[str, Any]) -> dict[str, Floats]:
        """A draw of what is integrated over for each of N samples, by its posterior given the rest, in one request.

        Parameters
        ----------
        samples
            As of :meth:`log_likelihood_ratios`.

        Returns
        -------
        Those of ``geocent_time``, ``phase``, ``luminosity_distance``, ``(N,)`` each. bilby's generator of random
        numbers (``bilby.core.utils.random``) is behind them.
        """
        columns, binary = self._columns_and_binaries(samples)
        uniforms = _uniforms(len(columns["mass_ratio"]), 4)
        drawn = self._bound.draw_marginalised(columns, seed=uniforms[:, :3].copy()).parameters
        found = {}
        if "coalescence_time" in drawn:  # over a time that is the merger's, without a shift
            found["geocent_time"] = drawn["coalescence_time"] + self._bound.analysis.settings.trigger_time
        if "reference_phase" in drawn:
            phase = 0.5 * (drawn["reference_phase"] - self._shifts(binary)[0])
            if all(order % 2 == 0 for _, order in modes_of(self._model.description, self._choice.modes)):
                phase = phase + np.where(uniforms[:, 3] < 0.5, 0.0, np.pi)  # half a turn changes nothing
            found["phase"] = phase % (2.0 * np.pi)
        if "distance_mpc" in drawn:
            found["luminosity_distance"] = drawn["distance_mpc"]
        return found

    def generate_posterior_sample_from_marginalized_likelihood(
        self, parameters: Mapping[str, float] | None = None
    ) -> dict[str, float]:
        """One sample with a draw of what is integrated over, by its posterior given the rest, whatever the modes."""
        sample = dict(self.parameters if parameters is None else parameters)
        if not self._marginalized_parameters:
            return sample
        return sample | {name: float(values[0]) for name, values in self.reconstructed([sample]).items()}

    def generate_phase_sample_from_marginalized_likelihood(
        self, signal_polarizations: Any = None, parameters: Mapping[str, float] | None = None
    ) -> float:
        """The phase of such a draw; bilby's own is a rule for m = 2."""
        return self.generate_posterior_sample_from_marginalized_likelihood(parameters)["phase"]

    def _columns(self, samples: Sequence[Mapping[str, float]] | Mapping[str, Any]) -> dict[str, Any]:
        return self._columns_and_binaries(samples)[0]

    def _columns_and_binaries(
        self, samples: Sequence[Mapping[str, float]] | Mapping[str, Any]
    ) -> tuple[dict[str, Any], dict[str, Floats]]:
        if isinstance(samples, Sequence):
            samples = {name: [sample[name] for sample in samples] for name in samples[0]}
        given = {name: np.asarray(samples[name], dtype=np.float64) for name in samples if _is_number(samples[name])}
        theirs, _ = self.waveform_generator.parameter_conversion(given)
        columns = binaries(theirs)
        settings = self._bound.analysis.settings
        shift, time = np.zeros(1), np.zeros(1)
        if not settings.phase_marginalisation or self._choice.zero_points.approximant is not None:
            shift, time = self._shifts(columns)
        relative = "zenith" in theirs and self.reference_frame != "sky"
        arrival = f"{self.time_reference}_time"  # "geocent" where it is that
        names = ("zenith", "azimuth") if relative else ("ra", "dec")
        placed = self._frame.to_sky(
            {name: theirs[name] for name in (*names, arrival if arrival in theirs else "geocent_time")}
        )
        ours = columns | {name: theirs[their_name] for name, their_name in _SAME.items()}
        ours |= {name: placed[name] for name in ("right_ascension", "declination", "coalescence_time")}
        ours["coalescence_time"] = ours["coalescence_time"] - time
        ours["reference_phase"] = 2.0 * np.asarray(theirs["phase"]) + shift
        whole: dict[str, Any] = dict(zip(ours, np.broadcast_arrays(*ours.values()), strict=True))
        if settings.calibration is not None:
            whole |= calibration_columns(settings.calibration, settings.detectors, theirs)
        return whole, columns

    def _shifts(self, columns: dict[str, Floats]) -> tuple[Floats, Floats]:
        zero_points, grid = self._choice.zero_points, self.waveform_generator.frequency_array
        last = stated(self.waveform_generator.waveform_arguments, "maximum_frequency", grid[-1])
        top = float(grid[np.searchsorted(grid, last, side="right") - 1])
        own = None
        if not is_single(self._model.description):
            own = orbital_turn(self._model, columns, zero_points.reference_frequency, "reference_frequency")
            if zero_points.approximant is None:
                return own, np.zeros(len(own))
        batch: dict[str, Any] = {**columns, "distance_mpc": 1.0, "inclination": 0.0}
        options = EvaluationOptions(alignment="merger", out_of_domain="flag", modes=None if own is None else QUADRUPOLE)
        h = self._model.predict_factored(zero_points.frequencies(top), batch, options=options).h
        return zero_points.shifts(np.asarray(h, dtype=np.complex128), columns, top, own)

    def _setup_distance_marginalization(self, lookup_table: Any = None) -> None:
        """bilby would tabulate its integral over the distance; here it is the service's."""

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"_together": None}


def _is_number(value: Any) -> bool:
    return np.asarray(value).dtype.kind in "fiub"


def _uniforms(*shape: int) -> Floats:
    """Numbers between 0 and 1 by bilby's generator, which is numpy's own in its oldest releases."""
    generator = getattr(utils, "random", None)
    if generator is None:
        return np.asarray(np.random.random_sample(shape))  # what these releases seed
    return np.asarray(generator.rng.random(shape))
