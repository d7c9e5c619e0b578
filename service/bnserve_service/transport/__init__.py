"""HTTP as bytes and headers: bodies, negotiation, answers, middlewares, the hardened protocol. No physics."""

__all__: list[str] = []
