"""How a question is asked: precision, modes, phase and time, and what becomes of what lies outside."""

from __future__ import annotations

import inspect
from collections.abc import Sequence
from typing import Literal, TypeAlias, get_args

import msgspec
import numpy as np
from numpy.typing import DTypeLike

from bnserve_protocol._errors import FieldError, InvalidRequest
from bnserve_protocol._given import as_positive_number
from bnserve_protocol._modes import Mode, as_modes

DtypeName: TypeAlias = Literal["complex128", "complex64"]
_DTYPES: tuple[DtypeName, ...] = get_args(DtypeName)


def check_dtype(dtype: DTypeLike) -> DtypeName:
    """The name of a precision, which may be given as numpy takes it (``np.complex64``, ``np.dtype("c8")``).

    Raises
    ------
    InvalidRequest
        It is not offered.
    """
    if isinstance(dtype, str) and dtype in _DTYPES:
        return dtype
    try:
        name = None if dtype is None else np.dtype(dtype).name
    except (TypeError, ValueError):
        name = None
    for offered in _DTYPES:
        if name == offered:
            return offered
    raise InvalidRequest(f"dtype must be one of {', '.join(_DTYPES)}; got {str(dtype)[:40]!r}.")


def check_options(options: EvaluationOptions) -> None:
    """Refuse what are no options.

    Raises
    ------
    InvalidRequest
        It is something else than :class:`EvaluationOptions`.
    """
    if not isinstance(options, EvaluationOptions):
        raise InvalidRequest(
            f"'options' must be EvaluationOptions; got {type(options).__name__}. Leave it out for the defaults, or "
            'write for example options=EvaluationOptions(alignment="merger").'
        )


class EvaluationOptions(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How to treat what lies outside the trained box and band, where phase and time are zero, and which modes count.

    Parameters
    ----------
    out_of_domain
        ``"error"``: a row outside the trained range is an error; ``"flag"``: such rows come back NaN, with a
        :class:`RowStatus`.
    below_band
        ``"extend"`` continues the waveform with the post-Newtonian baseline at every frequency below the band;
        ``"error"``: a frequency below it is an error (``OutOfBand``). So low that double precision
        leaves nothing of the phase (M f below 1e-9), a frequency is an error in any case.
    above_band
        ``"zero"`` returns zeros at every frequency above the band, also where the whole grid is; ``"error"``: a
        frequency above it is an error (``OutOfBand``). Neither depends on what else is asked for at the same time.
    alignment
        ``"post_newtonian"``: time and phase of the TaylorF2 baseline, as in the paper. ``"merger"``: the merger is
        at t = 0, as in TEOBResumS.
    modes
        ``(l, m)`` of those that count, such as ``[(2, 2), (3, 3)]``, each with its mirror image ``(l, -m)``. None: all
        that the model has.
    reference_frequency
        Hz; the frequency of the (2, 2) mode at which ``reference_phase`` is twice the orbital phase, as ``f_ref`` and
        ``phiRef`` of LAL. None: ``reference_phase`` is added to the phase of the alignment. Above a binary's band it is
        an error (``OutOfBand``).

    Raises
    ------
    InvalidRequest
        A value that is not offered.
    """

    out_of_domain: Literal["error", "flag"] = "error"
    below_band: Literal["extend", "error"] = "extend"
    above_band: Literal["zero", "error"] = "zero"
    alignment: Literal["post_newtonian", "merger"] = "post_newtonian"
    modes: tuple[Mode, ...] | None = None
    reference_frequency: float | None = None

    def __post_init__(self) -> None:
        for name, known in _CHOICES.items():
            value = getattr(self, name)
            if not (isinstance(value, str) and value in known):
                raise InvalidRequest(f"{name} must be one of {', '.join(known)}; got {str(value)[:40]!r}.")
        if self.modes is not None:
            msgspec.structs.force_setattr(self, "modes", as_modes(self.modes))
        if self.reference_frequency is not None:
            name = "reference_frequency"
            frequency = as_positive_number(name, self.reference_frequency, "Hz", otherwise=", or None")
            msgspec.structs.force_setattr(self, name, frequency)


_KINDS = inspect.get_annotations(EvaluationOptions, eval_str=True)
_CHOICES = {name: get_args(kind) for name, kind in _KINDS.items() if isinstance(get_args(kind)[0], str)}
DEFAULT_OPTIONS = EvaluationOptions()


def chosen_modes(options: EvaluationOptions, known: Sequence[Mode]) -> tuple[Mode, ...]:
    """The modes that the options ask for, in their order; all that are ``known`` where they name none.

    Raises
    ------
    InvalidRequest
        One is not among the known.
    """
    if options.modes is None:
        return tuple(known)
    for mode in options.modes:
        if mode not in known:
            there = ", ".join(map(str, known))
            hint = f" {(mode[0], -mode[1])} stands for it, too." if (mode[0], -mode[1]) in known else ""
            raise InvalidRequest(
                f"This model has no mode {mode}; it has {there}.{hint}",
                errors=[FieldError(reason=f"not among {there}", parameter="modes", value=str(mode))],
            )
    return options.modes


def plain_options(options: EvaluationOptions, known: Sequence[Mode]) -> EvaluationOptions:
    """Options that ask for the same, naming no modes where these are all that are ``known`` in their order.

    So they are equal to those that name none, and are understood by who knows nothing of modes.

    Raises
    ------
    InvalidRequest
        As :func:`chosen_modes`.
    """
    if options.modes is None or chosen_modes(options, known) != tuple(known):
        return options
    return msgspec.structs.replace(options, modes=None)


def the_mode(options: EvaluationOptions, known: Sequence[Mode]) -> Mode:
    """The one mode that is asked for, of those that are ``known``, by what has no meaning for several: a factored
    strain, an amplitude and a phase.

    Raises
    ------
    InvalidRequest
        There are several; or one is not among the known.
    """
    chosen = chosen_modes(options, known)
    if len(chosen) != 1:
        asked = "this model has" if options.modes is None else "you chose"
        raise InvalidRequest(
            f"A factored strain, or an amplitude and a phase, belongs to one mode, and {asked} {len(chosen)}: choose "
            "one with modes=[(2, 2)], or ask for each of them with predict_modes.",
            errors=[FieldError(reason="not exactly one", parameter="modes")],
        )
    return chosen[0]
