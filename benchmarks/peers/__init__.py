"""Waveforms of others and of bnserve, timed in one run: ``python -m benchmarks.peers``."""
