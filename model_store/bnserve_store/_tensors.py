"""The one gate between arrays and safetensors.

safetensors 0.8.0 writes the memory of an array that is not C-contiguous in the wrong order without saying so (and
scikit-learn's PCA returns Fortran order), and has no complex128. Nothing else in bnserve imports it.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from typing import Any

import numpy as np
import safetensors.numpy
from numpy.typing import ArrayLike, NDArray
from safetensors import SafetensorError

from bnserve_protocol import InternalError, InvalidRequest
from bnserve_protocol.wire import refuse_repeated_keys
from bnserve_store._names import check_tensor_name

DTYPES = ("<f8", "<f4", "<f2", "<i8", "<i4", "<i2", "|i1", "<u8", "<u4", "<u2", "|u1", "|b1")
"""The only array types that are stored."""


def prepare_tensors(tensors: Mapping[str, ArrayLike]) -> dict[str, NDArray[Any]]:
    """The same values as C-contiguous, little-endian arrays, sorted by name; the given arrays are untouched.

    Raises
    ------
    InvalidRequest
        A name or dtype that cannot be stored (complex: store two real arrays), or a value that is not finite.
    """
    return {name: _prepare(name, tensors[name]) for name in sorted(tensors, key=str)}


def _prepare(name: str, tensor: ArrayLike) -> NDArray[Any]:
    check_tensor_name(name)
    given = np.asarray(tensor)
    little = given.dtype.newbyteorder("<") if given.dtype.kind in "fiubc" else given.dtype
    if little.str not in DTYPES:
        hint = "store its real and imaginary parts as two tensors" if given.dtype.kind == "c" else "convert it"
        raise InvalidRequest(f"Tensor '{name}' has dtype {given.dtype}, which cannot be stored: {hint}.")
    # ascontiguousarray turns numbers into vectors of one, hence the reshape.
    array = np.ascontiguousarray(given, dtype=little).reshape(given.shape)
    if not is_finite(array):
        raise InvalidRequest(f"Tensor '{name}' holds NaN or infinite values; such a model would serve nonsense.")
    return array


def is_finite(array: NDArray[Any]) -> bool:
    """Whether no value is NaN or infinite."""
    return array.dtype.kind != "f" or bool(np.isfinite(array).all())


def tensor_digest(array: NDArray[Any]) -> str:
    """SHA-256, in hexadecimal, of the values of a C-contiguous, little-endian array."""
    return hashlib.sha256(array.reshape(-1).view(np.uint8).data).hexdigest()


def encode_tensors(arrays: Mapping[str, NDArray[Any]]) -> bytes:
    """The bytes of a safetensors file, read back and compared before they are returned.

    Parameters
    ----------
    arrays:
        As :func:`prepare_tensors` returns them.
    """
    data: bytes = safetensors.numpy.save(dict(arrays))
    back = decode_tensors(data)
    same = set(back) == set(arrays) and all(_same(back[name], array) for name, array in arrays.items())
    if not same:
        raise InternalError("safetensors did not read back what was written; nothing was stored. Please report this.")
    return data


def _same(left: NDArray[Any], right: NDArray[Any]) -> bool:
    return left.dtype == right.dtype and left.shape == right.shape and tensor_digest(left) == tensor_digest(right)


def decode_tensors(data: bytes) -> dict[str, NDArray[Any]]:
    """Read the bytes of a safetensors file as C-contiguous, read-only arrays.

    Raises
    ------
    ValueError
        Not a safetensors file, or one with array types that we never write.
    """
    try:
        arrays: dict[str, NDArray[Any]] = safetensors.numpy.load(data)
        refuse_repeated_keys(data[8 : 8 + int.from_bytes(data[:8], "little")])  # its header
    except (SafetensorError, KeyError, ValueError, TypeError, OverflowError) as error:
        raise ValueError("not a complete safetensors file") from error
    for array in arrays.values():
        array.setflags(write=False)
    return arrays
