"""Catalogues of many stations: invented records, and how fast they are stored and found."""
