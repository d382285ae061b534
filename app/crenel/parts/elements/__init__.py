"""Elements picked in the points of scans, and dimensions between them, with their uncertainty."""
