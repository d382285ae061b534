"""What stands on the simulated table, and its datasheets."""
