"""The station under faults: killed, on a full disk, on damaged files, flooded, lied to."""
