"""Mismatch of whole waveforms, F_plus h_plus + F_cross h_cross of all modes, to those of the generator.

:mod:`.overlaps` has the integrals and the maximum over time and orbital phase, :mod:`.measuring` the waveforms.
"""
