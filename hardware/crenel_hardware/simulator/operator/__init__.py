"""The simulated operator: plans and carries out moves of the arm."""
