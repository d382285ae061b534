"""Benches of accuracy, each a command of its own."""

import crenel  # noqa: F401  # sets the numerical libraries' threads before numpy is loaded
