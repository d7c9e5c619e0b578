"""The model as one of ripple's waveforms, so that jim's likelihoods and samplers run with it as they are.

Importing this registers it: ``ripplegw.waveform("bnserve", f_ref=20.0)``. ripplegw and jim are the user's to install.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import jax.numpy as jnp
from jax import Array
from jax.typing import ArrayLike
from ripplegw.interfaces import DistanceScaledWaveform, FrequencyDomainWaveform
from ripplegw.registry import register

from bnserve_jax._model import Model
from bnserve_protocol import Mode


@register("bnserve", is_tidal=True, source_type="cbc")
class Waveform(DistanceScaledWaveform, FrequencyDomainWaveform):
    """A binary neutron star, by ripple's names: ``M_c``, ``eta``, ``s1_z``, ``s2_z``, ``lambda_1``, ``lambda_2``,
    ``d_L`` (Mpc), ``phase_c``, ``iota``.

    As in ripple's other models the first star is the heavier one, the phase is the orbital one at ``f_ref`` (that of
    LAL's ``phiRef``) and the merger is at time zero. Outside the model's ranges it is NaN.

    Parameters
    ----------
    f_ref
        Hz.
    model
        A loaded one, or the name of one that ships with the package.
    modes
        Those that count; None: all that the model has.

    Raises
    ------
    ModelUnknown, InvalidRequest
        There is no such model, or JAX computes in single precision.
    """

    def __init__(
        self, f_ref: float = 20.0, *, model: Model | str = "default", modes: Sequence[Mode] | None = None
    ) -> None:
        self.f_ref = f_ref
        self._model = Model.load(model) if isinstance(model, str) else model
        self._modes = modes

    @property
    def parameter_names(self) -> tuple[str, ...]:
        """The names of what it takes."""
        return ("M_c", "eta", "s1_z", "s2_z", "lambda_1", "lambda_2", "d_L", "phase_c", "iota")

    def __call__(self, axis: ArrayLike, /, params: Mapping[str, ArrayLike]) -> dict[str, Array]:
        """``{"p": h_plus, "c": h_cross}``, complex ``(M,)`` in 1/Hz, on frequencies in Hz; zero at zero."""
        axis = jnp.asarray(axis, jnp.float64)
        positive = axis > 0.0  # jim begins at zero where it makes data
        eta = jnp.asarray(params["eta"])
        binary = {
            "mass_ratio": mass_ratio(eta),
            "lambda_1": params["lambda_1"],
            "lambda_2": params["lambda_2"],
            "chi_1": params["s1_z"],
            "chi_2": params["s2_z"],
            "distance_mpc": params["d_L"],
            "inclination": params["iota"],
            "total_mass": params["M_c"] * eta**-0.6,
            "reference_phase": 2.0 * jnp.asarray(params["phase_c"]),
        }
        plus, cross = self._model.predict(
            jnp.where(positive, axis, self.f_ref),
            binary,
            modes=self._modes,
            alignment="merger",
            reference_frequency=self.f_ref,
        )
        return {"p": jnp.where(positive, plus, 0.0), "c": jnp.where(positive, cross, 0.0)}


def mass_ratio(eta: Array) -> Array:
    """m_1 / m_2 >= 1 of a symmetric mass ratio; one above 1/4, which rounding may leave, with no slope."""
    rest = 1.0 - 4.0 * eta
    unequal = rest > 0.0
    delta = jnp.where(unequal, jnp.sqrt(jnp.where(unequal, rest, 1.0)), 0.0)
    return (1.0 + delta) / (1.0 - delta)
