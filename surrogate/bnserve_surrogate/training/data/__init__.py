"""Training, first stage: waveforms of a generator over a box, as residuals to the baseline, kept on disk."""
