"""Measurements: figures of the paper, accuracy, timings. Each module says how to run it."""
