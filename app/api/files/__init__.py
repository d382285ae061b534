"""Files that are served: the built client, and files of the data folder."""
