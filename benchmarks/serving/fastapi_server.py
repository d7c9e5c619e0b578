"""FastAPI on uvicorn as one writes it in an afternoon: the reference.

Install:

    python3.11 -m venv $SERVING/fastapi
    $SERVING/fastapi/bin/pip install fastapi==0.165.0 "uvicorn[standard]==0.54.0" ./protocol ./model_store ./surrogate
"""

from __future__ import annotations

import sys

import uvicorn
from application import Waveforms
from fastapi import FastAPI, Request, Response

app = FastAPI()
waveforms = Waveforms()


@app.post("/evaluate/{points}")
async def evaluate(points: int, request: Request) -> Response:
    """Raw numbers in, raw numbers out."""
    return Response(waveforms.answer(points, await request.body()), media_type="application/octet-stream")


if __name__ == "__main__":
    uvicorn.run(app, port=int(sys.argv[1]), log_level="warning", access_log=False)
