"""Mathematics of parts: errors of points, features, alignments and dimensions."""
