"""Coloured triangles as GLB, the binary form of glTF 2.0, drawn as they are coloured."""

import json
import struct

import numpy as np

from crenel.metrology.colormaps import Bytes
from crenel.metrology.transforms import Floats

MAGIC, VERSION = 0x46546C67, 2
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942
FLOAT, UNSIGNED_SHORT = 5126, 5123
UNLIT = "KHR_materials_unlit"
FULL = 65535


def glb_bytes(corners_m: Floats, colours: Bytes) -> bytes:
    """A file of triangles, without any light but their own.

    Args:
        corners_m: (N, 3, 3) of triangles, metres, seen from both sides.
        colours: (N, 3) of each, sRGB.
    """
    positions = corners_m.reshape(-1, 3).astype("<f4")
    # glTF has colours of vertices as light, not as sRGB
    share = colours.astype(np.float64) / 255
    linear = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
    rgba = np.full((len(colours), 4), FULL, "<u2")
    rgba[:, :3] = np.rint(FULL * linear)
    shades = np.repeat(rgba, 3, axis=0)
    binary = positions.tobytes() + shades.tobytes()
    count, split = len(positions), positions.nbytes
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": [UNLIT],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}, "material": 0}]}],
        "materials": [{"doubleSided": True, "extensions": {UNLIT: {}}}],
        "buffers": [{"byteLength": len(binary)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": split},
            {"buffer": 0, "byteOffset": split, "byteLength": shades.nbytes},
        ],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": FLOAT,
                "count": count,
                "type": "VEC3",
                "min": positions.min(axis=0).tolist(),
                "max": positions.max(axis=0).tolist(),
            },
            {
                "bufferView": 1,
                "componentType": UNSIGNED_SHORT,
                "normalized": True,
                "count": count,
                "type": "VEC4",
            },
        ],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = (
        struct.pack("<II", len(text), JSON_CHUNK)
        + text
        + struct.pack("<II", len(binary), BINARY_CHUNK)
        + binary
    )
    return struct.pack("<III", MAGIC, VERSION, 12 + len(chunks)) + chunks
