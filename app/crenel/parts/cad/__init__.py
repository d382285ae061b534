"""Files of a part's nominal shape, as meshes, and the closest point of one."""
