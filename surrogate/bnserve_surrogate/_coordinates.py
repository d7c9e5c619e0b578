"""The coordinates in which a regressor sees the intrinsic parameters, used in training and at run time alike.

Residuals to the post-Newtonian baseline vary slowly in log q, in the mass-weighted powers of the tidal
deformabilities and in the spin combination of the leading spin-orbit phase; a polynomial in these needs far fewer
terms than one in the raw parameters.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, TypeAlias

import numpy as np
from numba.extending import register_jitable
from numpy.typing import ArrayLike, NDArray

from bnserve_protocol import InvalidParameters

FloatArray: TypeAlias = NDArray[np.float64]
Scalars: TypeAlias = float | FloatArray
CoordinateKind: TypeAlias = Literal["physical", "raw", "symmetric"]

PHYSICAL_COORDINATES = ("log_mass_ratio", "tide_1", "tide_2", "chi_hat", "chi_antisymmetric")
"""Names of what :func:`transform_physical` writes, in order."""
SYMMETRIC_COORDINATES = ("log_mass_ratio", "tide_difference", "tide_sum", "chi_hat", "chi_antisymmetric")
"""Names of what :func:`transform_symmetric` writes, in order."""
ANTISYMMETRIC_AXES = (0, 1, 4)
"""Of these, the ones that change sign, and nothing else, when the stars' labels are swapped: a product of Chebyshev
polynomials whose degrees in them add up to an odd number changes sign, one of an even number does not."""
TIDAL_EXPONENT = 0.4
"""Power of Lambda; anything from 0.3 to 0.45 does equally well, and log Lambda is a decade worse."""
SPIN_ORBIT_WEIGHT = 38.0 / 113.0
"""Share of eta (chi_1 + chi_2) taken off the mass-weighted spin in the leading spin-orbit phase (arXiv:1107.1267)."""


@register_jitable(error_model="numpy")
def transform_physical(
    mass_ratio: Scalars, chi_1: Scalars, chi_2: Scalars, lambda_1: Scalars, lambda_2: Scalars, out: FloatArray
) -> None:
    r"""Write log q, x_1 Lambda_1^0.4, x_2 Lambda_2^0.4, chi_hat and (chi_1 - chi_2)/2 to ``out[0]`` ... ``out[4]``.

    .. math:: x_i = m_i/M, \qquad \hat\chi = x_1 \chi_1 + x_2 \chi_2 - \tfrac{38}{113} \eta (\chi_1 + \chi_2)

    Pass floats and ``out`` of shape (5,), in Python or under ``numba.njit``; or, in Python, arrays of shape (N,) and
    ``out`` of shape (5, N). Nothing is validated: mass ratios must be positive, tidal deformabilities not negative.
    """
    x_1 = mass_ratio / (1.0 + mass_ratio)
    x_2 = 1.0 / (1.0 + mass_ratio)
    out[0] = np.log(mass_ratio)
    out[1] = x_1 * lambda_1**TIDAL_EXPONENT
    out[2] = x_2 * lambda_2**TIDAL_EXPONENT
    out[3] = x_1 * chi_1 + x_2 * chi_2 - SPIN_ORBIT_WEIGHT * x_1 * x_2 * (chi_1 + chi_2)
    out[4] = 0.5 * (chi_1 - chi_2)


@register_jitable(error_model="numpy")
def transform_symmetric(
    mass_ratio: Scalars, chi_1: Scalars, chi_2: Scalars, lambda_1: Scalars, lambda_2: Scalars, out: FloatArray
) -> None:
    r"""Write log q, t_1 - t_2, t_1 + t_2, chi_hat and (chi_1 - chi_2)/2 to ``out[0]`` ... ``out[4]``.

    .. math:: t_i = x_i \Lambda_i^{0.4}

    The rest is as for :func:`transform_physical`, whose arguments it takes.
    """
    transform_physical(mass_ratio, chi_1, chi_2, lambda_1, lambda_2, out)
    out[1], out[2] = out[1] - out[2], out[1] + out[2]


def physical_coordinates(theta: ArrayLike) -> FloatArray:
    """:func:`transform_physical` of the rows of ``theta``.

    Parameters
    ----------
    theta
        Shape (N, 5): mass_ratio, chi_1, chi_2, lambda_1, lambda_2.

    Returns
    -------
    ndarray, shape (N, 5), C-contiguous.
    """
    return _transformed(transform_physical, theta)


def symmetric_coordinates(theta: ArrayLike) -> FloatArray:
    """:func:`transform_symmetric` of the rows of ``theta``, as :func:`physical_coordinates`."""
    return _transformed(transform_symmetric, theta)


def _transformed(transform: Callable[..., None], theta: ArrayLike) -> FloatArray:
    columns = _as_rows(theta).T
    out = np.empty(columns.shape)
    transform(*columns, out)
    return np.ascontiguousarray(out.T)


def physical_bounds(lower: ArrayLike, upper: ArrayLike) -> tuple[FloatArray, FloatArray]:
    """Exact smallest and largest value of every physical coordinate in the box lower <= theta <= upper.

    Parameters
    ----------
    lower, upper
        Shape (5,), in the order of theta; tidal deformabilities >= 0, mass ratios > 0.

    Returns
    -------
    tuple of two ndarrays of shape (5,).

    Raises
    ------
    InvalidParameters
        If the box is empty or leaves the domain of the coordinates.
    """
    low, high = _as_box(lower, upper)
    # Coordinates 0, 1, 2, 4 are monotonic in every parameter: x_2 falls with q, chi_a falls with chi_2.
    at_low = physical_coordinates(
        [[low[0], low[1], high[2], low[3], low[4]], [high[0], low[1], low[2], low[3], low[4]]]
    )
    at_high = physical_coordinates(
        [[high[0], high[1], low[2], high[3], high[4]], [low[0], high[1], high[2], high[3], high[4]]]
    )
    minima, maxima = at_low[0], at_high[0]
    minima[2], maxima[2] = at_low[1, 2], at_high[1, 2]
    # chi_hat grows with both spins but need not be monotonic in q.
    minima[3] = min(_chi_hat_extremes(low[1], low[2], low[0], high[0]))
    maxima[3] = max(_chi_hat_extremes(high[1], high[2], low[0], high[0]))
    return minima, maxima


def symmetric_bounds(lower: ArrayLike, upper: ArrayLike) -> tuple[FloatArray, FloatArray]:
    """Exact smallest and largest value of every symmetric coordinate, as :func:`physical_bounds`."""
    low, high = _as_box(lower, upper)
    minima, maxima = physical_bounds(low, high)
    # t_1 - t_2 grows with q and Lambda_1 and falls with Lambda_2; t_1 + t_2 is linear in x_1 and grows with both.
    lambdas = [(low[3], high[4]), (high[3], low[4]), (low[3], low[4]), (high[3], high[4])]
    corners = [[q, 0.0, 0.0, *pair] for pair in lambdas for q in (low[0], high[0])]
    tides = symmetric_coordinates(corners)[:, 1:3]
    minima[1:3], maxima[1:3] = tides.min(axis=0), tides.max(axis=0)
    return minima, maxima


@dataclass(frozen=True, eq=False)
class CoordinateMap:
    """From intrinsic parameters to the regressor's inputs: ``(u(theta) - offset) * scale``.

    Attributes
    ----------
    kind
        ``"physical"``: u is :func:`physical_coordinates`; ``"symmetric"``: u is :func:`symmetric_coordinates`;
        ``"raw"``: u is theta itself.
    offset, scale
        Shape (5,). A coordinate that does not vary has scale zero.
    """

    kind: CoordinateKind
    offset: FloatArray
    scale: FloatArray

    def __post_init__(self) -> None:
        if self.kind not in _COORDINATES:
            raise ValueError(f"Unknown kind of coordinates '{self.kind}'; known are {sorted(_COORDINATES)}.")
        for name in ("offset", "scale"):
            array = np.array(getattr(self, name), dtype=np.float64)
            if array.shape != (5,) or not np.isfinite(array).all():
                raise ValueError(f"The {name} of a coordinate map must be five finite numbers; got {array}.")
            array.setflags(write=False)
            object.__setattr__(self, name, array)

    @classmethod
    def physical(cls, lower: ArrayLike, upper: ArrayLike) -> "CoordinateMap":
        """Physical coordinates, mapped to [-1, 1] over the box ``lower`` to ``upper``, (5,) in the order of theta."""
        return cls._between("physical", *physical_bounds(lower, upper))

    @classmethod
    def symmetric(cls, lower: ArrayLike, upper: ArrayLike) -> "CoordinateMap":
        """Symmetric coordinates over the box, in [-1, 1]; those that change sign with the labels fill half of it."""
        minima, maxima = symmetric_bounds(lower, upper)
        for axis in ANTISYMMETRIC_AXES:  # an offset would make an odd function of something else
            maxima[axis] = max(abs(minima[axis]), abs(maxima[axis]))
            minima[axis] = -maxima[axis]
        return cls._between("symmetric", minima, maxima)

    @classmethod
    def raw(cls, lower: ArrayLike, upper: ArrayLike) -> "CoordinateMap":
        """The parameters themselves, mapped to [-1, 1] over the box."""
        return cls._between("raw", *_as_box(lower, upper))

    @classmethod
    def standardised(cls, theta: ArrayLike) -> "CoordinateMap":
        """The paper's: parameters with mean 0 and standard deviation 1 over the rows of ``theta``, shape (N, 5)."""
        rows = _as_rows(theta)
        return cls("raw", rows.mean(axis=0), _reciprocal(rows.std(axis=0)))

    @classmethod
    def _between(cls, kind: CoordinateKind, minima: FloatArray, maxima: FloatArray) -> "CoordinateMap":
        return cls(kind, 0.5 * (minima + maxima), _reciprocal(0.5 * (maxima - minima)))

    def __call__(self, theta: ArrayLike) -> FloatArray:
        """Regressor inputs, shape (N, 5), for the rows of ``theta``, shape (N, 5)."""
        return (_COORDINATES[self.kind](theta) - self.offset) * self.scale


def _chi_hat_extremes(chi_1: float, chi_2: float, lowest_ratio: float, highest_ratio: float) -> list[float]:
    """Values of chi_hat, a quadratic in x_1, at the ends of the range of mass ratios and at its vertex if inside."""
    low, high = lowest_ratio / (1.0 + lowest_ratio), highest_ratio / (1.0 + highest_ratio)
    curvature = SPIN_ORBIT_WEIGHT * (chi_1 + chi_2)
    vertex = 0.5 * (curvature - chi_1 + chi_2) / curvature if curvature != 0.0 else low
    fractions = (low, high, min(max(vertex, low), high))
    return [x * chi_1 + (1.0 - x) * chi_2 - curvature * x * (1.0 - x) for x in fractions]


def _reciprocal(widths: FloatArray) -> FloatArray:
    """1 / widths, and 0 where a width is 0."""
    return np.where(widths > 0.0, 1.0 / np.where(widths > 0.0, widths, 1.0), 0.0)


def _as_rows(theta: ArrayLike) -> FloatArray:
    rows = np.asarray(theta, dtype=np.float64)
    if rows.ndim != 2 or rows.shape[1] != 5:
        raise ValueError(
            "Intrinsic parameters must have shape (N, 5), in the order mass_ratio, chi_1, chi_2, lambda_1, lambda_2; "
            f"got {rows.shape}."
        )
    return rows


_COORDINATES = {"physical": physical_coordinates, "symmetric": symmetric_coordinates, "raw": _as_rows}


def _as_box(lower: ArrayLike, upper: ArrayLike) -> tuple[FloatArray, FloatArray]:
    low, high = (_as_rows(np.asarray(corner, dtype=np.float64)[None])[0] for corner in (lower, upper))
    if not (low <= high).all():
        raise InvalidParameters(f"A parameter box needs lower <= upper for every parameter; got {low} and {high}.")
    if low[0] <= 0.0 or low[3] < 0.0 or low[4] < 0.0:
        raise InvalidParameters("Mass ratios must be positive and tidal deformabilities must not be negative.")
    return low, high
