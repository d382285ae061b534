"""Results of inspections for other programs: CSV, XLSX, QIF 3.0."""
