"""What performance tests are done on: gauges of the data folder."""
