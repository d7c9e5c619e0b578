"""Double precision, which the model needs and JAX has to be told about."""

import numpy as np
from jax import dtypes

from bnserve_protocol import InvalidRequest


def require_double_precision() -> None:
    """Refuse to go on in single precision: phases reach 1e5 radians, of which it leaves 0.016.

    The setting is one of the whole process, so that it is the program's to make and not a library's.

    Raises
    ------
    InvalidRequest
        JAX computes in single precision.
    """
    if dtypes.canonicalize_dtype(np.float64) != np.float64:
        raise InvalidRequest(
            "JAX computes in single precision, in which the phase of a waveform is off by 0.016 radians; call "
            'jax.config.update("jax_enable_x64", True), or set JAX_ENABLE_X64=1, before anything else uses JAX.'
        )
