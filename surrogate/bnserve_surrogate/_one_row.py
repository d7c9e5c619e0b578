"""Where the kernel reads and writes one waveform, the shortest way."""

from __future__ import annotations

import ctypes
import threading
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import PARAMETER_NAMES
from bnserve_protocol.wire import address_of

FEW = 4096
"""Frequencies up to which one waveform is copied from where the kernel writes it."""


class OneRow(threading.local):
    """Room at known addresses for one waveform, since finding out an array's address takes longer than a copy."""

    def __init__(self, modes: int) -> None:
        self.parameters = (ctypes.c_double * len(PARAMETER_NAMES))()
        self.parameters_at = ctypes.addressof(self.parameters)
        self.rest = (ctypes.c_double * (2 + 3 * modes))()
        self.estimate = ctypes.addressof(self.rest)
        self.status, self.plus, self.cross = self.estimate + 8, self.estimate + 16, self.estimate + 16 + 8 * modes
        self.frequencies = np.empty(FEW)
        self.frequencies_at = address_of(self.frequencies)
        wide = np.empty((2, FEW), np.complex128)
        self.results: dict[str, NDArray[Any]] = {
            "complex128": wide,
            "complex64": wide.view(np.complex64).reshape(4, FEW)[:2],
        }
        self.results_at = address_of(wide)
