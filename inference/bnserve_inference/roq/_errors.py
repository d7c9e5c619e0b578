"""What can go wrong with reduced-order quadratures.

::

    BnserveError
    └── RoqError
        ├── RoqConfigurationInvalid   a configuration that cannot be read or makes no sense
        ├── BasisFileInvalid          a file that is not a basis, or a damaged one
        ├── BasisUnwritable           no room or no permission for a basis or a checkpoint
        ├── BasisMismatch             a basis used with another model or another grid than its own
        ├── PriorNotCovered           a prior that reaches beyond the basis
        └── ConstructionFailed        the greedy algorithm cannot reach its goal
"""

from __future__ import annotations

from bnserve_protocol import BnserveError


class RoqError(BnserveError):
    """Base of every error that only reduced-order quadratures raise."""

    code = "roq"
    title = "Reduced-order quadrature failed"


class RoqConfigurationInvalid(RoqError):
    """A configuration that cannot be read or makes no sense."""

    code = "roq-configuration-invalid"
    title = "Configuration of a reduced-order quadrature invalid"


class BasisFileInvalid(RoqError):
    """A file that is not a basis, or a damaged one."""

    code = "basis-file-invalid"
    title = "Basis file invalid"


class BasisUnwritable(RoqError):
    """A basis, or a checkpoint of its construction, cannot be written."""

    code = "basis-unwritable"
    title = "Basis cannot be written"


class BasisMismatch(RoqError):
    """A basis used with another model than the one it was built for."""

    code = "basis-mismatch"
    title = "Basis of another model"


class PriorNotCovered(RoqError):
    """A prior that reaches beyond the ranges of the basis."""

    code = "prior-not-covered"
    title = "Prior not covered by the basis"


class ConstructionFailed(RoqError):
    """The greedy algorithm cannot reach its goal."""

    code = "roq-construction-failed"
    title = "Basis construction failed"
