"""The gauges of the guided tests: each as it is, its datasheet, and how the operator uses it."""
