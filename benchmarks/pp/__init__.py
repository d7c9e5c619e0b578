"""Percentile-percentile test of the likelihoods and the sampler: ``python -m benchmarks.pp``."""
