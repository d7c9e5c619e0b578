"""Where pickles of 0.1 look for the token of a model, for one version; it is in ``_settings``."""

from bnserve_client._settings import _taken_from

__all__ = ["_taken_from"]
