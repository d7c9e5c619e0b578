"""The waveform model as functions of JAX arrays."""

from __future__ import annotations

import os
from collections.abc import Sequence
from functools import partial
from math import pi
from typing import Any, NamedTuple, Self

import jax
import jax.numpy as jnp
from jax import Array, lax
from jax.typing import ArrayLike

from bnserve_jax._carrier import Alignment, Band
from bnserve_jax._modes import Form, Row, carrier_of, mode_strain, polarizations, prepare, with_tail
from bnserve_jax._parameters import Binary, BinaryLike, as_binary, as_frequencies, is_evaluated, named_parameters
from bnserve_jax._points import Grid
from bnserve_jax._precision import require_double_precision
from bnserve_jax._slopes import strain_and_slopes
from bnserve_jax._weights import Tensors, Weights, read_weights
from bnserve_protocol import (
    DERIVATIVE_NAMES,
    PARAMETER_NAMES,
    PHASE_AT_REFERENCE,
    EvaluationOptions,
    Mode,
    ModelDescription,
    check_names,
    chosen_modes,
)  # fmt: skip
from bnserve_store import Artifact, ModelStore
from bnserve_surrogate import Model as LocalModel
from bnserve_surrogate import SurrogateMetadata
from bnserve_surrogate.kernel import EDGE, NODE_TOLERANCE


class Model:
    """A trained surrogate as pure functions of JAX arrays: ``jit``, ``vmap`` and ``grad`` go through all of it.

    It reads the artifacts of :class:`bnserve_surrogate.Model` and agrees with it to 1e-9 of the strain. What is known
    before any number is, the modes, the alignment and the reference frequency, are arguments that are compiled in.
    Nothing can be raised from compiled code: what the model does not know (a parameter outside its range, a distance
    of zero) is NaN, as with ``out_of_domain="flag"``; below the band the waveform goes on with the post-Newtonian
    baseline, above it is zero.

    Parameters
    ----------
    artifact
        Verified, from a :class:`bnserve_store.ModelStore`.

    Raises
    ------
    InvalidRequest
        JAX computes in single precision.
    ArtifactIncomplete, ArtifactCorrupted
        Tensors are missing or do not fit together.
    """

    def __init__(self, artifact: Artifact) -> None:
        require_double_precision()
        self._description = LocalModel.from_artifact(artifact).description
        metadata = SurrogateMetadata.read(artifact.manifest.metadata)
        self._weights = read_weights(metadata, artifact.tensors, self._description.parameters)
        self._form = _form(metadata, artifact.tensors)

    @classmethod
    def default(cls) -> Self:
        """The model called ``default``, which ships with the package: 5 to 2048 Hz."""
        return cls.load("default")

    @classmethod
    def load(cls, name: str, version: str = "stable", store: str | os.PathLike[str] | ModelStore | None = None) -> Self:
        """A model from a store; None is that of the models that ship with the package.

        Raises
        ------
        ModelUnknown, StoreUnknown, ArtifactError
            There is no such model or version, no such store, or the artifact is damaged.
        InvalidRequest
            JAX computes in single precision.
        """
        if store is not None and not isinstance(store, ModelStore):
            store = ModelStore(store)
        return cls((ModelStore.default() if store is None else store).load(name, version))

    @property
    def description(self) -> ModelDescription:
        """Name, version, digest, ranges, band, accuracy."""
        return self._description

    def predict(
        self,
        frequencies: ArrayLike,
        parameters: BinaryLike,
        *,
        modes: Sequence[Mode] | None = None,
        alignment: Alignment = "post_newtonian",
        reference_frequency: float | None = None,
    ) -> tuple[Array, Array]:
        """h_plus and h_cross, complex ``(..., M)`` in 1/Hz.

        Parameters
        ----------
        frequencies
            Hz, ``(M,)``, positive, in any order.
        parameters
            By name, numbers or arrays of one shape ``(...)``, such as ``(N,)`` for a batch.
        modes, alignment, reference_frequency
            As in :class:`bnserve_protocol.EvaluationOptions`.

        Raises
        ------
        InvalidParameters
            A name is unknown or missing, or spins are in the orbital plane.
        InvalidRequest
            A mode, alignment or reference frequency that is not offered, frequencies that are no list, or JAX computes
            in single precision.
        """
        chosen = self._chosen(modes, alignment, reference_frequency)
        return self._each(_polarizations, chosen, frequencies, parameters)

    def predict_mode(
        self,
        frequencies: ArrayLike,
        parameters: BinaryLike,
        mode: Mode = (2, 2),
        *,
        alignment: Alignment = "post_newtonian",
        reference_frequency: float | None = None,
    ) -> Array:
        """h_lm, complex ``(..., M)`` in 1/Hz, as ``predict_factored`` has it; all else as :meth:`predict`."""
        chosen = self._chosen([mode], alignment, reference_frequency)
        return self._each(_strain, chosen, frequencies, parameters)

    def predict_amplitude_phase(
        self,
        frequencies: ArrayLike,
        parameters: BinaryLike,
        *,
        alignment: Alignment = "post_newtonian",
        reference_frequency: float | None = None,
    ) -> tuple[Array, Array]:
        """Amplitude in 1/Hz and continuous phase in radians of the (2, 2), ``(..., M)``; else as :meth:`predict`."""
        chosen = self._chosen([(2, 2)], alignment, reference_frequency)
        return self._each(_amplitude_phase, chosen, frequencies, parameters)

    def predict_derivatives(
        self,
        frequencies: ArrayLike,
        parameters: BinaryLike,
        names: Sequence[str] = DERIVATIVE_NAMES,
        mode: Mode = (2, 2),
        *,
        alignment: Alignment = "post_newtonian",
        reference_frequency: float | None = None,
    ) -> tuple[Array, Array]:
        """h_lm as :meth:`predict_mode`, and its derivatives, complex ``(..., P, M)``, with respect to P parameters.

        For less than ``jax.jacfwd`` of the strain, which has a sine and a cosine for each of them.

        Raises
        ------
        InvalidParameters
            A name is unknown; and as :meth:`predict`.
        InvalidRequest
            As :meth:`predict`.
        """
        check_names(names, PARAMETER_NAMES, PARAMETER_NAMES)
        chosen = self._chosen([mode], alignment, reference_frequency)._replace(names=tuple(names))
        found: tuple[Array, Array] = self._each(_derivatives, chosen, frequencies, parameters)
        return found

    def _chosen(self, modes: Sequence[Mode] | None, alignment: Alignment, reference: float | None) -> Chosen:
        options = EvaluationOptions(
            out_of_domain="flag",
            alignment=alignment,
            modes=None if modes is None else tuple(modes),
            reference_frequency=reference,
        )
        return Chosen(
            self._form, chosen_modes(options, self._description.modes), alignment, options.reference_frequency
        )

    def _each(self, evaluate: Any, chosen: Chosen, frequencies: ArrayLike, parameters: BinaryLike) -> Any:
        """Evaluate one binary, or each of an array of them."""
        require_double_precision()
        grid = Grid.of(as_frequencies(frequencies))
        return _compiled(evaluate, chosen, self._weights, grid, named_parameters(parameters))


_TOGETHER = 16
"""Rows that a processor evaluates together, so that what they need stays in its caches; other devices take all."""


class Chosen(NamedTuple):
    """What is compiled in."""

    form: Form
    modes: tuple[Mode, ...]
    alignment: Alignment
    reference: float | None
    names: tuple[str, ...] = ()
    """What is differentiated with respect to."""


@partial(jax.jit, static_argnums=(0, 1))
def _compiled(evaluate: Any, chosen: Chosen, weights: Weights, grid: Grid, parameters: dict[str, ArrayLike]) -> Any:
    binaries = as_binary(parameters)

    def one(branches: bool, binary: Binary) -> Any:
        own = chosen._replace(form=chosen.form._replace(branches=branches))
        return evaluate(own, weights, grid, binary)

    shape = binaries["mass_ratio"].shape
    if not shape:
        return lax.platform_dependent(binaries, cpu=partial(one, True), default=partial(one, False))
    rows = {name: values.reshape(-1) for name, values in binaries.items()}
    found = lax.platform_dependent(
        rows,
        cpu=partial(lax.map, partial(one, True), batch_size=_TOGETHER),
        default=jax.vmap(partial(one, False)),
    )
    return jax.tree.map(lambda values: values.reshape(*shape, *values.shape[1:]), found)


def _prepared(chosen: Chosen, weights: Weights, grid: Grid, binary: Binary) -> Row:
    """A row, of NaN amplitude where the model does not know the binary."""
    slowest = max(order for _, order in chosen.modes)
    row = prepare(weights, chosen.form, binary, chosen.modes, chosen.alignment)
    known = is_evaluated(binary, weights.lowest, weights.highest, grid.f, slowest)
    carrier = row.carrier
    if chosen.reference is not None:
        turn, reached = _turn_to(chosen.reference, chosen.form, weights, row, binary)
        carrier, known = carrier._replace(constant=carrier.constant + turn), known & reached
    series, factor = carrier.series, jnp.where(known, 1.0, jnp.nan)
    series = series._replace(amplitude=series.amplitude * factor, frozen=series.frozen * factor)
    return with_tail(weights, chosen.form, row._replace(carrier=carrier._replace(series=series)), chosen.modes)


def _turn_to(frequency: float, form: Form, weights: Weights, row: Row, binary: Binary) -> tuple[Array, Array]:
    """What makes half of ``reference_phase`` the orbital phase at a frequency in Hz, and whether it is in the band."""
    phase = carrier_of(weights, form, row, Grid.of(jnp.asarray([frequency])), 2)[1][0]
    own = phase - binary["reference_phase"] - 2.0 * pi * frequency * binary["time_shift"]
    # A period of 4 pi, so that the phases of all modes keep their digits.
    return jnp.remainder(PHASE_AT_REFERENCE - own, 4.0 * pi), frequency * row.mass <= form.band.last * (1.0 + EDGE)


def _polarizations(chosen: Chosen, weights: Weights, grid: Grid, binary: Binary) -> tuple[Array, Array]:
    row = _prepared(chosen, weights, grid, binary)
    return polarizations(weights, chosen.form, row, grid, chosen.modes, binary["inclination"])


def _strain(chosen: Chosen, weights: Weights, grid: Grid, binary: Binary) -> Array:
    return mode_strain(weights, chosen.form, _prepared(chosen, weights, grid, binary), grid, chosen.modes[0])


def _amplitude_phase(chosen: Chosen, weights: Weights, grid: Grid, binary: Binary) -> tuple[Array, Array]:
    return carrier_of(weights, chosen.form, _prepared(chosen, weights, grid, binary), grid, 2)


def _derivatives(chosen: Chosen, weights: Weights, grid: Grid, binary: Binary) -> tuple[Array, Array]:
    def prepared(changed: Array) -> Row:
        return _prepared(chosen, weights, grid, binary | dict(zip(chosen.names, changed, strict=True)))

    changed = jnp.stack([binary[name] for name in chosen.names])
    return strain_and_slopes(weights, chosen.form, prepared, changed, grid, chosen.modes[0])


def _form(metadata: SurrogateMetadata, tensors: Tensors) -> Form:
    mode, (lowest, last) = metadata.carrier, metadata.mf_band
    node = max(float(tensors[f"22/{name}_nodes"][0]) for name in ("amplitude", "phase"))
    first = node if node < lowest * (1.0 - NODE_TOLERANCE) else lowest
    exponents = {name.removesuffix("/polynomial_exponents"): t for name, t in tensors.items() if "exponents" in name}
    degrees = {"22": 0} | {name: int(t.max(initial=0)) for name, t in exponents.items()}
    return Form(
        coordinates=mode.coordinates,
        activation=mode.activation,
        least_lambda=metadata.least_trained_lambda,
        band=Band(first, last, mode.merger_start_mf),
        degrees=tuple(degrees.items()),
        powers=tuple((name, ratio.ratio_power) for name, ratio in metadata.ratios.items()),
    )
