"""The (2, 2) of a model, whatever other modes it has."""

import msgspec

from bnserve_protocol import DEFAULT_OPTIONS

_METHODS = ("predict", "predict_batch", "predict_modes", "predict_factored", "predict_amplitude_phase")


class OneMode:
    """A model whose every question names its mode.

    Parameters
    ----------
    model
        Has a (2, 2).
    """

    def __init__(self, model):
        self._model = model

    def __getattr__(self, name):
        method = getattr(self._model, name)
        if name not in _METHODS:
            return method

        def ask(frequencies, parameters, *, options=DEFAULT_OPTIONS, **settings):
            chosen = msgspec.structs.replace(options, modes=((2, 2),))
            return method(frequencies, parameters, options=chosen, **settings)

        return ask
