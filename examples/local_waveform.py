"""One waveform from the model that ships with bnserve, in this process: no server, no compiler.

From a checkout with bnserve installed:

    python examples/local_waveform.py
"""

import numpy as np

from bnserve_surrogate import Model, ParametersWithExtrinsic

model = Model.default()
parameters = ParametersWithExtrinsic(
    mass_ratio=1.2, lambda_1=400.0, lambda_2=600.0, chi_1=0.01, chi_2=0.0,
    distance_mpc=40.0, inclination=2.5, total_mass=2.76,
)  # fmt: skip

frequencies = np.geomspace(20.0, 2000.0, 7)  # Hz
h_plus, h_cross = model.predict(frequencies, parameters)  # complex, 1/Hz

print(f"{model.description.name} {model.description.version}: {model.description.citation}")
print(f"{'f / Hz':>8} {'|h+| Hz':>10} {'|hx| Hz':>10} {'until the merger / s':>22}")
for frequency, plus, cross in zip(frequencies, np.abs(h_plus), np.abs(h_cross), strict=True):
    left = model.time_until_merger(float(frequency), parameters)
    print(f"{frequency:8.1f} {plus:10.2e} {cross:10.2e} {left:22.6f}")
