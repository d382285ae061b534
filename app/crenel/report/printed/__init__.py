"""Drawings and boards to print, each a page of PDF to scale."""
