"""Tests of work over many recordings."""
