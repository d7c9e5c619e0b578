"""Trained models on disk: ``<root>/<name>/<version>/manifest.json + tensors.safetensors``. Knows no physics.

Nothing that is stored is executable. Whatever is loaded was verified first; whatever is published appears at once and
whole, or not at all.
"""

from bnserve_store._files import SCHEMA_VERSION, FileEntry, Manifest, TensorEntry
from bnserve_store._pages import report_figure, report_page, report_table
from bnserve_store._publishing import check_writable
from bnserve_store._reading import Artifact
from bnserve_store._replacing import replacing
from bnserve_store._store import SHIPPED_MODELS, ModelStore

__all__ = [
    "SCHEMA_VERSION", "SHIPPED_MODELS", "Artifact", "FileEntry", "Manifest", "ModelStore", "TensorEntry",
    "check_writable", "replacing", "report_figure", "report_page", "report_table",
]  # fmt: skip  # each has a line of its own above
