"""The arm itself: its geometric parameters identified, and its daily check."""
