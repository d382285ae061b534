"""What the sessions on a gauge share: verification and performance test."""
