"""The archive: finished records are copied to another place, verified by their hashes."""
