"""The report of a verification: what it says, its tables and its figures."""
