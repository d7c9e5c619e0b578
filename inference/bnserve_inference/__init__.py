"""Likelihoods over any waveform model, local or remote."""

__all__: list[str] = []
