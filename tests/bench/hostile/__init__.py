"""Kinds of hostile inputs, each with what must not become of it."""
