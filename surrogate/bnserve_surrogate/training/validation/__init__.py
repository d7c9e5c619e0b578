"""Training, fourth stage: what a model is worth on waveforms that it never saw."""
