"""What the service promises, measured: one module per promise, with real servers and real load.

``python -m benchmarks.reliability --list`` names them. A module is called after its promise and has

* a docstring whose first line is the promise,
* ``MECHANISM``: how it is kept, in two sentences,
* ``BAR``: what the measurement must reach, in words,
* ``INJECTED_FAULTS``: what takes the mechanism away, each with what it does, so that the measurement is seen to fail,
* ``run(short, log, injected=None)``: measure, and return an :class:`~benchmarks.reliability.outcome.Outcome`.
"""
