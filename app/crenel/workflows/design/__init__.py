"""What is made of a designed block: its drawing, and its files."""
