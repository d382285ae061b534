"""The content of each kind of report; ``html`` and ``pdf`` render it."""
