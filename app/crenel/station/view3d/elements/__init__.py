"""Elements fitted to picked points in the 3D view, and dimensions between them."""
