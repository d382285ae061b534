"""A circuit board around the machine code of the firmware."""
