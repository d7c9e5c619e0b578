"""Python looks for this module when it starts: a faulty server injects its fault so in its supervisor and its workers,
which are programs of their own. :mod:`benchmarks.reliability.faulty_server` puts this folder on their path.
"""

import os

from benchmarks.reliability.faulty_server import FAULT_NAME, FAULTS

FAULTS[os.environ[FAULT_NAME]]()
