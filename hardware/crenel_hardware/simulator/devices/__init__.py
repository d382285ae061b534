"""The simulated arm as its cable shows it, and a fast sensor for benchmarks."""
