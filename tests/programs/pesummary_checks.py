"""What PESummary has made of a result of ``bnserve analyse``.

    python tests/programs/pesummary_checks.py run_result.json posterior_samples.h5

Imports nothing of ours.
"""

import json
import sys
from pathlib import Path

import numpy as np
from pesummary.io import read

SHARED = (
    "chirp_mass",
    "mass_ratio",
    "luminosity_distance",
    "theta_jn",
    "geocent_time",
    "lambda_tilde",
    "log_likelihood",
)


def main() -> None:
    """Samples, priors, injection and evidence are those of the result; what PESummary derives is there."""
    ours = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    direct = read(sys.argv[1])
    found = read(sys.argv[2])
    samples, columns = found.samples_dict["ours"], ours["posterior"]["content"]
    for name in SHARED:
        assert name in direct.parameters, name
        assert {*np.asarray(samples[name])} <= {*columns[name]}, name
    for name in ("mass_1_source", "redshift", "chi_eff", "network_matched_filter_snr"):
        assert np.isfinite(np.asarray(samples[name], dtype=float)).all(), name
    assert np.isclose(direct.injection_parameters["chirp_mass"], ours["injection_parameters"]["chirp_mass"])
    evidence = float(found.extra_kwargs[0]["sampler"]["ln_evidence"])
    assert np.isclose(evidence, ours["log_evidence"], atol=1e-2), evidence
    print(f"PESummary: {len(samples[SHARED[0]])} samples, {len(samples)} parameters, ln Z {evidence}")


if __name__ == "__main__":
    main()
