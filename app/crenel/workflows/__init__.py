"""Jobs on files: calibrate, identify, reconstruct, verify, evaluate performance tests.

Each module reads its inputs, calls the mathematics and returns or writes the result. The command
line and the guides call them.
"""
