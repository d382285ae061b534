"""Performance tests of an arm and its scanner: their plan, their results, and the symbols."""
