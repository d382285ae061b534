"""Blocks that are designed for pages: what each wants last, and nothing for those that are gone."""

import threading
from collections.abc import Iterator
from dataclasses import replace
from typing import cast

import pytest

from crenel.errors import OperationError
from crenel.metrology.design.propose_block import BlockDesign
from crenel.operations.datasheets import block_designs
from crenel.operations.datasheets.block_designs import BlockDesigns, DesignProgress, order_id
from crenel.progress import Progress
from crenel.workflows.design.ordered_block import BlockOrder, OrderedBlock
from tests.api.conftest import until, wait_for

ORDER = BlockOrder(55.0, 20.0, 30.0, standoff_mm=115.0, size_px=(1280, 1024), stripe_axis="u")
OTHER = replace(ORDER, field_of_view_mm=60.0)
FLAT = replace(ORDER, depth_of_field_mm=1.0)


class Workshop:
    """Stands for the design: it reports progress until it may be done."""

    def __init__(self) -> None:
        self.begun: list[BlockOrder] = []
        self.given_up: list[BlockOrder] = []
        self.may_end = threading.Event()

    def design_block(self, order: BlockOrder, name: str, progress: Progress) -> OrderedBlock:
        self.begun.append(order)
        if order == FLAT:
            raise OperationError("sensor-numbers", "too flat")
        try:
            while not self.may_end.wait(0.005):
                progress(0.5, "half done")
        except BaseException:
            self.given_up.append(order)
            raise
        return OrderedBlock(cast(BlockDesign, order))


@pytest.fixture
def workshop(monkeypatch: pytest.MonkeyPatch) -> Workshop:
    made = Workshop()
    monkeypatch.setattr(block_designs, "design_block", made.design_block)
    return made


@pytest.fixture
def designs(workshop: Workshop) -> Iterator[BlockDesigns]:
    made = BlockDesigns()
    yield made
    made.close()


def test_the_newest_order_of_a_page_wins(workshop: Workshop, designs: BlockDesigns) -> None:
    wait_for(
        lambda: designs.ask("page", ORDER), lambda found: found == DesignProgress(0.5, "half done")
    )
    designs.ask("page", OTHER)
    until(lambda: workshop.begun == [ORDER, OTHER])
    assert workshop.given_up == [ORDER]
    workshop.may_end.set()
    found = wait_for(
        lambda: designs.ask("page", OTHER), lambda found: isinstance(found, OrderedBlock)
    )
    assert designs.find(order_id(OTHER)) is found
    with pytest.raises(OperationError, match="not kept"):
        designs.find(order_id(ORDER))


def test_pages_do_not_take_the_place_of_each_other(
    workshop: Workshop, designs: BlockDesigns
) -> None:
    for page, order in (("one", ORDER), ("other", OTHER)):
        designs.ask(page, order)
    workshop.may_end.set()
    for page, order in (("one", ORDER), ("other", OTHER)):
        wait_for(
            lambda page=page, order=order: designs.ask(page, order),  # type: ignore[misc]
            lambda found: isinstance(found, OrderedBlock),
        )
    assert workshop.begun == [ORDER, OTHER]
    assert not workshop.given_up


def test_a_page_that_is_closed_is_not_worked_for(
    workshop: Workshop, designs: BlockDesigns, monkeypatch: pytest.MonkeyPatch
) -> None:
    designs.ask("page", ORDER)
    until(lambda: workshop.begun)
    monkeypatch.setattr(block_designs, "WANTED_S", 0.0)
    until(lambda: workshop.given_up == [ORDER])


def test_a_refusal_is_said_and_not_tried_again(workshop: Workshop, designs: BlockDesigns) -> None:
    def refused() -> bool:
        try:
            designs.ask("page", FLAT)
        except OperationError as error:
            return error.code == "sensor-numbers"
        return False

    until(refused)
    assert refused()
    assert workshop.begun == [FLAT]


def test_the_end_of_the_station_gives_the_work_up(
    workshop: Workshop, designs: BlockDesigns
) -> None:
    designs.ask("page", ORDER)
    until(lambda: workshop.begun)
    designs.close()
    assert workshop.given_up == [ORDER]
    designs.ask("page", OTHER)
    assert workshop.begun == [ORDER]
