"""Registers that the standard GigE Vision gives every camera."""
