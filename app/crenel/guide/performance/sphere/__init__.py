"""The guided one-sphere test: its places, and what a scan covers while it runs."""
