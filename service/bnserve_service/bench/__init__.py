"""Measuring an installation: what a waveform costs, where the time goes, and what a server does with it.

Imported by the ``bnserve bench`` command and by the repository's benchmarks, and by nothing that serves.
"""
