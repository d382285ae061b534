"""Parts: features, dimensions and alignments from scans and touches, with their uncertainty."""
