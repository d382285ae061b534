"""Signing in with accounts of a provider."""
