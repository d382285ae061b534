"""What becomes of finished clouds: pictures, merged clouds, comparisons."""
