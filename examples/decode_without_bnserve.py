"""Ask a running server, and read its answer, without any library of ours: http.client, msgpack, numpy.

With a server running anywhere, and its address:

    pip install msgpack numpy
    python examples/decode_without_bnserve.py http://127.0.0.1:8000
"""

import http.client
import sys
from urllib.parse import urlsplit

import msgpack
import numpy as np


def array(packed: dict) -> np.ndarray:
    """An array, from the map that stands for it: the layout of msgpack-numpy, with text for keys."""
    return np.frombuffer(packed["data"], packed["type"]).reshape(packed["shape"])


address = sys.argv[1] if len(sys.argv) > 1 else "http://127.0.0.1:8000"
question = {
    "parameters": {
        "mass_ratio": [1.0, 1.2, 1.4], "lambda_1": 400.0, "lambda_2": 600.0, "chi_1": 0.01, "chi_2": 0.0,
        "distance_mpc": 40.0, "inclination": 2.5, "total_mass": 2.76,
    },
    "grid": {"f_min": 20.0, "f_max": 2048.0, "delta_f": 0.25},
}  # fmt: skip

connection = http.client.HTTPConnection(urlsplit(address).netloc)
headers = {"Content-Type": "application/msgpack", "Accept": "application/msgpack"}
connection.request("POST", "/v1/models/default/waveforms", msgpack.packb(question), headers)
response = connection.getresponse()
body = response.read()
connection.close()
if response.status != 200:
    sys.exit(f"The server answered {response.status}: {body.decode()}")

answer = msgpack.unpackb(body)
h_plus, h_cross = array(answer["h_plus"]), array(answer["h_cross"])
print(f"model {answer['model']['name']} {answer['model']['version']}")
print(f"h_plus: {h_plus.shape[0]} waveforms of {h_plus.shape[1]} numbers, {h_plus.dtype}")
print(f"|h+| at 20 Hz: {np.abs(h_plus[:, 0])} / Hz")
