"""Import every module of every room, but for those that belong to an extra that is not installed; prints how many."""

import importlib
import pkgutil
import sys

from architecture.rooms import ROOMS  # beside this script

EXTRAS = {
    "EOBRun_module",
    "bilby",
    "joblib",
    "lal",
    "lalsimulation",
    "numba",
    "optuna",
    "pycbc",
    "ray",
    "ripplegw",
    "scipy",
    "sklearn",
    "tqdm",
}
"""What only training, building bases, Ray, bilby and PyCBC import."""


def main() -> int:
    """Import them all; 1 when one needs what no extra brings."""
    imported, left_out, failed = 0, 0, []
    for room in ROOMS.values():
        package = importlib.import_module(room)
        for module in pkgutil.walk_packages(package.__path__, f"{room}.", onerror=lambda _: None):
            if module.name.endswith(".__main__"):  # which would run
                continue
            try:
                importlib.import_module(module.name)
                imported += 1
            except ModuleNotFoundError as error:
                if error.name is not None and error.name.partition(".")[0] in EXTRAS:
                    left_out += 1
                else:
                    failed.append(f"{module.name}: {error}")
    print(f"{imported} modules imported, {left_out} left out: they are of extras that are not installed")
    print(*failed, sep="\n")
    return 1 if failed or imported < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
