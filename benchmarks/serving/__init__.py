"""The same model behind bnserve and behind general model servers: ``python -m benchmarks.serving``."""
