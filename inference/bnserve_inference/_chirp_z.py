"""A sum of exponentials at many times, by Bluestein's algorithm."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


class ChirpZ:
    """X_k = sum_j x_j exp(-2 pi i j k ``turn``) for k below ``outputs``, of vectors of ``inputs`` numbers.

    ``turn`` may be any number: no step of time is forced upon the user, and times that are not wanted cost nothing.
    """

    def __init__(self, inputs: int, outputs: int, turn: float) -> None:
        self._inputs, self._outputs = inputs, outputs
        size = 1 << (inputs + outputs - 2).bit_length() if inputs + outputs > 2 else 1
        places = np.arange(max(inputs, outputs), dtype=np.float64)
        chirp = np.exp(-1j * np.pi * np.fmod(turn * places * places, 2.0))
        self._before, self._after = chirp[:inputs], chirp[:outputs]
        kernel = np.zeros(size, dtype=np.complex128)
        kernel[:outputs] = chirp[:outputs].conj()
        kernel[size - inputs + 1 :] = chirp[1:inputs][::-1].conj()
        self._kernel = np.fft.fft(kernel)

    def __call__(self, vector: NDArray[np.complex128]) -> NDArray[np.complex128]:
        """Complex ``(outputs,)`` of complex ``(inputs,)``."""
        transformed = np.fft.fft(vector * self._before, len(self._kernel))
        result: NDArray[np.complex128] = np.fft.ifft(transformed * self._kernel)[: self._outputs] * self._after
        return result
