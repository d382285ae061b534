"""Device drivers, their interfaces, and a simulated station. Never imports ``app``."""
