"""Labels and scale bar of the 3D view in the unit and language of one browser.

viser sends every browser the same data, in English and millimetres.
"""

import re

import numpy as np

from crenel.api.viewer.frames import Message, decompress_messages, pack_frame, unpack_frame
from crenel.messages.catalogue import renderer
from crenel.messages.message import message, quantity
from crenel.station.view3d.scale_bar import ROOT, round_length_mm

MM_PER_INCH = 25.4
LENGTH = re.compile(r"(.*?)([0-9.]+) mm")
SHAPE = re.compile(r"(Plane|Sphere|Cylinder) (\d+)")
TOUCHED = (b"LabelMessage", f"{ROOT}/".encode())
"""What a frame has in it that is not relayed as it is."""
MOST_DECIMALS = 2


class LabelWriter:
    """Relays the frames of one browser, with lengths in inches or labels in another language.

    In inches, the scale bar has a round length of its own.
    """

    def __init__(self, inch: bool, language: str) -> None:
        self._inch, self._render = inch, renderer(language)
        self._bar_factor = 1.0

    def filter_frame(self, frame: bytes) -> bytes:
        """A frame of viser's socket as the browser receives it."""
        if not any(part in decompress_messages(frame) for part in TOUCHED):
            return frame
        content, arrays = unpack_frame(frame)
        for each in content["messages"]:
            name = str(each.get("name", ""))
            if self._inch and name.startswith(f"{ROOT}/"):
                self._scale_bar(each, name, arrays)
            if each["type"] == "LabelMessage":
                each["props"]["text"] = self._text(each["props"]["text"], name)
        return pack_frame(content, arrays)

    def _scale_bar(self, each: Message, name: str, arrays: list[bytes]) -> None:
        """Stretches its parts to a round length; the first of them ends where the bar does."""
        if each["type"] == "SetPositionMessage":
            each["position"] = [x * self._bar_factor for x in each["position"]]
        if "vertices" not in each.get("props", {}):
            return
        index = each["props"]["vertices"]["__binary_index"]
        vertices = np.frombuffer(arrays[index], np.float32)
        if name == f"{ROOT}/dark":
            length_in = 1e3 * float(vertices[::3].max()) / MM_PER_INCH
            self._bar_factor = round_length_mm(length_in) / length_in
        arrays[index] = (vertices * np.float32(self._bar_factor)).tobytes()

    def _text(self, text: str, name: str) -> str:
        if found := SHAPE.fullmatch(text):
            return self._render(message("shape-label", shape=found[1].lower(), n=int(found[2])))
        found = LENGTH.fullmatch(text)
        if found is None or not self._inch:
            return text
        length_in = float(found[2]) / MM_PER_INCH
        if name.startswith(f"{ROOT}/"):
            length_in = round_length_mm(length_in)
        decimals = next(
            (n for n in range(MOST_DECIMALS) if round(length_in, n) == round(length_in, 6)),
            MOST_DECIMALS,
        )
        return f"{found[1]}{self._render(quantity(length_in, '', decimals))} in"
