"""What a request will cost, before it is decoded: as much as others of its kind did.

Refusing is only cheap when it comes before the work: decoding a batch of thousands of rows costs several times as much
as all the rest of a refusal, and a server under ten times its load does little else.
"""

from __future__ import annotations

from collections import OrderedDict

WORTH_IT = 2**12
"""Bodies below this are decoded in less time than it takes to think about it."""
_KINDS = 4096
_FORGET = 0.1


class CostEstimates:
    """Remembers what bodies of about the same size from the same owner cost, leaning towards the cheapest."""

    def __init__(self) -> None:
        self._costs: OrderedDict[tuple[str, int], float] = OrderedDict()

    def cost(self, owner: str, size: int) -> int | None:
        """What a body of ``size`` bytes may cost; None when nothing is known."""
        known = self._costs.get((owner, size.bit_length())) if size >= WORTH_IT else None
        return None if known is None else int(known)

    def learn(self, owner: str, size: int, cost: int) -> None:
        """One was decoded, and cost so much."""
        if size < WORTH_IT:
            return
        kind = owner, size.bit_length()
        known = self._costs.pop(kind, cost)
        self._costs[kind] = cost if cost < known else known + _FORGET * (cost - known)
        if len(self._costs) > _KINDS:
            self._costs.popitem(last=False)
