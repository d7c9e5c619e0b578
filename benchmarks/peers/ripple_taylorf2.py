"""ripple's TaylorF2 (JAX, jitted, double precision): the fastest that a post-Newtonian formula alone has been.

Install:

    python3.11 -m venv $PEERS/ripple
    $PEERS/ripple/bin/pip install ripplegw==0.4.1
"""

from __future__ import annotations

import sys
from typing import Any

import jax

jax.config.update("jax_enable_x64", True)

import jax.numpy as jnp  # noqa: E402 (after the precision is chosen)
import ripplegw  # noqa: E402
from worker import Peer, serve  # noqa: E402

NAMES = ("M_c", "eta", "s1_z", "s2_z", "lambda_1", "lambda_2", "d_L", "phase_c", "iota")


class RippleTaylorF2(Peer):
    """``ripplegw.waveform("TaylorF2")``; batches through ``jax.vmap``."""

    packages = ("ripplegw", "jax")

    def __init__(self, f_min: float) -> None:
        self.name = "ripple TaylorF2"
        self.f_min = f_min
        model = ripplegw.waveform("TaylorF2", f_ref=f_min)
        assert set(model.parameter_names) <= set(NAMES), model.parameter_names

        def both(grid: Any, values: Any) -> Any:
            strain = model(grid, dict(zip(NAMES, values, strict=True)))
            return strain["p"], strain["c"]

        self._one = jax.jit(both)
        self._many = jax.jit(jax.vmap(both, in_axes=(None, 0)))

    def grid(self, points: int) -> Any:
        """On the device before the clock starts."""
        return jnp.asarray(super().grid(points))

    def binary(self, parameters: dict[str, float]) -> Any:
        """One vector, in the order of :data:`NAMES`."""
        return jnp.asarray(self._values(parameters))

    def binaries(self, rows: list[dict[str, float]]) -> Any:
        """One array, a row for each."""
        return jnp.asarray([self._values(row) for row in rows])

    def waveform(self, grid: Any, binary: Any) -> Any:
        """Plus and cross polarisations, when they are there."""
        return jax.block_until_ready(self._one(grid, binary))

    def batch(self, grid: Any, binaries: Any) -> Any:
        """All rows in one call."""
        return jax.block_until_ready(self._many(grid, binaries))

    @staticmethod
    def _values(parameters: dict[str, float]) -> list[float]:
        q = parameters["mass_ratio"]
        eta = q / (1.0 + q) ** 2
        return [
            parameters["total_mass"] * eta**0.6,
            eta,
            *(parameters[name] for name in ("chi_1", "chi_2", "lambda_1", "lambda_2", "distance_mpc")),
            parameters["reference_phase"],
            parameters["inclination"],
        ]


if __name__ == "__main__":
    serve(RippleTaylorF2(float(sys.argv[1])))
