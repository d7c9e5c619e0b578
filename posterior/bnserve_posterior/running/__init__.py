"""From an event to its posterior, with what is finished kept in a folder."""

from bnserve_posterior.running._chain import Outcome, run
from bnserve_posterior.running._folder import Folder
from bnserve_posterior.running._preparing import Prepared, prepare
from bnserve_posterior.running._summary import describe, meta_data

__all__ = ["Folder", "Outcome", "Prepared", "describe", "meta_data", "prepare", "run"]
