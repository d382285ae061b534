"""Results for other programs: tables as CSV and XLSX, QIF 3.0, and validation by a schema."""
