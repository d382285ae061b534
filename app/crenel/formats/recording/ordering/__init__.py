"""The order of a recording: its readings by time, and what its clocks did."""
