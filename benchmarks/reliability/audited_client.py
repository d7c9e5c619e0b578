"""``python -m benchmarks.reliability.audited_client``: our client, told by JSON lines what to ask.

With the argument ``unpickle``, it reads arrays of objects as msgpack-numpy does: the fault that must be noticed.
"""

from __future__ import annotations

import json
import sys
from typing import Any

from benchmarks.reliability.hostile import unpickle_what_is_found
from bnserve_client import BnserveError, Model, ParametersWithExtrinsic, _answers

BINARY = ParametersWithExtrinsic.gw170817()


def unpickle_answers() -> None:
    """Take the mechanism away."""
    decode: Any = _answers.decode_answer  # type: ignore[attr-defined]

    def unpickle_and_decode(body: Any, *arguments: Any) -> Any:
        unpickle_what_is_found(bytes(body))
        return decode(body, *arguments)

    _answers.decode_answer = unpickle_and_decode  # type: ignore[attr-defined]


def main() -> None:
    """Answer commands until there are no more."""
    if "unpickle" in sys.argv:
        unpickle_answers()
    model: Model | None = None
    for line in sys.stdin:
        command = json.loads(line)
        if command["do"] == "connect":
            model = Model.connect(command["url"], command["model"], retries=0, timeout=20.0)
        assert model is not None, "connect comes first"
        try:
            model.predict_batch([20.0, 100.0], [BINARY] * 2)
        except BnserveError:
            print('{"good": false}', flush=True)
        else:
            print('{"good": true}', flush=True)


if __name__ == "__main__":
    main()
