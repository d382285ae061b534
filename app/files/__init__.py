"""Every file format of the station: read, validated, written atomically."""
