"""The delay between the clocks of arm and camera, in simulated passes over a plate."""
