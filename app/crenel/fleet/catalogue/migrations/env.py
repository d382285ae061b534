"""Run by alembic: applies the steps within the transaction of the connection that it is given."""

from alembic import context

from crenel.fleet.catalogue.tables import CatalogueTable

context.configure(
    connection=context.config.attributes["connection"],
    target_metadata=CatalogueTable.metadata,
    render_as_batch=True,
)
with context.begin_transaction():
    context.run_migrations()
