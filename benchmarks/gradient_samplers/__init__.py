"""A sampler with gradients on the likelihood of an event, beside the sampler of ``bnserve analyse``."""
