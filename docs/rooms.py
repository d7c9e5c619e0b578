"""The rooms, in the order of who needs them first: of the pages that are made from the code."""

ROOMS = ("client", "protocol", "surrogate", "inference", "posterior", "jax_model", "model_store", "service")
