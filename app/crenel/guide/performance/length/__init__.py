"""The guided length test: its order, what is measured so far, and what is drawn."""
