"""Finding the object in a picture: its edges, its corners, and what is wrong where it is not."""
