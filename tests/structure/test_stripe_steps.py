"""The steps of the stripe's extraction carry one numbering, in the package and in the C files."""

import re

import crenel.metrology.stripe as stripe
from tests.sources import ROOT

SOURCES = ROOT / "app/crenel/native/c/stripe"


def test_each_file_names_its_step() -> None:
    assert stripe.__doc__
    plain, clipped = stripe.__doc__.split("``pipeline.c`` reads top to bottom")
    for text, beginning in ((plain, "/* Step {}:"), (clipped, "/* A clipped line, step {}:")):
        steps = re.findall(r"^(\d+)\. ``(\w+\.c)``", text, re.MULTILINE)
        assert [int(number) for number, _ in steps] == list(range(1, len(steps) + 1))
        for number, name in steps:
            assert (SOURCES / name).read_text().startswith(beginning.format(number)), name
