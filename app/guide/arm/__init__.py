"""The arm's own flows: the daily articulation check, and its identification from several seats."""
