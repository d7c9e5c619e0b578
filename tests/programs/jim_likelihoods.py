"""jim's likelihoods with bnserve's waveform, as they are, beside our own on the same data.

    python tests/programs/jim_likelihoods.py

``tests/programs.sh jim`` runs it, in an environment with jim. It fails where jim's full likelihood and ours differ by
more than 0.01, where its relative binning is off by more than 0.5 at samples around the signal, or a gradient is not
finite.
"""

import jax
import numpy as np

jax.config.update("jax_enable_x64", True)

import jax.numpy as jnp  # noqa: E402  (after the precision)
import ripplegw  # noqa: E402
from jimgw.core.single_event.data import PowerSpectrum  # noqa: E402
from jimgw.core.single_event.detector import get_H1, get_L1, get_V1  # noqa: E402
from jimgw.core.single_event.likelihood import (  # noqa: E402
    HeterodynedTransientLikelihoodFD,
    TransientLikelihoodFD,
)

import bnserve_jax.ripple  # noqa: E402, F401
from bnserve_inference import DetectorData, LikelihoodOptions, full_analysis, likelihood  # noqa: E402
from bnserve_protocol import PHASE_AT_REFERENCE, EvaluationOptions  # noqa: E402
from bnserve_surrogate import Model  # noqa: E402

DURATION, RATE, BAND, TRIGGER = 32.0, 4096.0, (40.0, 1024.0), 1187008882.4
FREQUENCIES = np.arange(int(DURATION * RATE / 2) + 1) / DURATION
SIGNAL = {
    "M_c": 1.1975, "eta": 0.2485, "s1_z": 0.02, "s2_z": 0.01, "lambda_1": 400.0, "lambda_2": 600.0, "d_L": 40.0,
    "phase_c": 0.4, "iota": 2.5, "ra": 3.45, "dec": -0.41, "psi": 0.3, "t_c": 0.01,
}  # fmt: skip
WIDTHS = {
    "M_c": 5e-5, "eta": 1e-3, "s1_z": 0.01, "lambda_1": 60.0, "d_L": 3.0, "t_c": 3e-4, "phase_c": 0.2, "iota": 0.1,
}  # fmt: skip
MODES = ((2, 2),)


def noise() -> np.ndarray:
    """A power spectral density like that of advanced detectors."""
    x = np.maximum(FREQUENCIES, 10.0) / 215.0
    return 3e-48 * (x**-4.14 - 5.0 * x**-2 + 111.0 * (1.0 - x**2 + x**4 / 2.0) / (1.0 + x**2 / 2.0))


def samples(count: int) -> dict[str, np.ndarray]:
    """Around the signal; mass ratios as far as equal stars."""
    random = np.random.default_rng(0)
    found = {name: value + WIDTHS.get(name, 0.0) * random.normal(size=count) for name, value in SIGNAL.items()}
    return found | {"eta": np.minimum(found["eta"], 0.25)}


def ours(detectors: list, given: dict[str, np.ndarray]) -> np.ndarray:
    """Our own full likelihood of jim's data."""
    start = TRIGGER - DURATION + 2.0
    inside = np.abs(FREQUENCIES - 0.5 * sum(BAND)) <= 0.5 * (BAND[1] - BAND[0])
    data = [
        DetectorData(one.name, np.where(inside, np.asarray(one.data.fd), 0.0), np.sqrt(noise()), start, DURATION)
        for one in detectors
    ]
    delta = np.sqrt(1.0 - 4.0 * given["eta"])
    binary = {
        "mass_ratio": (1.0 + delta) / (1.0 - delta),
        "chi_1": given["s1_z"],
        "chi_2": given["s2_z"],
        "lambda_1": given["lambda_1"],
        "lambda_2": given["lambda_2"],
        "distance_mpc": given["d_L"],
        "inclination": given["iota"],
        "total_mass": given["M_c"] * given["eta"] ** -0.6,
    }
    local, options = Model.default(), EvaluationOptions(modes=MODES, alignment="merger")
    phase = local.predict_amplitude_phase([BAND[0]], binary, options=options).phase[:, 0]
    binary |= {
        "reference_phase": np.remainder(2.0 * given["phase_c"] + PHASE_AT_REFERENCE - phase, 4.0 * np.pi),
        "right_ascension": given["ra"],
        "declination": given["dec"],
        "polarization_angle": given["psi"],
        "coalescence_time": given["t_c"],
    }
    settings = LikelihoodOptions(modes=MODES, response="static")
    analysis = full_analysis(data, trigger_time=TRIGGER, f_min=BAND[0], f_max=BAND[1], options=settings)
    return likelihood(local, analysis).log_likelihood(binary)


def main() -> None:
    """Compare, and print."""
    waveform = ripplegw.waveform("bnserve", f_ref=BAND[0], modes=MODES)
    detectors = [get_H1(), get_L1(), get_V1()]
    for one in detectors:
        one.set_psd(PowerSpectrum(jnp.asarray(noise()), jnp.asarray(FREQUENCIES)))
        one.inject_signal(DURATION, RATE, TRIGGER, waveform, dict(SIGNAL), *BAND, rng_key=jax.random.key(3))
    settings = {"f_min": BAND[0], "f_max": BAND[1], "trigger_time": TRIGGER}
    full = TransientLikelihoodFD(detectors, waveform, **settings)
    binned = HeterodynedTransientLikelihoodFD(
        detectors, waveform, **settings, reference_parameters=dict(SIGNAL), epsilon=0.3
    )
    given = samples(20)
    on_device = {name: jnp.asarray(values) for name, values in given.items()}
    exact = np.asarray(jax.lax.map(full.evaluate, on_device))
    fast, slopes = jax.jit(jax.vmap(jax.value_and_grad(binned.evaluate)))(on_device)
    apart, off = np.abs(exact - ours(detectors, given)).max(), np.abs(np.asarray(fast) - exact).max()
    print(f"ln L {exact.min():.2f} to {exact.max():.2f}: ours differs by {apart:.1e}, relative binning by {off:.1e}")
    assert apart < 0.01
    assert off < 0.5
    assert all(np.isfinite(np.asarray(slope)).all() for slope in slopes.values())


if __name__ == "__main__":
    main()
