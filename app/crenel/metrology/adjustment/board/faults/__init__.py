"""What is wrong with poses that do not agree with the pictures of a board."""
