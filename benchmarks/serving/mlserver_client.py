"""Asking MLServer over gRPC, in its own environment: a worker that answers the driver of this comparison."""

from __future__ import annotations

import asyncio
import base64
import json
import sys
import time
from typing import Any

import numpy as np
import tritonclient.grpc as grpc
import tritonclient.grpc.aio as grpc_aio

LARGE = [("grpc.max_receive_message_length", 2**28), ("grpc.max_send_message_length", 2**28)]


def question(request: dict[str, Any]) -> tuple[str, list[Any]]:
    """The model's name and its input."""
    values = np.frombuffer(base64.b64decode(request["values"])).reshape(-1, 10)
    tensor = grpc.InferInput("values", list(values.shape), "FP64")
    tensor.set_data_from_numpy(values)
    return f"waveforms_{request['points']}", [tensor]


def round_trips(address: str, request: dict[str, Any]) -> dict[str, Any]:
    """Seconds of each of some calls, and the last answer."""
    client = grpc.InferenceServerClient(address, channel_args=LARGE)
    model, inputs = question(request)
    seconds = []
    for _ in range(request["calls"]):
        started = time.perf_counter()
        answer = client.infer(model, inputs)
        answer.as_numpy("h")
        seconds.append(time.perf_counter() - started)
    body = answer.as_numpy("h").astype("<f8").tobytes()
    return {"seconds": seconds, "body": base64.b64encode(body).decode()}


async def answers_per_second(address: str, request: dict[str, Any]) -> dict[str, Any]:
    """Answers per second of as many clients at once."""
    async with grpc_aio.InferenceServerClient(address, channel_args=LARGE) as client:
        model, inputs = question(request)
        started = time.perf_counter()

        async def ask() -> int:
            answers = 0
            while answers == 0 or time.perf_counter() - started < request["for"]:
                await client.infer(model, inputs)
                answers += 1
            return answers

        answers = await asyncio.gather(*(ask() for _ in range(request["clients"])))
        return {"per_second": sum(answers) / (time.perf_counter() - started)}


def main(address: str) -> None:
    """Answer until stdin ends."""
    for line in sys.stdin:
        request = json.loads(line)
        try:
            if request["do"] == "round_trips":
                answer = round_trips(address, request)
            else:
                answer = asyncio.run(answers_per_second(address, request))
        except Exception as error:
            answer = {"error": f"{type(error).__name__}: {error}"}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main(sys.argv[1])
