"""Precession from its definition: vectors that all turn in one frame, and rotated harmonics as sums over m'."""

import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.baseline import spin_induced_quadrupole

Z = np.array([0.0, 0.0, 1.0])


class Orbit:
    """Spins, the orbit's direction and an axis in its plane that turns no more than it must, against 1 / (M omega).

    The axes are LAL's at the reference frequency: z along the orbital angular momentum, x from star 2 to star 1.
    """

    def __init__(self, q, chi_1, chi_2, lambda_1, lambda_2):
        self.x1, self.x2 = q / (1 + q), 1 / (1 + q)
        self.nu, self.delta = self.x1 * self.x2, self.x1 - self.x2
        self.kappa = [float(spin_induced_quadrupole(value)) for value in (lambda_1, lambda_2)]
        self.lambdas = lambda_1, lambda_2
        self.spins = self.x1**2 * np.array(chi_1), self.x2**2 * np.array(chi_2)

    def omega(self, star, v, s_own, s_other, axis):
        """The angular velocity of one spin, over M."""
        own, other = (self.x1, self.x2) if star == 0 else (self.x2, self.x1)
        nu, delta = self.nu, own - other
        nlo = 9 / 16 + 5 / 4 * nu - nu**2 / 24 + delta * (-9 / 16 + 5 / 8 * nu)
        nnlo = 27 / 32 + 3 / 16 * nu - 105 / 32 * nu**2 - nu**3 / 48
        nnlo += delta * (-27 / 32 + 39 / 8 * nu - 5 / 32 * nu**2)
        orbit = (v**5 * (2 * nu + 1.5 * other**2) + v**7 * nlo + v**9 * nnlo) * axis
        spin_spin = 0.5 * v**6 * (s_other - 3 * (s_other @ axis) * axis)
        return orbit + spin_spin - 1.5 * v**6 * self.kappa[star] * other / own * (s_own @ axis) * axis

    def l_dot(self, v, axis, s1, s2, ds1, ds2):
        """dL/dt: J does not change while the orbit does not shrink."""
        size = 1 + v**2 * (1.5 + self.nu / 6) + v**4 * (27 / 8 - 19 / 8 * self.nu + self.nu**2 / 24)
        share = -(ds1 + ds2)
        for x, spin, change in ((self.x1, s1, ds1), (self.x2, s2, ds2)):
            share = share + self.nu * v**2 * 0.25 * (3 + 1 / x) * change
            size -= v**3 / 12 * (1 + 27 / x) * (spin @ axis)
        change = share * v / (self.nu * size)
        return change - (change @ axis) * axis

    def omega_dot(self, v, axis, s1, s2):
        """M^2 d omega / dt."""
        nu, pi = self.nu, math.pi
        z = s1 @ axis, s2 @ axis
        sigma = 247 / (48 * nu) * (s1 @ s2) - 721 / (48 * nu) * z[0] * z[1]
        tides, linear = 0.0, np.zeros(4)
        for x, s, along, kappa, tide in zip((self.x1, self.x2), (s1, s2), z, self.kappa, self.lambdas, strict=True):
            sigma += (5 / 2 * kappa * (s @ s - 3 * along**2) - 7 / 96 * (s @ s) + along**2 / 96) / x**2
            other = (1 - x) / x
            linear += along * np.array(
                [
                    113 / 12 + 25 / 4 * other,
                    31319 / 1008 - 1159 / 24 * nu + other * (809 / 84 - 281 / 8 * nu),
                    pi * (75 / 2 + 151 / 6 * other),
                    130325 / 756 - 796069 / 2016 * nu + 100019 / 864 * nu**2
                    + other * (1195759 / 18144 - 257023 / 1008 * nu + 2903 / 32 * nu**2),
                ]
            )  # fmt: skip
            tides += 6 * x**4 * (12 - 11 * x) * tide
        a6 = 16447322263 / 139708800 + 16 / 3 * pi**2 - 856 / 105 * math.log(16) - 1712 / 105 * np.euler_gamma
        a6 += nu * (451 / 48 * pi**2 - 56198689 / 217728) + 541 / 896 * nu**2 - 5605 / 2592 * nu**3
        series = [
            1, 0, -743 / 336 - 11 / 4 * nu, 4 * pi - linear[0],
            34103 / 18144 + 13661 / 2016 * nu + 59 / 18 * nu**2 - sigma,
            -4159 / 672 * pi - 189 / 8 * pi * nu - linear[1],
            a6 - 1712 / 315 * math.log(v**3) - linear[2],
            -4415 / 4032 * pi + 358675 / 6048 * pi * nu + 91495 / 1512 * pi * nu**2 - linear[3],
            0, 0, tides,
        ]  # fmt: skip
        return 96 / 5 * nu * v**11 * np.polynomial.polynomial.polyval(v, series)

    def velocity(self, y, state):
        """d state / d y for y = 1 / omega."""
        s1, s2, axis, e = state.reshape(4, 3)
        v = y ** (-1 / 3)
        ds1, ds2 = np.cross(self.omega(0, v, s1, s2, axis), s1), np.cross(self.omega(1, v, s2, s1, axis), s2)
        dl = self.l_dot(v, axis, s1, s2, ds1, ds2)
        de = -(dl @ e) * axis
        return np.concatenate([ds1, ds2, dl, de]) / -(y**2 * self.omega_dot(v, axis, s1, s2))

    def frames(self, y_reference, y):
        """Rotations from the orbit's frame to that of the reference frequency, at each ``y``, (M,)."""
        start = np.concatenate([*self.spins, Z, [1.0, 0.0, 0.0]])
        matrices = np.empty((len(y), 3, 3))
        for side in (y >= y_reference, y < y_reference):
            places, which = np.unique(np.abs(y[side] - y_reference), return_inverse=True)
            if not len(places):
                continue
            sign = 1 if y[side][0] >= y_reference else -1
            followed = solve_ivp(
                lambda distance, state, sign=sign: sign * self.velocity(y_reference + sign * distance, state),
                (0.0, places[-1] + 1e-9), start, "DOP853", places, rtol=1e-8, atol=1e-10,
            )  # fmt: skip
            axis, e = followed.y[6:9].T, followed.y[9:12].T
            matrices[side] = np.stack([e, np.cross(axis, e), axis], axis=-1)[which]
        return Rotation.from_matrix(matrices)


def wigner_d(degree, m, s, theta):
    """Wigner's small d, from its sum."""
    total = 0.0
    for k in range(max(0, m - s), min(degree + m, degree - s) + 1):
        scale = math.sqrt(math.prod(math.factorial(degree + n) for n in (m, -m, s, -s)))
        scale /= math.prod(map(math.factorial, (degree + m - k, degree - s - k, k, k - m + s)))
        power = 2 * k - m + s
        total = total + (-1) ** k * scale * np.cos(theta / 2) ** (2 * degree - power) * np.sin(theta / 2) ** power
    return total


def harmonic(degree, m, theta, phi):
    """The spin-weighted harmonic of weight -2, with the signs of LAL."""
    return math.sqrt((2 * degree + 1) / (4 * math.pi)) * wigner_d(degree, m, 2, theta) * np.exp(1j * m * phi)


def rotated(degree, m, frames, theta, phi):
    """The harmonic (l, m) of a frame that is turned, in a direction that is not: the sum over m'."""
    w, x, y, z = np.moveaxis(frames.as_quat(), -1, 0)[[3, 0, 1, 2]]
    beta = 2 * np.arctan2(np.hypot(x, y), np.hypot(w, z))
    half_sum, half_difference = np.arctan2(z, w), np.arctan2(-x, y)
    alpha, gamma = half_sum + half_difference, half_sum - half_difference
    return sum(
        harmonic(degree, n, theta, phi) * np.exp(-1j * (n * alpha + m * gamma)) * wigner_d(degree, n, m, beta)
        for n in range(-degree, degree + 1)
    )


def polarizations(f, modes, h, binary, reference_frequency):
    """What :func:`bnserve_surrogate.precession.twist` returns for one binary, from its definition."""
    orbit = Orbit(
        binary.mass_ratio, (binary.chi_1x, binary.chi_1y, binary.chi_1), (binary.chi_2x, binary.chi_2y, binary.chi_2),
        binary.lambda_1, binary.lambda_2,
    )  # fmt: skip
    unit = 1 / (math.pi * binary.total_mass * SOLAR_MASS_SECONDS)
    phi = 0.5 * math.pi - 0.5 * binary.reference_phase  # of the line of sight: pi / 2 less the orbital phase
    plus, cross = np.zeros((2, len(f)), complex)
    orders = sorted({m for _, m in modes})
    all_of_them = orbit.frames(unit / reference_frequency, np.concatenate([m * unit / (2 * f) for m in orders]))
    for (degree, m), mode in zip(modes, h, strict=True):
        first = orders.index(m) * len(f)
        frames = all_of_them[first : first + len(f)]
        there = rotated(degree, m, frames, binary.inclination, phi).conj()
        mirrored = (-1) ** degree * rotated(degree, -m, frames, binary.inclination, phi)
        own = mode * np.exp(1j * m * phi) / math.sqrt(5 / (4 * math.pi))  # with phases as of that frame
        plus += (there + mirrored) * own
        cross += -1j * (there - mirrored) * own
    return plus, cross
