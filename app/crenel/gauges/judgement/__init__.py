"""From what was measured to values, their uncertainties and decisions."""
