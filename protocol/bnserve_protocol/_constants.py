"""Physical constants, stated once for every room."""

from __future__ import annotations

SOLAR_MASS_SECONDS = 4.925491025543576e-06
"""G Msun / c^3 in seconds, the value of TEOBResumS.

LAL 7.26 has 4.925490947641267e-6 and mlgw_bns 4.92549094830932e-6: a binary of 2.8 solar masses there is one of
2.79999995 here. The difference shows as a shift of the merger, and in a mismatch of 3e-7 from 3.57 Hz.
"""

MEGAPARSEC_SECONDS = 1.02927125054339e14
"""One megaparsec divided by the speed of light, in seconds (IAU parsec, 3.0856775814913673e22 m)."""
