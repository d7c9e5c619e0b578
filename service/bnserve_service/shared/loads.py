"""How many connections each worker has: one number for each place, which all of them see at once.

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

import os
import struct
from pathlib import Path

_NUMBER = struct.Struct("<q")
_ABSENT = -1


class SharedLoads:
    """The numbers of all places. Each is written by the worker in that place, and by the supervisor once it is gone.

    Parameters
    ----------
    shared:
        The folder of the server.
    places:
        How many there are, when the file has to be made; nobody is there then.
    """

    def __init__(self, shared: Path, places: int | None = None) -> None:
        self._file = os.open(shared / "loads", os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        if places is not None:
            os.pwrite(self._file, _NUMBER.pack(_ABSENT) * places, 0)

    def say(self, place: int, connections: int) -> None:
        """State how many connections the worker in a place has."""
        os.pwrite(self._file, _NUMBER.pack(connections), place * _NUMBER.size)

    def leave(self, place: int) -> None:
        """State that no worker in this place takes connections."""
        self.say(place, _ABSENT)

    def least(self) -> int:
        """The connections of the worker that has fewest; 0 when there is none."""
        data = os.pread(self._file, 2**16, 0)
        return min((number for (number,) in _NUMBER.iter_unpack(data) if number != _ABSENT), default=0)

    def close(self) -> None:
        """Close the file."""
        os.close(self._file)
