"""The one version number of every bnserve distribution."""

__version__ = "0.1.0"
