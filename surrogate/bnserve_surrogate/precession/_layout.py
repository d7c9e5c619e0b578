"""What the compiled precession and its caller agree on: where everything stands in memory, and how long it may be."""

from __future__ import annotations

from enum import IntEnum, auto

LANES = 8
"""Binaries that are followed together, one in each lane of a vector."""
RADIANS = 0.5
"""Of the faster spin's precession, in a step: followed for 130 turns, directions are wrong by 1e-5 rad at the end."""
BEND = 16.0
"""Steps in which the grid of steps bends from equal steps in 1 / omega to ever smaller ones near the merger."""
LAST = 4.0
"""1 / (M omega) at which directions freeze: M f = 0.08, beyond the merger of any neutron stars."""
MOST_STEPS = 2**16
"""5,200 turns; the table of eight binaries then takes 34 MB. Two stars of 1.4 solar masses: from 0.3 Hz on."""
BLOCK = 256
"""Frequencies that are twisted together: their directions stay in the first-level cache."""


class Argument(IntEnum):
    """What the code is told in one call: a block of 64-bit integers, most of them addresses."""

    ROWS = 0
    POINTS = auto()
    FREQUENCIES = auto()
    """float64 ``(M,)``, increasing, in Hz; readable for seven more."""
    MODES = auto()
    ORDERS = auto()
    """int64 ``(L,)``: m of each mode; those of one m follow each other."""
    HARMONICS = auto()
    """float64 ``(L, 4)``, see :mod:`._harmonics`."""
    STRAIN = auto()
    """complex128 ``(N, L, M)``: the modes of a binary that does not precess."""
    PARAMETERS = auto()
    """float64 ``(N, 10)``, the columns of a ParameterBatch."""
    IN_PLANE = auto()
    """float64 ``(N, 4)``."""
    REFERENCE = auto()
    """float64: Hz."""
    STEPS = auto()
    """int64 ``(N, 2)``: how many steps are taken towards the merger, and away from it."""
    LANE_STEPS = auto()
    """int64 ``(8, 2)``, to be written: the same of those that are followed together."""
    SCRATCH = auto()
    """float64: see :func:`scratch_size`."""
    PLUS = auto()
    """complex128 ``(N, M)``."""
    CROSS = auto()


class State(IntEnum):
    """What is integrated, eight binaries abreast.

    In the frame of the orbit, whose z is the orbital angular momentum and which turns about it no more than it must:
    spins in units of M^2, those in the plane turned back by their mean precession, and the observer's spinor (A, B),
    A = cos(theta / 2) exp(i (phi + chi) / 2) and B = sin(theta / 2) exp(i (phi - chi) / 2), in the direction (theta,
    phi) with polarisations turned by chi.
    """

    X1 = 0
    Y1 = auto()
    Z1 = auto()
    X2 = auto()
    Y2 = auto()
    Z2 = auto()
    A_RE = auto()
    A_IM = auto()
    B_RE = auto()
    B_IM = auto()


STATES = len(State)
NODE = 2 * (STATES - State.A_RE)
"""Numbers of one binary that are kept of a step: the spinor and its derivative."""


class Place(IntEnum):
    """What depends on where on the grid of steps one is."""

    SLOPE = 0
    """d (1 / omega) / d step."""
    V = auto()
    """omega^(1/3)."""
    LOG = auto()
    """log omega."""
    SIN1 = auto()
    COS1 = auto()
    SIN2 = auto()
    COS2 = auto()


class Constant(IntEnum):
    """Post-Newtonian coefficients and initial values of a binary; see :mod:`._equations`."""

    SCALE = 0
    """1 / omega of an equal step."""
    ORIGIN = auto()
    """1 / omega at the reference frequency."""
    FIRST = auto()
    """Its place on the grid of steps."""
    RATE_1 = auto()
    RATE_1_NLO = auto()
    RATE_1_NNLO = auto()
    SELF_1 = auto()
    RATE_2 = auto()
    RATE_2_NLO = auto()
    RATE_2_NNLO = auto()
    SELF_2 = auto()
    TIME = auto()
    """5 / (96 nu): (M omega)^(-5/3) d time / d (1 / omega) of the quadrupole formula, without its sign."""
    NU = auto()
    L_2 = auto()
    L_4 = auto()
    L_SPIN_1 = auto()
    L_SPIN_2 = auto()
    L_ALONG_1 = auto()
    L_ALONG_2 = auto()
    FLUX_2 = auto()
    FLUX_3 = auto()
    FLUX_4 = auto()
    FLUX_5 = auto()
    FLUX_6 = auto()
    FLUX_7 = auto()
    FLUX_10 = auto()
    FLUX_3_1 = auto()
    FLUX_5_1 = auto()
    FLUX_6_1 = auto()
    FLUX_7_1 = auto()
    FLUX_3_2 = auto()
    FLUX_5_2 = auto()
    FLUX_6_2 = auto()
    FLUX_7_2 = auto()
    SPIN_SPIN = auto()
    SPIN_SPIN_ALONG = auto()
    SQUARE_ALONG_1 = auto()
    SQUARE_ALONG_2 = auto()


CONSTANTS = len(Constant)
PLACES = len(Place)
WORK = LANES * (CONSTANTS + 3 * PLACES + 6 * STATES)
"""Numbers of scratch beside the table: constants, three places, and the state with its Runge-Kutta stages."""
WIDTH = BLOCK + LANES
"""Numbers that are kept for each frequency of a block, with room for whole vectors."""
POINTS = 10 * WIDTH


def scratch_size(steps: int) -> int:
    """How many float64 of scratch are needed where no eight binaries together take more than so many steps."""
    return WORK + POINTS + (LANES + 1) * NODE * (steps + 2)
