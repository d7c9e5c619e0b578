"""A waveform model of your own as the generator of a training: ``own_generator.toml`` names the function below.

    pip install '.[train]'
    PYTHONPATH=examples bnserve train examples/own_generator.toml --store my-models
    bnserve serve --store my-models

The extra needs a C compiler and GSL, for TEOBResumS, which this generator does without.

A generator is a function of one binary and a grid, in the convention h = amplitude * exp(-i psi). What it can depend on
is ``theta`` = (mass ratio, chi_1, chi_2, Lambda_1, Lambda_2); ``mf`` is G M f / c^3. The value at a frequency may not
depend on the other frequencies, and psi has to be continuous in ``theta``, its constant included: no ``np.unwrap`` of
angles. A function that raises loses that waveform, not the run.
"""

import numpy as np

from bnserve_surrogate.baseline import taylorf2_amplitude, taylorf2_phase


def resonant_tides(theta: np.ndarray, mf: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """TaylorF2 whose leading tidal term grows as the stars are driven towards the resonance of their f-modes.

    A toy in the spirit of Hinderer et al. 2016 (arXiv:1602.00599), with one resonance for both stars, at M f = 0.06.

    Parameters
    ----------
    theta:
        (5,), as above.
    mf:
        Increasing dimensionless frequencies, (n,).

    Returns
    -------
    Amplitude of h_plus of a face-on binary in units of nu M^2 / D_L, and psi in radians, both (n,).
    """
    mass_ratio, _, _, lambda_1, lambda_2 = theta
    x_1, x_2 = mass_ratio / (1.0 + mass_ratio), 1.0 / (1.0 + mass_ratio)
    tidal = ((1.0 + 11.0 * x_2) * x_1**4 * lambda_1 + (1.0 + 11.0 * x_1) * x_2**4 * lambda_2) * 16.0 / 13.0
    v = np.cbrt(np.pi * mf)
    leading = -(3.0 / (128.0 * x_1 * x_2)) * (39.0 / 2.0) * tidal * v**5
    driven = (mf / 0.06) ** 2
    amplitude = taylorf2_amplitude(mf, *theta[:3, np.newaxis])[0]
    psi = taylorf2_phase(mf, *theta[:, np.newaxis])[0] + 0.5 * driven * leading
    return amplitude, psi
