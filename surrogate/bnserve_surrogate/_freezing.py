"""Where the baseline's amplitude freezes; on its own, because serving needs it without the compiler of the baseline."""

FREEZING_START = 0.01
"""M f below which the PN amplitude is used as it is (paper, "High frequency bound")."""
FREEZING_END = 0.02
"""M f above which the amplitude is constant."""
