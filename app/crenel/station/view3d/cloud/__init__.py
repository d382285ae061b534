"""What the clouds of the 3D view consist of, and what is cut away of them."""
