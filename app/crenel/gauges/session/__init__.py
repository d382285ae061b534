"""What a session on a gauge takes down: touches, scans, temperatures."""
