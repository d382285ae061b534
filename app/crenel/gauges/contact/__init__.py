"""The tests of an arm with a touching tip."""
