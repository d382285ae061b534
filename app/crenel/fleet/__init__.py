"""The fleet: a catalogue of what all stations recorded, how it is collected, and what it answers.

Start with ``catalogue/catalogue.py``. ``collection`` reads the records of archives and data folders
into it.
"""
