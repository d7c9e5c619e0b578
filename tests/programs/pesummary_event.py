"""Writes the configuration of a small event, which is sampled in seconds."""

import sys

from tests.posterior.networks import TOML

if __name__ == "__main__":
    sys.stdout.write(TOML)
