"""HTTP as bytes and headers: listening, framing, negotiation, access, answers."""

__all__: list[str] = []
