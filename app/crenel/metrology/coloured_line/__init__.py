"""The laser line of a colour picture, found by its colour: in lit rooms, much is as bright.

1. ``excess.py``: what each pixel shows of the laser's colour beyond its neighbourhood, and the
   ridges of that, at four widths.
2. ``path.py``: the path across the columns that collects most of them.
3. ``pieces.py``: the pieces of the path that are light of a laser, by colour, shape and sides.
4. ``line.py``: the colour whose pieces show most, and the path again for lines of their width.
5. ``measure.py``: the centre of the line in each column, on the quietest combination of channels.
"""

from crenel.metrology.coloured_line.line import ColouredLine, find_coloured_line

__all__ = ["ColouredLine", "find_coloured_line"]
