"""From the folders of records, in archives and on stations, to entries of the catalogue."""
