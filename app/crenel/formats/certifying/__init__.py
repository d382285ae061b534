"""Certificates of blocks: readings and touches of their faces, as tables."""
