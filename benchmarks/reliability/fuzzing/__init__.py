"""Coverage-guided fuzzing (atheris) of everything that reads foreign bytes; see :mod:`tests.fuzz.targets`."""
