"""The view of a report in a notebook: the verdict, the counts and a table of the findings.

The text has the colour of the notebook, and backgrounds are translucent, so that the view suits light and dark themes.
"""

from html import escape

from gougecheck._finding import State

MOST_ROWS = 50
_WORDS = {"clean": ("clean", "#1a7f37"), "gouges": ("gouges", "#c62828"),
          "not-fully-checked": ("not fully checked", "#9a6700")}
_NUMBER = "text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap;"
_CELL = "padding:3px 10px;border-bottom:1px solid rgba(128,128,128,.35);vertical-align:top;"


def _length(value):
    return "" if value is None else f"{value:.3f}"


def _vector(value):
    return "" if value is None else ", ".join(f"{x:.3f}" for x in value)


def _state(finding):
    return finding.state.name.lower().replace("_", " ")


#: Heading, whether it is a number, and the text of a finding.
_COLUMNS = (
    ("Line", True, lambda f: str(f.line)),
    ("State", False, _state),
    ("Depth, mm", True, lambda f: _length(f.depth)),
    ("At most, mm", True, lambda f: _length(f.depth_upper)),
    ("Body", False, lambda f: "" if f.body is None else f.body.name.lower()),
    ("Against", False, lambda f: f.against),
    ("Tool", False, lambda f: f.tool),
    ("Operation", False, lambda f: f.operation),
    ("Point, mm", True, lambda f: _vector(f.point)),
)


def _rank(finding):
    """Sorts buried tools first, then gouges, the deepest first, then near misses, the nearest first, then the rest."""
    order = {State.BURIED: 0, State.GOUGE: 1, State.NEAR: 2}.get(finding.state, 3)
    return order, -(finding.depth or 0), finding.clearance or 0


def _table(findings):
    columns = [column for column in _COLUMNS if any(column[2](finding) for finding in findings)]
    head = "".join(
        f'<th scope="col" style="{_CELL}white-space:nowrap;text-align:{"right" if number else "left"}">{name}</th>'
        for name, number, _ in columns)
    rows = "".join(
        f'<tr title="{escape(finding.message)}">'
        + "".join(f'<td style="{_CELL}{_NUMBER if number else "text-align:left;"}">{escape(text(finding))}</td>'
                  for _, number, text in columns)
        + "</tr>"
        for finding in findings)
    return (f'<div style="overflow-x:auto"><table style="border-collapse:collapse;margin:0;font-size:inherit;background:transparent">'
            f"<thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div>")


def _counts(report):
    counts = ((state, report.count(state)) for state in State)
    return ", ".join(f"{count} {state.name.lower().replace('_', ' ')}" for state, count in counts if count)


def _open_facts(report):
    items = [f"<li>{escape(fact.fact)}{escape(' ' + fact.object if fact.object else '')}: "
             f"{escape(fact.evidence)}; {escape(fact.remedy)}</li>" for fact in report.assumptions if fact.is_open]
    return f'<div>Not established:<ul style="margin:2px 0">{"".join(items)}</ul></div>' if items else ""


def _reasons(findings):
    open_ones = [f for f in findings if f.state in (State.NOT_CHECKED, State.NOT_CERTIFIED)]
    return "".join(f"<div>{escape(str(finding))}</div>" for finding in open_ones)


def html_of(report) -> str:
    """Returns the view as one element without scripts or style sheets."""
    word, colour = _WORDS[report.verdict]
    findings = sorted(report.findings, key=_rank)
    deepest = f"; deepest {report.worst_depth:.3f} mm" if report.worst_depth > 0 else ""
    shown, more = findings[:MOST_ROWS], len(findings) - MOST_ROWS
    parts = [
        f'<div><b style="background:{colour};color:#fff;padding:2px 8px;border-radius:4px">{word}</b> '
        f"{len(report)} {'move' if len(report) == 1 else 'moves'}: {_counts(report)}{deepest}</div>",
        _open_facts(report), _table(shown) if shown else "", _reasons(shown)]
    if more > 0:
        parts.append(f"<div>and {more} more; report.findings lists all</div>")
    return f'<div style="line-height:1.5;display:grid;gap:8px">{"".join(part for part in parts if part)}</div>'
