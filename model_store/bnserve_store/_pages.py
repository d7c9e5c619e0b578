"""Pages of reports, beside what they are about: HTML in one file that holds all it shows, in one style."""

from __future__ import annotations

import base64
import html
import io
from collections.abc import Iterable
from typing import Any

_PAGE = """<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{title}</title>
<style>body{{font:16px/1.5 system-ui,sans-serif;max-width:70rem;margin:2rem auto;padding:0 1rem;color:#1b2733}}
img{{width:100%}}figure{{margin:2rem 0}}figcaption{{color:#5a6b7b}}h2{{margin-top:2.5rem}}
pre{{font-size:14px;background:#f3f5f8;padding:1rem;overflow-x:auto}}
table{{border-collapse:collapse;font-size:14px}}td,th{{text-align:left;padding:.2rem 1rem .2rem 0;
border-bottom:1px solid #e6eaee;overflow-wrap:anywhere}}.wide{{overflow-x:auto}}</style>
<h1>{title}</h1>{body}</html>
"""


def report_page(title: str, body: str) -> str:
    """A whole page.

    Parameters
    ----------
    title
        Plain text.
    body
        HTML, of :func:`report_figure`, :func:`report_table` and more.
    """
    return _PAGE.format(title=html.escape(title), body=body)


def report_figure(caption: str, figure: Any, **options: Any) -> str:
    """A figure of matplotlib with its caption, plain text; ``options`` are those of its ``savefig``."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", metadata={"Software": None}, **options)
    encoded, text = base64.b64encode(buffer.getvalue()).decode(), html.escape(caption)
    return f'<figure><img src="data:image/png;base64,{encoded}" alt="{text}"><figcaption>{text}</figcaption></figure>'


def report_table(rows: Iterable[tuple[str, ...]], head: tuple[str, ...] | None = None) -> str:
    """A table of plain text."""
    first = "" if head is None else f"<tr>{''.join(f'<th>{html.escape(cell)}</th>' for cell in head)}</tr>"
    body = "".join(f"<tr>{''.join(f'<td>{html.escape(cell)}</td>' for cell in row)}</tr>" for row in rows)
    return f"<div class=wide><table>{first}{body}</table></div>"
