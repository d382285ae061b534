"""The stripe sensor: camera, light plane, and points from pixels (Eq. 9)."""
