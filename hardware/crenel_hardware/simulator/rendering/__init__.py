"""The simulated camera: rendered images with light, noise and degradations."""
