"""Tests of app/crenel/workflows."""
