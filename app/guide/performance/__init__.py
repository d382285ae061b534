"""The guided performance test: one sphere, touched and scanned."""
