"""A report as one self-contained page of HTML without scripts."""

import base64
import html
from collections.abc import Sequence
from functools import cache

from crenel.formats.json_document import SOFTWARE
from crenel.messages.catalogue import Render, isolate_names, renderer
from crenel.messages.message import Message, message
from crenel.report.content import (
    Block,
    Facts,
    Findings,
    Pictures,
    Report,
    ReportTable,
    Section,
    Signatures,
    TextBlock,
)
from crenel.report.fonts import REGULAR, SEMIBOLD
from crenel.report.formatting import join_units
from crenel.report.html_policy import POLICY
from crenel.report.logo import logo_type
from crenel.report.svg import svg

MARKS = {
    "good": message("good"),
    "attention": message("attention"),
    "bad": message("bad"),
    "neutral": message("note"),
}

STYLE = """
@page { size: A4; margin: 16mm 15mm; }
* { box-sizing: border-box; }
html { color-scheme: only light; background: #eef0f3; }
body { max-width: 190mm; margin: 0 auto; padding: 14mm 12mm; background: #fff; color: #12161b;
  font: 10pt/1.45 "Report", system-ui, "Segoe UI", "Liberation Sans", sans-serif;
  font-variant-numeric: tabular-nums; }
header { display: flex; justify-content: space-between; gap: 8mm; padding-bottom: 4mm;
  border-bottom: 2px solid #12161b; }
h1 { margin: 0; font-size: 20pt; line-height: 1.15; letter-spacing: -0.015em; }
h2 { margin: 8mm 0 2.5mm; font-size: 11.5pt; break-after: avoid; }
.logo { display: block; max-width: 60mm; max-height: 18mm; margin: 0 0 4mm; }
.of { text-align: right; color: #434d59; font-size: 9pt; overflow-wrap: anywhere; }
.of b { color: #12161b; }
p { margin: 0 0 2.5mm; overflow-wrap: anywhere; }
.small { font-size: 8.5pt; color: #434d59; }
.note { margin: 4mm 0 0; padding: 2mm 4mm; border: 1px solid #b9c1cc; font-weight: 600; }
.verdict { margin: 5mm 0 0; padding: 4mm 5mm; border-left: 2mm solid; }
.verdict b { display: block; font-size: 14pt; }
.verdict.good { background: #e4f4ec; border-color: #17794a; }
.verdict.attention { background: #fdf1da; border-color: #d38b0b; }
.verdict.bad { background: #fdeaea; border-color: #bf2329; }
.verdict.neutral { background: #f2f4f7; border-color: #7c8794; }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(75mm, 1fr)); column-gap: 8mm;
  margin: 0; }
.facts div { display: grid; grid-template-columns: 32mm 1fr; gap: 3mm; padding: 1.2mm 0;
  border-bottom: 1px solid #dde1e7; break-inside: avoid; }
dt { color: #434d59; }
dd { margin: 0; font-weight: 500; overflow-wrap: anywhere; }
table { width: 100%; margin: 0 0 3mm; border-collapse: collapse; }
th, td { padding: 1.2mm 2mm 1.2mm 0; border-bottom: 1px solid #dde1e7; text-align: left;
  vertical-align: top; overflow-wrap: break-word; }
th { border-bottom: 1px solid #12161b; font-size: 8.5pt; font-weight: 600; color: #434d59; }
tr { break-inside: avoid; }
.n { text-align: right; padding: 1.2mm 0 1.2mm 3mm; }
.tight { font-size: 8pt; }
.tight td:nth-child(2) { overflow-wrap: anywhere; }
.findings { list-style: none; margin: 0; padding: 0; }
.findings li { display: grid; grid-template-columns: 22mm 1fr; gap: 3mm; padding: 1.2mm 0;
  border-bottom: 1px solid #dde1e7; break-inside: avoid; }
.findings b.good { color: #17794a; }
.findings b.attention { color: #8f5b00; }
.findings b.bad { color: #bf2329; }
.pictures { display: grid; gap: 4mm 6mm; }
figure { margin: 0; break-inside: avoid; }
figure svg { display: block; width: 100%; height: auto; font-family: inherit; }
figcaption { margin-top: 1.5mm; font-size: 8.5pt; color: #434d59; }
.signed { break-before: avoid; break-inside: avoid; }
.signatures { display: grid; grid-template-columns: repeat(auto-fit, minmax(48mm, 1fr)); gap: 10mm;
  margin-top: 14mm; break-inside: avoid; }
.signatures div { border-top: 1px solid #12161b; padding-top: 1.5mm; font-size: 9pt; }
footer { margin-top: 10mm; padding-top: 2mm; border-top: 1px solid #dde1e7; font-size: 8pt;
  color: #5f6b79; }
@media (max-width: 700px) {
  body { padding: 6mm 5mm; }
  header { display: block; } .of { text-align: left; margin-top: 2mm; }
  .pictures { grid-template-columns: 1fr !important; }
  .wide { overflow-x: auto; }
  .wide table { min-width: 34rem; }
}
@media print { html { background: #fff; } body { max-width: none; padding: 0; } }
"""


@cache
def _font_faces() -> str:
    """The same font as on paper, within the page."""
    rules = (
        f"@font-face {{ font-family: Report; font-weight: {weight}; "
        f"src: url(data:font/ttf;base64,{base64.b64encode(path.read_bytes()).decode()}); }}\n"
        for weight, path in ((400, REGULAR), (600, SEMIBOLD))
    )
    return "".join(rules)


def html_page(report: Report[str]) -> bytes:
    """The whole file, UTF-8."""
    notes = "".join(f'<p class="note">{escape(note)}</p>' for note in report.notes)
    verdict, render = report.verdict, renderer(report.language)
    of = f"<b>{escape(report.station)}</b><br>{escape(report.number)}<br>{escape(report.date)}"
    text = f"""<!doctype html>
<html lang="{report.language}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{escape(report.title)} {escape(report.number)}</title>
<style>{_font_faces()}{STYLE}</style>
</head>
<body>
{_logo(report.logo)}<header>
<h1>{escape(report.title)}</h1>
<div class="of">{of}</div>
</header>
{notes}
<div class="verdict {verdict.quality}"><b>{escape(verdict.word)}</b>{escape(verdict.text)}</div>
{"".join(_section(section, report, render) for section in report.sections)}
<footer>{escape(render(producer_text()))}</footer>
</body>
</html>
"""
    return text.encode()


def escape(text: str) -> str:
    """A text, escaped for the page."""
    return html.escape(isolate_names(join_units(text)))


def producer_text() -> Message:
    """The program and version of the report."""
    return message("report-made-crenel-files-session-alone", version=SOFTWARE.version)


def result_line(report: Report[str]) -> str:
    """What the signatures of a report are for: a page that is on its own says so, too."""
    return f"{report.title} {report.number}: {report.verdict.word}"


def _logo(logo: bytes | None) -> str:
    if logo is None:
        return ""
    data = base64.b64encode(logo).decode()
    return f'<img class="logo" alt="" src="data:{logo_type(logo)};base64,{data}">\n'


def _section(section: Section[str], report: Report[str], render: Render) -> str:
    blocks = "".join(_block(block, render) for block in section.blocks)
    result = f'<p class="small">{escape(result_line(report))}</p>' if section.is_signed else ""
    kind = ' class="signed"' if section.is_signed else ""
    return f"<section{kind}><h2>{escape(section.title)}</h2>{result}{blocks}</section>\n"


def _block(block: Block[str], render: Render) -> str:
    match block:
        case Facts():
            rows = "".join(
                f"<div><dt>{escape(name)}</dt><dd>{escape(value)}</dd></div>"
                for name, value in block.rows
            )
            return f'<dl class="facts">{rows}</dl>'
        case ReportTable():
            return _table(block)
        case TextBlock():
            kind = ' class="small"' if block.small else ""
            return f"<p{kind}>{escape(block.text)}</p>"
        case Findings():
            rows = "".join(
                f'<li><b class="{row.quality}">{escape(render(MARKS[row.quality]))}</b>'
                f'<span>{escape(row.text)} <span class="small">{escape(row.remedy)}</span></span>'
                "</li>"
                for row in block.rows
            )
            return f'<ul class="findings">{rows}</ul>'
        case Pictures():
            figures = "".join(
                f"<figure>{svg(figure)}<figcaption>{escape(caption)}</figcaption></figure>"
                for figure, caption in block.figures
            )
            columns = f"grid-template-columns: repeat({block.across}, minmax(0, 1fr))"
            return f'<div class="pictures" style="{columns}">{figures}</div>'
        case Signatures():
            lines = "".join(f"<div>{escape(line)}</div>" for line in block.lines)
            return f'<div class="signatures">{lines}</div>'


def _table(table: ReportTable[str]) -> str:
    def cells(row: Sequence[str], tag: str) -> str:
        kinds = ["" if i < table.numbers else ' class="n"' for i in range(len(row))]
        texts = zip(kinds, row, strict=True)
        return "".join(f"<{tag}{kind}>{escape(text)}</{tag}>" for kind, text in texts)

    total = sum(table.widths)
    shares = "".join(f'<col style="width:{100 * w / total:.1f}%">' for w in table.widths)
    head = f"<colgroup>{shares}</colgroup><thead><tr>{cells(table.columns, 'th')}</tr></thead>"
    body = "".join(f"<tr>{cells(row, 'td')}</tr>" for row in table.rows)
    kind = ' class="tight"' if table.small else ""
    return f'<div class="wide"><table{kind}>{head}<tbody>{body}</tbody></table></div>'
