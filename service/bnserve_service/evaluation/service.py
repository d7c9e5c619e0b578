"""The use case behind ``POST .../waveforms``: a body in, a packed answer out. Knows no HTTP."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any, TypeVar

from bnserve_protocol import GridLike, Overloaded, TooLarge, UniformGrid, grid_digest
from bnserve_protocol.wire import DigestName, GridDigest, WaveformRequest, decode_request, request_digest
from bnserve_service.admission.control import Capacity, CostEstimates, Lifecycle
from bnserve_service.admission.queue import Job, WorkQueue
from bnserve_service.evaluation.waveforms import Packed, Question, grid_key
from bnserve_service.models.registry import LoadedModel, Registry
from bnserve_service.settings import Settings
from bnserve_service.uploads.stores import GridStore

T = TypeVar("T")

OFF_LOOP = 2**17
"""Bodies above this are hashed and decoded in a thread: 128 KiB take about as long as the hand-over costs."""


class WaveformService:
    """Decode, look up, admit, evaluate.

    Parameters
    ----------
    settings:
        The limits.
    registry, grids, queue, lifecycle:
        Where models and grids are, who evaluates, and whether new work is accepted.
    """

    def __init__(
        self,
        settings: Settings,
        registry: Registry,
        grids: GridStore,
        queue: WorkQueue[Question, Packed],
        lifecycle: Lifecycle,
    ) -> None:
        self._limits = settings.limits()
        self._registry = registry
        self._grids = grids
        self._queue = queue
        self._cost_estimates = CostEstimates()
        self._lifecycle = lifecycle
        self._helper = ThreadPoolExecutor(1, thread_name_prefix="bnserve-decode")
        self._promised = Capacity(settings.max_answer_bytes)

    async def large_or_small(self, size: int, function: Any, *arguments: Any) -> Any:
        """Call ``function`` at once for small bodies and in a helper thread for large ones."""
        if size <= OFF_LOOP:
            return function(*arguments)
        return await asyncio.get_running_loop().run_in_executor(self._helper, function, *arguments)

    def close(self) -> None:
        """Stop the helper thread."""
        self._helper.shutdown(wait=False, cancel_futures=True)

    def digest_now(self, body: bytes) -> str:
        """:meth:`digest`, for small bodies."""
        return request_digest(body)

    async def digest(self, body: bytes) -> str:
        """SHA-256 of a request body, in hexadecimal."""
        return await self.large_or_small(len(body), request_digest, body)

    async def ask(
        self, name: str, version: str | None, body: bytes, media_type: str, answer_type: str, digest: DigestName
    ) -> Question:
        """Decode and check a request.

        Raises
        ------
        Draining, ModelUnknown, ModelLoading, UndecodableBody, InvalidParameters, InvalidFrequencies, GridUnknown,
        TooLarge
        """
        if len(body) <= OFF_LOOP:
            return self.ask_now(name, version, body, media_type, answer_type, digest)
        self._lifecycle.check_accepting()
        model = self._registry.find(name, version)
        loop = asyncio.get_running_loop()
        decoded = await loop.run_in_executor(self._helper, self._decode, body, media_type)
        return self._question(model, decoded, answer_type, digest)

    def ask_now(
        self, name: str, version: str | None, body: bytes, media_type: str, answer_type: str, digest: DigestName
    ) -> Question:
        """:meth:`ask`, for small bodies."""
        self._lifecycle.check_accepting()
        model = self._registry.find(name, version)
        return self._question(model, self._decode(body, media_type), answer_type, digest)

    def _question(
        self, model: LoadedModel, decoded: tuple[WaveformRequest, Any], answer_type: str, digest: DigestName
    ) -> Question:
        request, key = decoded
        question = Question(
            model=model,
            batch=request.batch,
            grid=request.grid,
            grid_key=key,
            output=request.output,
            dtype=request.dtype,
            options=request.options,
            media_type=answer_type,
            digest=digest,
        )
        question.check(self._limits)
        return question

    def _decode(self, body: bytes, media_type: str) -> tuple[WaveformRequest, Any]:
        request = decode_request(body, media_type, self._limits.max_rows)
        grid: GridLike | GridDigest = request.grid
        if isinstance(grid, GridDigest):
            return _with_grid(request, self._grids.get("", grid.sha256)), grid.sha256
        if isinstance(grid, UniformGrid) and len(grid) > self._limits.max_frequencies:
            raise TooLarge(
                f"A grid has at most {self._limits.max_frequencies} frequencies here; this one has {len(grid)}: use a "
                "larger 'delta_f'."
            )
        return request, grid_key(grid, grid_digest)

    @property
    def answer_bytes(self) -> int:
        """Memory promised to answers that are being computed or sent."""
        return self._promised.total

    @contextmanager
    def reserve(self, question: Question, owner: str = "") -> Iterator[Callable[[int], None]]:
        """Hold memory for an answer until it has been sent, or so many bytes less as the yielded function is told.

        Raises
        ------
        Overloaded
            Too many answers are waiting to be taken by their clients.
        """
        size = question.answer_bytes
        if self._promised.total and not (self._promised.fits(size) or self._promised.may_displace(owner, size)):
            raise Overloaded("Too many large answers are under way; try again shortly.", retry_after=1.0)
        left = size

        def give_back(nbytes: int) -> None:
            nonlocal left
            nbytes = min(nbytes, left)
            left -= nbytes
            self._promised.remove(owner, nbytes)

        self._promised.add(owner, size)
        try:
            yield give_back
        finally:
            give_back(left)

    def foresee(self, size: int, deadline: float | None, owner: str = "") -> None:
        """Refuse a body of ``size`` bytes before it is decoded, if others of its kind would be refused now.

        Raises
        ------
        Overloaded, QuotaExceeded, DeadlineExceeded
        """
        cost = self._cost_estimates.cost(owner, size)
        if cost is not None:
            self._queue.check_room(owner, cost, deadline)

    def learn(self, size: int, question: Question, owner: str = "") -> None:
        """Remember what a body of ``size`` bytes cost, for :meth:`foresee`."""
        self._cost_estimates.learn(owner, size, question.cost)

    def submit(self, question: Question, deadline: float | None, owner: str = "") -> Job[Question, Packed]:
        """Queue a question.

        Raises
        ------
        Overloaded, QuotaExceeded, DeadlineExceeded
        """
        return self._queue.submit(question.key, question.cost, question, deadline, quick=question.quick, owner=owner)

    def submit_quick(
        self,
        question: Question,
        deadline: float | None,
        deliver: Callable[[Packed | BaseException], None],
        owner: str = "",
    ) -> None:
        """Queue a quick question; ``deliver`` is called at the end of this turn of the event loop, or of one of the
        next when others ask, too.

        Raises
        ------
        Overloaded, QuotaExceeded, DeadlineExceeded
        """
        job = self._queue.submit(question.key, question.cost, question, deadline, quick=True, owner=owner)
        job.deliver = deliver

    def refuse(self, owner: str, refusal: Callable[[], None]) -> None:
        """Call ``refusal`` when it is the turn of this owner."""
        self._queue.turns.refuse(owner, refusal)

    def withdraw(self, job: Job[Question, Packed]) -> None:
        """Forget a job whose caller went away."""
        self._queue.withdraw(job, "disconnect")


def _with_grid(request: WaveformRequest, frequencies: GridLike) -> WaveformRequest:
    return WaveformRequest(
        batch=request.batch,
        grid=frequencies,
        output=request.output,
        dtype=request.dtype,
        options=request.options,
    )
