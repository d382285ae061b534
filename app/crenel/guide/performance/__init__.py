"""The guided performance tests: one sphere, lengths, a plane, and the contact tests."""
