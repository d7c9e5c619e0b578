"""Places and codes as plain integers, which is what the compiler takes for constants."""

from bnserve_protocol import RowStatus
from bnserve_surrogate.kernel._arguments import Argument, Output, Policy
from bnserve_surrogate.kernel._layout import Entry

MASS_RATIO, LAMBDA_1, LAMBDA_2, CHI_1, CHI_2, DISTANCE, INCLINATION, TOTAL_MASS, REFERENCE_PHASE, TIME_SHIFT = range(10)
COLUMNS = 10
"""Of a batch of parameters."""

ROWS = int(Argument.ROWS)
PARAMETERS = int(Argument.PARAMETERS)
POINTS = int(Argument.POINTS)
GRID = int(Argument.GRID)
STRIDE = int(Argument.STRIDE)
BINS = int(Argument.BINS)
TABLE = int(Argument.TABLE)
GIVEN = int(Argument.GIVEN)
CONTENTS = int(Argument.CONTENTS)
EXPONENTS = int(Argument.EXPONENTS)
WEIGHTS = int(Argument.WEIGHTS)
ALIGNMENT = int(Argument.ALIGNMENT)
POLICY = int(Argument.POLICY)
SCRATCH = int(Argument.SCRATCH)
OUTPUT = int(Argument.OUTPUT)
FIRST = int(Argument.FIRST)
SECOND = int(Argument.SECOND)
PLUS = int(Argument.PLUS)
CROSS = int(Argument.CROSS)
STATUS = int(Argument.STATUS)
ESTIMATES = int(Argument.ESTIMATES)

OUTPUTS = int(Entry.OUTPUTS)
AMPLITUDE_NODES = int(Entry.AMPLITUDE_NODES)
PHASE_NODES = int(Entry.PHASE_NODES)
SYNTHESIS_AT = int(Entry.SYNTHESIS_AT)
BAND_AT = int(Entry.BAND_AT)
AMPLITUDE_KNOTS_AT = int(Entry.AMPLITUDE_KNOTS_AT)
PHASE_KNOTS_AT = int(Entry.PHASE_KNOTS_AT)
LIMITS_AT = int(Entry.LIMITS_AT)
CELLS = int(Entry.CELLS)
CELLS_AT = int(Entry.CELLS_AT)
OWNERS_AT = int(Entry.OWNERS_AT)
SHARED = int(Entry.SHARED_NODES)

BELOW, ABOVE, STOP = int(Policy.BELOW_BAND_IS_ERROR), int(Policy.ABOVE_BAND_IS_ERROR), int(Policy.STOP_AT_BAD_ROWS)
STRAIN_SINGLE, POLARIZATIONS = int(Output.STRAIN_SINGLE), int(Output.POLARIZATIONS)
POLARIZATIONS_SINGLE, AMPLITUDE_PHASE = int(Output.POLARIZATIONS_SINGLE), int(Output.AMPLITUDE_PHASE)
OK, OUT_OF_DOMAIN = int(RowStatus.OK), int(RowStatus.OUT_OF_DOMAIN)
OUT_OF_BAND, NOT_FINITE = int(RowStatus.OUT_OF_BAND), int(RowStatus.NOT_FINITE)
