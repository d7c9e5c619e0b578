"""HTTP as bytes and headers: listening, framing, negotiation, errors, answers, the fast path."""

__all__: list[str] = []
