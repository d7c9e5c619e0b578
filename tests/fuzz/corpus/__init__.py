"""Inputs that broke a reader, or nearly; see README.md."""

from pathlib import Path

HERE = Path(__file__).parent


def kept(target: str) -> list[Path]:
    """The files of a target."""
    return sorted(path for path in (HERE / target).glob("*") if path.is_file())
