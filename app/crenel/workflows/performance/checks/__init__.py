"""What speaks against figures: artefacts, how the arm was held, temperatures."""
