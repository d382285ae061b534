"""``python -m tests.bench real``: boards and lines in pictures that others took."""
