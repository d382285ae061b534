"""Benches of accuracy, each a command of its own."""

import app  # noqa: F401  # sets the numerical libraries' threads before numpy is loaded
