"""What several files of this folder look at."""

import pytest

from tests.metrology.rendered_block import RenderedBlock, render_block


@pytest.fixture(scope="session")
def plain() -> RenderedBlock:
    """A block of four merlons that shows well; not to be changed in place."""
    return render_block(1, merlons=4)
