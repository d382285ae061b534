"""A finished scan beside its part in the browser: parts that are kept, maps, their picture."""
