"""A figure as SVG within a page."""

import base64
from html import escape

from crenel.messages.catalogue import isolate_names
from crenel.report.figure import Dot, Figure, Item, Photo, Polyline
from crenel.report.formatting import join_units


def svg(figure: Figure[str]) -> str:
    """One ``svg`` element; all texts escaped."""
    size = f'viewBox="0 0 {figure.width:g} {figure.height:g}" width="{figure.width:g}"'
    inner = "".join(_item(item) for item in figure.items)
    return f'<svg {size} role="img" aria-label="{escape(figure.title)}">{inner}</svg>'


def _item(item: Item[str]) -> str:
    if isinstance(item, Polyline):
        return _shape(item)
    if isinstance(item, Dot):
        x, y = item.at
        return f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{item.radius:g}"{_paint(item)}/>'
    x, y = item.at
    if isinstance(item, Photo):
        data = base64.b64encode(item.jpeg).decode()
        place = f'x="{x:.2f}" y="{y:.2f}" width="{item.width:.2f}" height="{item.height:.2f}"'
        return f'<image {place} href="data:image/jpeg;base64,{data}"/>'
    weight = ' font-weight="600"' if item.bold else ""
    look = f'font-size="{item.size:g}" fill="{item.colour}" text-anchor="{item.anchor}"{weight}'
    text = escape(isolate_names(join_units(item.text)))
    return f'<text x="{x:.2f}" y="{y:.2f}" {look}>{text}</text>'


def _shape(shape: Polyline) -> str:
    points = " ".join(f"{x:.2f},{y:.2f}" for x, y in shape.points)
    dash = f' stroke-dasharray="{shape.dash[0]:g} {shape.dash[1]:g}"' if shape.dash else ""
    name = "polygon" if shape.closed else "polyline"
    return f'<{name} points="{points}"{_paint(shape)}{dash}/>'


def _paint(item: Polyline | Dot) -> str:
    fill = f' fill="{item.fill or "none"}"'
    if not item.stroke:
        return fill
    return f'{fill} stroke="{item.stroke}" stroke-width="{item.width:g}"'
