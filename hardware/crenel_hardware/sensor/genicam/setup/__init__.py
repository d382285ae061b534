"""What is set in a camera before it sends anything, and what it may refuse."""
