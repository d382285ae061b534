"""What is tested, on which artefacts, with which limits."""
