"""Times extraction for ``extraction_paired``, in a process of its own.

It may be run by the interpreter of another checkout, so it uses nothing but ``extract_stripe``.
It reads frames from the file that is named first, then answers each line ``hot BITS`` or ``cold
BITS`` with the seconds that a frame takes: one frame again and again, or all frames in turn.
"""

import sys
import time

import numpy as np

from crenel import extract_stripe

with np.load(sys.argv[1]) as file:
    pools = {bits: list(file[bits]) for bits in file.files}
for pool in pools.values():
    for image in pool:
        extract_stripe(image)
print("ready", flush=True)
for line in sys.stdin:
    kind, bits = line.split()
    images = pools[bits] if kind == "cold" else pools[bits][:1] * len(pools[bits])
    extract_stripe(images[0])
    begin = time.perf_counter()
    for image in images:
        extract_stripe(image)
    print((time.perf_counter() - begin) / len(images), flush=True)
