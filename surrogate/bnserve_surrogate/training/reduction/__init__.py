"""Training, second stage: few numbers for a waveform: nodes, the metric of the mismatch, principal components."""
