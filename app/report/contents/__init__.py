"""What each kind of report contains; ``html`` and ``pdf`` render it."""
