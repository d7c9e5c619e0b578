"""The compiled factorisation of whitened derivatives: signals in a network, their squares, and their QR."""

from bnserve_inference.fisher_kernel._assembly import load_factorisation

__all__ = ["load_factorisation"]
