"""The report of a construction: a page with plots."""

from __future__ import annotations

import base64
import html
import io
from pathlib import Path

from bnserve_inference.roq._build import BuiltBasis
from bnserve_inference.roq._diagnostics import describe
from bnserve_inference.roq._plots import all_figures
from bnserve_inference.roq._storage import replacing
from bnserve_protocol import WaveformModel


def write_roq_report(path: Path | str, title: str, built: BuiltBasis, model: WaveformModel) -> None:
    """Write a self-contained page: what was built, how it grew, how good it is.

    Raises
    ------
    BasisUnwritable
        The page cannot be written; the basis is not affected.
    PackageMissing
        matplotlib is not installed.
    """
    images = []
    for caption, figure in all_figures(built, model):
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png", metadata={"Software": None})
        encoded = base64.b64encode(buffer.getvalue()).decode()
        images.append(
            f'<figure><img src="data:image/png;base64,{encoded}" alt="{html.escape(caption)}">'
            f"<figcaption>{html.escape(caption)}</figcaption></figure>"
        )
    seconds = "\n".join(f"{name:12}{value:8.1f} s" for name, value in built.seconds.items())
    text = _PAGE.format(
        title=html.escape(title), text=html.escape(f"{describe(built.quadrature)}\n\n{seconds}"), images="".join(images)
    )
    with replacing(Path(path)) as temporary:
        temporary.write_text(text, encoding="utf-8")


_PAGE = """<!doctype html><html lang="en"><meta charset="utf-8"><title>{title}</title>
<style>body{{font:16px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#1b2733}}
img{{width:100%}}figure{{margin:2rem 0}}figcaption{{color:#5a6b7b}}
pre{{background:#f3f5f8;padding:1rem;overflow-x:auto}}</style>
<h1>{title}</h1><pre>{text}</pre>{images}</html>
"""
