"""The figures of inference, from one command: ``python -m benchmarks.inference``."""
