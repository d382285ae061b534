"""The report of an inspection, as a page and on paper."""
