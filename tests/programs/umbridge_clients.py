"""UM-Bridge's clients for C++ and R, as its repository has them, beside our own on the same analysis.

    python tests/programs/umbridge_clients.py http://127.0.0.1:8000 UMBRIDGE FOLDER

UMBRIDGE is a checkout of https://github.com/UM-Bridge/umbridge. For C++ it takes g++, and nginx, which puts the path in
front, as the guide says; for R it takes r-base-core, r-cran-httr2, r-cran-jsonlite and r-cran-magrittr of Debian. What
is not there is left out, by name. It fails where numbers differ from those of our client.
"""

import json
import os
import shutil
import subprocess
import sys
import time
import urllib.request
from contextlib import contextmanager
from pathlib import Path

import numpy as np

ROOT = Path(__file__).parents[2]
sys.path.append(str(ROOT / "examples" / "samplers"))

from problem import FIXED, TRUTH, Problem, columns  # noqa: E402  (after the path)

from bnserve_client import Model  # noqa: E402

FREE = ("mass_ratio", "total_mass", "distance_mpc", "coalescence_time")
POINT = (1.4, 2.779432171, 60.0, 0.0020123456)
OUTSIDE = -1e300
NGINX = """pid {folder}/pid; error_log {folder}/error.log; events {{}}
http {{
    access_log off;
    client_body_temp_path {folder}/body; proxy_temp_path {folder}/proxy; fastcgi_temp_path {folder}/fastcgi;
    uwsgi_temp_path {folder}/uwsgi; scgi_temp_path {folder}/scgi;
    server {{
        listen 127.0.0.1:{port};
        location / {{ proxy_pass {address}/v1/umbridge/; }}
    }}
}}
"""
PORT = 18765


def expected(problem: Problem) -> list[np.ndarray]:
    """Size, value, gradient, a derivative along the first parameter, and the value outside, by our own client."""
    place = {name: np.array([value]) for name, value in zip(FREE, POINT, strict=True)}
    found = problem.likelihood.gradients(columns(TRUTH[np.newaxis]) | place)
    gradient = found.gradient[0, [found.names.index(name) for name in FREE]]
    return [np.array([4.0]), found.log_likelihood, gradient, gradient[:1], np.array([OUTSIDE])]


def compare(name: str, output: str, right: list[np.ndarray], digits: float) -> None:
    """Lines of numbers, and one with the server's own sentence."""
    *lines, said = output.splitlines()
    for line, numbers in zip(lines, right, strict=True):
        np.testing.assert_allclose(np.array(line.split(), dtype=float), numbers, rtol=digits)
    assert "vector of 4 numbers: mass_ratio, total_mass" in said, said
    print(f"{name}: value {float(lines[1]):.6f}, gradient {lines[2]}: ours. Of a long input it says: {said}")


@contextmanager
def in_front(address: str, folder: Path):
    """nginx, which puts UM-Bridge's path in front of every path."""
    configuration = folder / "nginx.conf"
    configuration.write_text(NGINX.format(folder=folder, port=PORT, address=address))
    process = subprocess.Popen(["nginx", "-p", str(folder), "-g", "daemon off;", "-c", str(configuration)])
    try:
        host = f"http://127.0.0.1:{PORT}"
        for _ in range(50):
            try:
                urllib.request.urlopen(f"{host}/Info", timeout=10).close()
                break
            except OSError:
                time.sleep(0.1)
        yield host
    finally:
        process.terminate()
        process.wait()


def by_cpp(address: str, checkout: Path, folder: Path, arguments: list[str], right: list[np.ndarray]) -> None:
    """Compile and run it: it writes numbers as they are."""
    source, program = ROOT / "tests" / "programs" / "umbridge_client.cpp", folder / "client"
    command = ["g++", "-std=c++17", f"-I{checkout / 'lib'}", str(source), "-pthread", "-o", str(program)]
    subprocess.run(command, check=True)
    with in_front(address, folder) as host:
        done = subprocess.run([str(program), host, *arguments], capture_output=True, text=True, check=True)
    compare("C++", done.stdout, right, 0.0)


def by_r(address: str, checkout: Path, folder: Path, arguments: list[str], right: list[np.ndarray]) -> None:
    """Install the package and run a script: it writes 15 digits."""
    library = folder / "R"
    library.mkdir(exist_ok=True)
    subprocess.run(["R", "CMD", "INSTALL", "--no-docs", "-l", str(library), str(checkout / "R")], check=True)
    script = ROOT / "tests" / "programs" / "umbridge_client.R"
    done = subprocess.run(
        ["Rscript", str(script), f"{address}/v1/umbridge", *arguments],
        capture_output=True, text=True, check=True, env=os.environ | {"R_LIBS": str(library)},
    )  # fmt: skip
    compare("R", done.stdout, right, 1e-9)


def main() -> None:
    """Upload, and run what can be run."""
    address, checkout, folder = sys.argv[1], Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve()
    folder.mkdir(exist_ok=True)
    with Model.connect(address) as model:
        problem = Problem.pose(model, [])
        right = expected(problem)
    digest = problem.likelihood.analysis.digest.removeprefix("sha256:")
    config = {"fixed": {name: value for name, value in FIXED.items() if name not in FREE}, "outside": OUTSIDE}
    arguments = [f"default/{digest}", json.dumps(config), *map(repr, POINT)]
    for name, run, needed in (("C++", by_cpp, ("g++", "nginx")), ("R", by_r, ("R", "Rscript"))):
        missing = [program for program in needed if shutil.which(program) is None]
        if missing:
            print(f"{name}: left out, there is no {' and no '.join(missing)} here")
        else:
            run(address, checkout, folder, arguments, right)


main()
