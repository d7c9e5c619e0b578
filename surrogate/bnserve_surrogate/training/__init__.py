"""Training: waveforms of a generator in, a published model out. Needs the extra `train`."""
