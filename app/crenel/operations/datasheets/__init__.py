"""The datasheets of a station: what they say, where they are, and how they change."""
