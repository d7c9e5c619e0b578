"""What ``python -m benchmarks.accuracy`` says of models with several modes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.whole_waveform.measuring import Truth, measure
from benchmarks.whole_waveform.overlaps import Grid
from bnserve_store import Artifact
from bnserve_surrogate import Model
from bnserve_surrogate._artifact import SurrogateMetadata
from bnserve_surrogate.training.config import parse_configuration
from bnserve_surrogate.training.data.dataset import ResidualDataset
from bnserve_surrogate.training.data.generation import VALIDATION_NODES, Generation, configured_generator
from bnserve_surrogate.training.data.modes import ModeNodes
from bnserve_surrogate.training.data.sampling import EdgeSampling, Sampling, UniformSampling, carrier_band
from bnserve_surrogate.training.reduction.nodes import mode_nodes, smooth_nodes
from bnserve_surrogate.training.validation.measurement import QUANTILES

Row = dict[str, Any]
Arrays = dict[str, NDArray[np.float64]]
_SAMPLINGS: dict[str, Sampling] = {"uniform": UniformSampling(), "edges": EdgeSampling()}
_WHERE = {"uniform": "uniform", "edges": "on faces, edges, corners"}
CASES = {
    "maximised": "all modes; time and orbital phase maximised",
    "aligned": "all modes; nothing maximised, aligned at the merger",
    "carrier": "(2, 2) alone; time and phase maximised",
    "without": "all modes against (2, 2) of the generator alone",
}
"""What is measured of every binary, and how it is called."""


def waveforms(artifact: Artifact, kind: str, count: int, seed: int, work: Path, jobs: int) -> ResidualDataset:
    """Fresh waveforms of a model's generator with all modes: those that ``bnserve validate`` makes, and keeps."""
    metadata = SurrogateMetadata.read(artifact.manifest.metadata)
    configuration = parse_configuration(metadata.provenance["configuration"])
    generate = Generation(configuration, configured_generator(configuration), work, jobs)
    nodes = smooth_nodes(*carrier_band(configuration), VALIDATION_NODES, metadata.reference_mass)
    modes = ModeNodes(mode_nodes(configuration).modes, nodes)
    return generate(_SAMPLINGS[kind], f"validate {kind}", seed, count, nodes, nodes, modes=modes)


def measured_whole(artifact: Artifact, kind: str, count: int, seed: int, work: Path, jobs: int) -> Arrays:
    """:func:`~.measuring.measure` of a model at its reference mass; what is there already is not measured again."""
    metadata = SurrogateMetadata.read(artifact.manifest.metadata)
    dataset = waveforms(artifact, kind, count, seed, work, jobs)
    low, high = metadata.training_band
    # Rounding must not take the ends out of the band.
    band = low * (1.0 + 1e-9), high * (1.0 - 1e-9)
    grid = Grid.of(band, "ET-D", metadata.reference_mass, metadata.mass_ratio[1])
    folder = work / f"whole-{artifact.manifest.digest[7:23]}-{dataset.digest[:16]}-{count}-{seed}"
    model = Model.from_artifact(artifact)
    return measure(model, Truth.of(dataset, metadata.reference_mass), grid, seed, folder)


def whole_rows(artifact: Artifact, counts: dict[str, int], seed: int, work: Path, jobs: int) -> list[Row]:
    """One for every case and kind of binaries; none of a model that has (2, 2) alone."""
    metadata = SurrogateMetadata.read(artifact.manifest.metadata)
    if len(metadata.modes) < 2:
        return []
    name, rows = f"`{artifact.manifest.name}` {artifact.manifest.version}", []
    for kind, count in counts.items():
        found = measured_whole(artifact, kind, count, seed, work, jobs)
        known = np.isfinite(found["estimate"])
        above = float(np.mean(found["maximised"][known] > 3.0 * found["estimate"][known])) if known.any() else None
        rows += [
            {
                "model": name,
                "where": _WHERE[kind],
                "count": len(found[case]),
                "case": called,
                "mismatch": {level: float(np.quantile(found[case], at)) for level, at in QUANTILES.items()},
                "above_three_times_estimate": above if case == "maximised" else None,
            }
            for case, called in CASES.items()
        ]
    return rows


def mismatch_table(rows: list[Row], case: str) -> list[str]:
    """Lines in Markdown; ``case`` is the heading of what tells rows of the same binaries apart."""
    lines = [
        f"| model | binaries | {case} | {' | '.join(QUANTILES)} | above 3 x its estimate |",
        f"|---|---|---|{'---|' * len(QUANTILES)}---|",
    ]
    for row in rows:
        share = row["above_three_times_estimate"]
        values = " | ".join(f"{value:.1e}" for value in row["mismatch"].values())
        estimate = "" if share is None else f"{share:.2%}"
        lines.append(f"| {row['model']} | {row['count']:,} {row['where']} | {row['case']} | {values} | {estimate} |")
    return lines
