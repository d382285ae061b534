"""Setting up the devices: finding and trying them, and the options of their drivers."""
