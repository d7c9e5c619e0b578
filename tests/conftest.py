"""Settings for every test."""

import signal

from hypothesis import settings

# In a background shell interrupts are ignored, and every process started here would inherit that.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# Tests never assert on time: shared machines pause.
settings.register_profile("bnserve", deadline=None, derandomize=True)
settings.load_profile("bnserve")
