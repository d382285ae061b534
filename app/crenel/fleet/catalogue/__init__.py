"""The catalogue's database: tables, migrations, writing and reading."""
