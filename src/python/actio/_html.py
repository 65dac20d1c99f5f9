"""A run and a sweep as a notebook shows them."""

import html
from collections.abc import Iterable, Sequence
from typing import Any

MOST_COLUMNS = 12


def cell(value: Any) -> str:
    """A value in a few letters, safe in a page."""
    text = f"{value:.6g}" if isinstance(value, float) else str(value)
    return html.escape(text if len(text) <= 60 else text[:57] + "...")


def table(names: Sequence[str], rows: Iterable[Sequence[Any]], caption: str) -> str:
    """A table with a heading; columns beyond the first few are left out."""
    cut = len(names) > MOST_COLUMNS

    def row(tag: str, cells: Sequence[Any]) -> str:
        shown = [f"<{tag}>{cell(value)}</{tag}>" for value in cells[:MOST_COLUMNS]]
        return "<tr>" + "".join(shown) + (f"<{tag}>…</{tag}>" if cut else "") + "</tr>"

    body = "".join(row("td", cells) for cells in rows)
    return (
        f"<table><caption>{caption}</caption><thead>{row('th', names)}</thead><tbody>{body}</tbody></table>"
    )


def figures(title: str, values: dict[str, float]) -> str:
    """Names and sizes as they follow a heading; nothing where there are none."""
    told = [f"{html.escape(name)} {value:.1e}" for name, value in values.items()]
    return f"; {title}: {', '.join(told)}" if told else ""
