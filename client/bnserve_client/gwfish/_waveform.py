"""A model of bnserve as a waveform class of GWFish."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from bnserve_client._lal_meaning import polarisation_factors
from bnserve_client._lal_precession import precesses
from bnserve_client.gwfish._neighbours import neighbours
from bnserve_protocol import Mode

_DEFAULTS = dict.fromkeys(
    ("mass_1", "mass_2", "luminosity_distance", "redshift", "theta_jn", "phase", "geocent_time", "a_1", "tilt_1",
     "phi_12", "a_2", "tilt_2", "phi_jl", "lambda_1", "lambda_2"), 0.0,
)  # fmt: skip
"""GWFish's, of parameters that are not given."""
_ANGLES = tuple(name for name in _DEFAULTS if name not in ("luminosity_distance", "redshift", "geocent_time"))
_REFERENCE = 50.0
"""Hz; GWFish's ``DEFAULT_F_REF``."""


class Waveform:
    """A binary neutron star for GWFish's ``waveform_class``; a class of GWFish by what it does, not by inheritance.

    The derivatives of a Fisher matrix ask for waveforms one by one, most of them many times. Here the first step of a
    derivative brings all others in one batch, with the bits that each has alone, and they are kept until the next
    binary. Distance, orientation, time and phase are factors, unless spins are in the orbital plane: such waveforms are
    asked for one by one.

    Parameters
    ----------
    name
        The model of the service at ``BNSERVE_URL`` (or of this process, without one): GWFish's ``waveform_model``.
    gw_params
        GWFish's parameters, in its names and units: masses in any of its ways, ``a_1``, ``tilt_1``, ``lambda_1``, ...
    data_params
        ``frequencyvector``, Hz, ``(M,)`` or ``(M, 1)``; ``f_ref``, Hz, at which ``phase`` is that of the orbit.

    Attributes
    ----------
    modes : sequence of (l, m), or None
        Of the class: all that the model has (None). Another class chooses:
        ``class Quadrupole(Waveform): modes = [(2, 2)]``.
    gw_params : dict
        All parameters, with ``mass_1`` and ``mass_2``.
    frequencyvector : numpy.ndarray
        ``(M,)``.
    """

    modes: ClassVar[Sequence[Mode] | None] = None

    def __init__(self, name: str, gw_params: Mapping[str, Any], data_params: Mapping[str, Any]) -> None:
        self.name, self.data_params = name, data_params
        self.frequencyvector: NDArray[np.float64] = np.squeeze(data_params["frequencyvector"])
        self._given: dict[str, Any] = {}
        self.update_gw_params(gw_params)

    def update_gw_params(self, new_gw_params: Mapping[str, Any]) -> None:
        """Take other values of parameters; those that are not named stay."""
        from GWFish.modules.auxiliary import check_and_convert_to_mass_1_mass_2

        self._given |= dict(new_gw_params)
        self.gw_params: dict[str, Any] = _DEFAULTS | check_and_convert_to_mass_1_mass_2(self._given)

    @property
    def t_of_f(self) -> Any:
        """GPS seconds at which the signal passes each frequency, ``(M,)``; GWFish's own."""
        from GWFish.modules.waveforms import t_of_f_PN

        return t_of_f_PN(self.gw_params, self.frequencyvector)

    @property
    def frequency_domain_strain(self) -> NDArray[np.complex128]:
        """The polarisations, ``(M, 2)``, in 1/Hz, with GWFish's sign: the complex conjugate of LAL's.

        Raises
        ------
        OutOfDomain
            Outside the range of the model; GWFish's default, no tides, may be so.
        InvalidRequest
            A mode that the model lacks, or a spin in the orbital plane where it has no precession.
        PackageMissing, ConnectionFailed, ModelUnknown, Unauthorized, ...
            As :func:`bnserve_client.Model.connect`, and without an address where no models are installed.
        """
        given = self.gw_params
        reference = float(self.data_params.get("f_ref", _REFERENCE))
        around = neighbours(self.name, self.modes, reference, self.frequencyvector)
        angles = {name: float(given[name]) for name in _ANGLES}
        if precesses(angles):
            strain = around.seen(angles)
        else:
            factors = polarisation_factors(around.modes, angles["theta_jn"], angles["phase"])
            strain = np.stack([factors["plus"], factors["cross"]]) @ around.strain(self._given)
        turn = np.exp(-2j * np.pi * given["geocent_time"] * self.frequencyvector) / given["luminosity_distance"]
        found: NDArray[np.complex128] = (strain * turn).conj().T
        return found

    def __call__(self) -> NDArray[np.complex128]:
        """As :attr:`frequency_domain_strain`."""
        return self.frequency_domain_strain
