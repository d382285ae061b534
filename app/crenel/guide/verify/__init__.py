"""The guided verification on a plane or a sphere."""
