"""Python looks for this module when it starts: a planted server plants its fault so in its supervisor and its workers,
which are programs of their own. :mod:`benchmarks.reliability.planted` puts this folder on their path.
"""

import os

from benchmarks.reliability.planted import FAULT_NAME, FAULTS

FAULTS[os.environ[FAULT_NAME]]()
