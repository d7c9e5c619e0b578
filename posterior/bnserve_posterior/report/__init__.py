"""What is written of a run: bilby's result, and a page, one HTML file that needs nothing else."""

from bnserve_posterior.report._page import write_page
from bnserve_posterior.report._saving import save_outcome

__all__ = ["save_outcome", "write_page"]
