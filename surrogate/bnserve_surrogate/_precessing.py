"""Batches in which binaries precess: rows that do are twisted, the others are evaluated as ever."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    DtypeName,
    EvaluationOptions,
    FieldError,
    GridLike,
    InvalidParameters,
    InvalidRequest,
    Mode,
    OutOfDomain,
    ParameterBatch,
    Polarizations,
    RowStatus,
    check_options,
)
from bnserve_protocol.wire import result_memory
from bnserve_surrogate._domain import refuse_overflow
from bnserve_surrogate.kernel import Output
from bnserve_surrogate.precession import followed, refuse_unfollowed, steps_between, twist

if TYPE_CHECKING:
    from bnserve_surrogate._evaluator import Evaluator

_KINDS = {"complex128": Output.POLARIZATIONS, "complex64": Output.POLARIZATIONS_SINGLE}
_MOST_SAMPLES = 2**21
"""Of modes in memory at the same time: 32 MiB."""
_TILE = 8
"""Rows that are followed together."""
_KERR = 1.0
"""The largest spin of a black hole, and beyond that of any star."""


def precessing_polarizations(
    evaluator: Evaluator, frequencies: GridLike, batch: ParameterBatch, options: EvaluationOptions, dtype: DtypeName
) -> Polarizations:
    """N waveforms, of binaries some of which have spins in the orbital plane.

    A row without has the bits that it has in a batch where nobody precesses. The estimated mismatch is that of the
    modes, by which a row is seen at its inclination if it does not precess.

    Raises
    ------
    InvalidRequest
        There is no reference frequency at which the spins are what they are said to be.
    InvalidParameters, OutOfDomain, OutOfBand, InvalidFrequencies
        As :meth:`~bnserve_surrogate.Model.predict`; spins that are no numbers or larger than that of a black hole, and
        more turns of precession than are followed.
    """
    check_options(options)
    if options.reference_frequency is None:
        raise InvalidRequest(
            "Spins in the orbital plane turn: say at which frequency of the (2, 2) mode they are what is given, for "
            "example options=EvaluationOptions(reference_frequency=20.0) for 20 Hz, or leave out chi_1x, chi_1y, "
            "chi_2x and chi_2y.",
            errors=[FieldError(reason="missing", parameter="reference_frequency")],
        )
    modes, f = options.modes or evaluator.modes, evaluator.frequencies(frequencies)
    turning, aligned = _turning(batch), ParameterBatch.unchecked(batch.values)
    # Modes of all at once are evaluated once, where nothing else is wanted of them and there is room.
    whole = turning.all() and len(batch) * len(modes) * len(f) <= _MOST_SAMPLES
    answer = evaluator.batch(frequencies, aligned, options, Output.STRAIN if whole else _KINDS[dtype])
    rows = _rows_to_twist(batch, turning, answer.status, options, f, modes)
    shape = len(batch), len(f)
    both = [result_memory.empty(shape, dtype) for _ in range(2)] if whole else [answer.first, answer.second]
    for array in both:
        array[turning & (answer.status != RowStatus.OK)] = complex(np.nan, np.nan)
    size = max(_TILE, _MOST_SAMPLES // max(1, len(modes) * len(f)) // _TILE * _TILE)
    for start in range(0, len(rows), size):
        some = rows[start : start + size]
        part = batch.rows(some)
        h = answer.first[some] if whole else evaluator.batch(f, aligned.rows(some), options, Output.STRAIN).first
        with np.errstate(over="ignore"):  # is refused, or flagged
            twisted = twist(f, modes, h.reshape(len(some), len(modes), len(f)), part, options.reference_frequency)
            both[0][some], both[1][some] = twisted
    refuse_overflow(batch, both, [], answer.status, options)
    return Polarizations(both[0], both[1], answer.status, answer.estimates)


def _turning(batch: ParameterBatch) -> NDArray[np.bool_]:
    """Which rows have spins in the orbital plane, ``(N,)``; what is not finite is one."""
    assert batch.in_plane is not None
    return np.asarray(batch.in_plane.any(axis=1))


def _rows_to_twist(
    batch: ParameterBatch,
    turning: NDArray[np.bool_],
    status: NDArray[np.uint8],
    options: EvaluationOptions,
    f: NDArray[np.float64],
    modes: tuple[Mode, ...],
) -> NDArray[np.intp]:
    """The numbers of the rows that precess and can be followed; the ``status`` of the others is said, or an error."""
    fine = turning & (status == RowStatus.OK)
    bad = _check_spins(batch, fine, options)
    status[bad > 0] = bad[bad > 0]
    fine &= bad == 0
    if not (fine.any() and len(f)):
        return np.flatnonzero(fine)
    assert options.reference_frequency is not None
    # Rows that are not fine stand for one that is.
    sane = ParameterBatch.unchecked(np.where(fine[:, None], batch.values, batch.values[np.argmax(fine)]))
    steps = steps_between(sane, options.reference_frequency, f, modes)
    if options.out_of_domain == "error":
        refuse_unfollowed(sane, options.reference_frequency, f, steps)
    reached = followed(sane, options.reference_frequency, steps)
    status[fine & ~reached] = RowStatus.OUT_OF_BAND
    return np.flatnonzero(fine & reached)


def _check_spins(batch: ParameterBatch, rows: NDArray[np.bool_], options: EvaluationOptions) -> NDArray[np.uint8]:
    """What is wrong with the spins of some rows, a RowStatus each; an error where that is not to be flagged."""
    assert batch.in_plane is not None
    finite = np.isfinite(batch.in_plane).all(axis=1)
    planes = np.nan_to_num(batch.in_plane).reshape(-1, 2, 2)
    along = np.stack([batch["chi_1"], batch["chi_2"]], axis=1)
    with np.errstate(over="ignore"):
        size = np.sqrt((planes**2).sum(axis=2) + along**2)
    fast = (size > _KERR).any(axis=1)
    status = np.where(finite, np.where(fast, RowStatus.OUT_OF_DOMAIN, RowStatus.OK), RowStatus.NOT_FINITE)
    status = np.where(rows, status, RowStatus.OK).astype(np.uint8)
    if options.out_of_domain == "flag" or not status.any():
        return status
    row = int(np.argmax(status > 0))
    if status[row] == RowStatus.NOT_FINITE:
        raise InvalidParameters(
            f"Row {row}: a spin in the orbital plane is not finite; give a number, or leave it out.",
            errors=[FieldError(reason="not finite", parameter="chi_1x", row=row)],
        )
    star = 1 + int(np.argmax(size[row] > _KERR))
    raise OutOfDomain(
        f"Row {row}: the spin of star {star} is {size[row, star - 1]:.4g} in all, larger than a black hole's can be; "
        f'make chi_{star}, chi_{star}x and chi_{star}y smaller. Use out_of_domain="flag" to get such rows back as NaN.',
        errors=[FieldError(reason="larger than 1 in all", parameter=f"chi_{star}x", row=row)],
    )
