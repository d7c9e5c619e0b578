"""The same waveform model, reached in different ways, each with the synchronous methods of ``WaveformModel``."""

import asyncio
import multiprocessing

from bnserve_client import AsyncModel

METHODS = (
    "predict",
    "predict_batch",
    "predict_modes",
    "predict_derivatives",
    "predict_factored",
    "predict_amplitude_phase",
    "time_until_merger",
    "predict_time_domain",
    "forecast",
    "signal_to_noise",
)


class Blocking:
    """An asynchronous model whose calls are waited for."""

    def __init__(self, address, name="default"):
        self._loop = asyncio.new_event_loop()
        self._model = self._loop.run_until_complete(AsyncModel.connect(address, name))

    @property
    def description(self):
        return self._model.description

    def close(self):
        self._loop.run_until_complete(self._model.close())
        self._loop.close()


class Forked:
    """A model whose every call happens in a forked child that inherited it."""

    def __init__(self, model):
        self._model = model

    @property
    def description(self):
        return self._model.description


def _waiting(name):
    def method(self, *arguments, **options):
        return self._loop.run_until_complete(getattr(self._model, name)(*arguments, **options))

    return method


def _forking(name):
    def method(self, *arguments, **options):
        context = multiprocessing.get_context("fork")
        here, there = context.Pipe(duplex=False)
        child = context.Process(target=_tell, args=(there, getattr(self._model, name), arguments, options))
        child.start()
        there.close()
        answer, error = here.recv()
        child.join()
        if error is not None:
            raise error
        return answer

    return method


def _tell(pipe, method, arguments, options):
    try:
        pipe.send((method(*arguments, **options), None))
    except Exception as error:
        pipe.send((None, error))


for _name in METHODS:
    setattr(Blocking, _name, _waiting(_name))
    setattr(Forked, _name, _forking(_name))
