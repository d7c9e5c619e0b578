"""From the command line to the supervisor: this process becomes it, and forgets all that it imported until then."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from typing import NoReturn

from bnserve_service.process.listening import address_of, listening, open_metrics_listener
from bnserve_service.settings import Settings
from bnserve_service.workers.template_keeper import NO_DESCRIPTOR


def become_supervisor(settings: Settings, announce: Callable[[str], None]) -> NoReturn:
    """Listen, and replace the program of this process by the supervisor; it keeps its number.

    Parameters
    ----------
    settings:
        How; ``workers`` is at least two.
    announce:
        Gets a line with the address.

    Raises
    ------
    CannotListen
    """
    with listening(settings) as listener:  # which ends only if this fails
        metrics = open_metrics_listener(settings)
        announce(f"bnserve listens on {address_of(listener)}")
        if metrics is not None:
            announce(f"bnserve metrics on {address_of(metrics)}/metrics")
        file = os.memfd_create("bnserve-settings")  # nobody else can read it, and it needs no name
        os.write(file, settings.model_dump_json().encode())
        numbers = (listener.fileno(), metrics.fileno() if metrics is not None else NO_DESCRIPTOR, file)
        for number in numbers:
            if number != NO_DESCRIPTOR:
                os.set_inheritable(number, True)
        # Whatever found this package shall find it again; -P: nothing of the current directory shall count as one.
        environment = os.environ | {"PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
        command = [sys.executable, "-P", "-m", "bnserve_service.workers.supervisor", *map(str, numbers)]
        os.execve(sys.executable, command, environment)
