"""The paper's figures, each from one command: ``python -m benchmarks.figures NAME|all [--short] [--work DIR]``."""
