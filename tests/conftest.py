"""Settings for every test."""

from hypothesis import settings

# Tests never assert on time: shared machines pause.
settings.register_profile("bnserve", deadline=None, derandomize=True)
settings.load_profile("bnserve")
