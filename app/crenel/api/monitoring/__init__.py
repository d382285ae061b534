"""Routes about the station itself: health, metrics, notifications and support bundles."""
