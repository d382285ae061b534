"""The steps from each version of the catalogue to the next, for alembic."""
