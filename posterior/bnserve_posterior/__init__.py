"""From a likelihood to a posterior: :mod:`bnserve_posterior.sampling`."""

__all__: list[str] = []
