"""Requests and answers as they travel: the fields of their messages, and what each means."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

import msgspec

from bnserve_protocol._model import ModelIdentity
from bnserve_protocol._modes import MOST_MODES, Mode
from bnserve_protocol._options import DtypeName

OutputName: TypeAlias = Literal["polarizations", "factored", "amplitude_phase", "modes", "derivatives"]
LikelihoodOutput: TypeAlias = Literal["log_likelihood", "products", "draws", "gradients"]
ForecastOutput: TypeAlias = Literal["root", "errors", "covariance", "snr"]
MOST_NAMES = 64
"""Parameters, or detectors: more than a request has, so that the answer can still say which of them is unknown; still
more are a mistake or an attack, and would take a hundred times the memory of the body."""
NamedArrays: TypeAlias = Annotated[dict[str, msgspec.Raw], msgspec.Meta(max_length=MOST_NAMES)]


class GridBody(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True):
    """A grid as it travels; each of its forms has fields of its own."""

    f_min: float | None = None
    f_max: float | None = None
    delta_f: float | None = None
    frequencies: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    sha256: str | None = None


class WaveformBody(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True, kw_only=True):
    """A batch on a grid, and what to return, as it travels; the options are those of ``EvaluationOptions``.

    Parameters
    ----------
    parameters
        A map of named numbers or vectors, or with 'names' one [N, P] array.
    grid
        One of its three forms: uniform, its frequencies in Hz, or the digest of one that was uploaded.
    names
        Of the columns of 'parameters', where it is an array.
    output
        'modes': h_22, h_33, ... are the modes at the given distance; h_plus is the sum of plus_lm * h_lm, h_cross that
        of cross_lm * h_lm. 'derivatives', complex128 alone: these, and h_22_mass_ratio, h_22_lambda_1, ... (lambda_2,
        chi_1, chi_2, total_mass), what each changes by, with plus_slope_22 and cross_slope_22, what its factors change
        by with the inclination. 'factored' (h_plus = plus * h and h_cross = cross * h) and 'amplitude_phase' are of one
        mode, which the field 'modes' has to name where the model has several.
    dtype
        complex64 has a relative error of 2.5e-8, and |h| is so small (1e-24 1/Hz) that its square underflows in
        single precision: convert to double precision, or multiply by 1e22, before squaring. Amplitude and phase are
        float64 in any case.
    """

    parameters: msgspec.Raw
    grid: GridBody
    names: Annotated[list[str], msgspec.Meta(max_length=MOST_NAMES)] | None = None
    output: OutputName = "polarizations"
    dtype: DtypeName = "complex128"
    out_of_domain: Literal["error", "flag"] = "error"
    below_band: Literal["extend", "error"] = "extend"
    above_band: Literal["zero", "error"] = "zero"
    alignment: Literal["post_newtonian", "merger"] = "post_newtonian"
    modes: Annotated[list[Mode], msgspec.Meta(max_length=MOST_MODES)] | None = None
    reference_frequency: float | None = None


class LikelihoodBody(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True, kw_only=True):
    """A batch, as it travels.

    Parameters
    ----------
    parameters
        A map of named numbers or vectors, or with 'names' one [N, P] array. What is marginalised may be left out.
    names
        Of the columns of 'parameters', where it is an array.
    analysis
        Repeats the digest of the path, as 'sha256:...'.
    calibration_amplitude, calibration_phase
        By detector, [N, nodes]: errors at the calibration nodes of the analysis, relative and in radians.
    output
        'products': also inner products by detector, where all parameters have to be given and nothing is integrated.
        'draws': also a draw of what is integrated over, made of 'uniforms'; 'log_likelihood' is the one there.
        'gradients': also the derivatives of 'log_likelihood' with respect to what is not integrated over.
    uniforms
        [N, 3], with 'draws': numbers uniform in [0, 1), for the time, the phase and the distance.
    """

    parameters: msgspec.Raw
    names: Annotated[list[str], msgspec.Meta(max_length=MOST_NAMES)] | None = None
    analysis: str | None = None
    calibration_amplitude: NamedArrays = {}
    calibration_phase: NamedArrays = {}
    output: LikelihoodOutput = "log_likelihood"
    uniforms: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET


class LikelihoodAnswerBody(msgspec.Struct, kw_only=True):
    """The log-likelihoods of a batch, as they travel.

    Parameters
    ----------
    log_likelihood
        [N]: natural logarithm of the ratio to the likelihood of no signal. -inf, in JSON null, wherever 'status' is
        not 0.
    status
        [N]: 0 fine, 1 not finite, 2 out of domain, 3 out of band, 4 out of the analysis' prior.
    d_inner_h, h_inner_h
        [N, D], with 'products': <d|h>, complex, and <h|h> in each detector, in the order of the analysis; NaN wherever
        'status' is not 0.
    coalescence_time, reference_phase, distance_mpc
        [N], with 'draws': those that the analysis integrates over.
    gradient
        [N, P], with 'gradients': derivatives of 'log_likelihood'; NaN, in JSON null, wherever 'status' is not 0.
    gradient_names
        What these are with respect to: parameters, then errors at calibration nodes.
    """

    model: ModelIdentity
    analysis: str
    log_likelihood: msgspec.Raw
    status: msgspec.Raw
    d_inner_h: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    h_inner_h: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    coalescence_time: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    reference_phase: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    distance_mpc: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    gradient: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    gradient_names: tuple[str, ...] = ()


class ForecastBody(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True, kw_only=True):
    """Binaries to forecast in an uploaded network, as they travel; the options are those of ``ForecastOptions``.

    Parameters
    ----------
    parameters
        A map of named numbers or vectors, or with 'names' one [N, P] array.
    names
        Of the columns of 'parameters', where it is an array.
    network
        Repeats the digest of the path, as 'sha256:...'.
    coordinates
        Ten, to which right_ascension, declination and polarization_angle come; those of our client where left out.
    priors
        Widths of Gaussian priors by coordinate.
    reference_frequency
        Hz, at which the phase of the (2, 2) is held while other coordinates change.
    output
        'root', from which everything follows; 'errors', with the area of the sky; 'covariance', with both; or 'snr',
        the signal-to-noise ratios alone, many times as fast.
    """

    parameters: msgspec.Raw
    names: Annotated[list[str], msgspec.Meta(max_length=MOST_NAMES)] | None = None
    network: str | None = None
    coordinates: Annotated[list[str], msgspec.Meta(max_length=MOST_NAMES)] | None = None
    priors: Annotated[dict[str, float], msgspec.Meta(max_length=MOST_NAMES)] = {}
    modes: Annotated[list[Mode], msgspec.Meta(max_length=MOST_MODES)] | None = None
    alignment: Literal["post_newtonian", "merger"] = "merger"
    reference_frequency: float = 50.0
    output: ForecastOutput = "root"


class ForecastAnswerBody(msgspec.Struct, kw_only=True):
    """Forecasts of a batch, as they travel; numbers are NaN, in JSON null, wherever 'status' is not 0.

    Parameters
    ----------
    names
        Of the P = 13 coordinates.
    snr, detector_snr
        [N] and [N, D]: optimal signal-to-noise ratios, of the network and in each detector.
    status
        [N]: 0 fine, 1 not finite, 2 out of domain, 3 out of band.
    condition
        [N]: of the Fisher matrix with a unit diagonal; infinite, in JSON null, where it is not measured at all.
    singular
        [N]: 1 where the condition is beyond 1e14; errors are NaN then.
    beyond
        [N, P]: 1 where a standard deviation leaves the model's range.
    root
        [N, 91], with 'root': the upper triangle, row by row, of R; the Fisher matrix is R^T R.
    errors
        [N, P], with 'errors' and 'covariance': the standard deviation of each coordinate, the others unknown.
    sky_area
        [N], with these: square degrees that hold the source with a probability of 90 %.
    covariance
        [N, 91], with 'covariance': its upper triangle, row by row.
    """

    model: ModelIdentity
    network: str
    names: Annotated[list[str], msgspec.Meta(max_length=MOST_NAMES)]
    snr: msgspec.Raw
    detector_snr: msgspec.Raw
    status: msgspec.Raw
    condition: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    singular: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    beyond: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    root: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    errors: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    sky_area: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    covariance: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
