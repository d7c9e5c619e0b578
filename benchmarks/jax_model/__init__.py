"""The model in JAX beside the compiled kernel: ``python -m benchmarks.jax_model``."""
