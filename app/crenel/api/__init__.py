"""Thin HTTP and WebSocket routes: check, call, answer."""
