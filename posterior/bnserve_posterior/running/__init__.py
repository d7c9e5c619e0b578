"""From an event to its posterior, with what is finished kept in a folder."""

from bnserve_posterior.running._chain import Outcome, Prepared, prepare, run
from bnserve_posterior.running._folder import Folder

__all__ = ["Folder", "Outcome", "Prepared", "prepare", "run"]
