"""Routes of datasheets, and of objects that are designed before they have one."""
