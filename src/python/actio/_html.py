"""A run and a sweep as a notebook shows them."""

import html
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from actio._run import Run

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


def _figures(title: str, values: dict[str, float]) -> str:
    told = [f"{html.escape(name)} {value:.1e}" for name, value in values.items()]
    return f"; {title}: {', '.join(told)}" if told else ""


def run_in_html(run: "Run") -> str:
    """The head of the table, and above it what the closing line of the command says."""
    summary = run.summary
    caption = (
        f"<b>{cell(summary.get('title', ''))}</b> ({cell(summary.get('system', ''))},"
        f" {cell(summary.get('status', ''))}): {run.rows} rows"
    )
    caption += f" to t = {run.t[-1]:g}" if run.rows else ""
    caption += _figures("drift", run.drift) + _figures("error", run.error)
    caption += "".join(f"; error of {html.escape(name)}: {html.escape(said)}" for name, said in run.untold.items())
    first = [[float(x) for x in row] for row in run.table[:5]]
    rest = f"<p>… {run.rows - 5} rows more</p>" if run.rows > 5 else ""
    return "<div>" + table(run.columns, first, caption) + rest + "</div>"
