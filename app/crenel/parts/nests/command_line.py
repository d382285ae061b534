"""``crenel moved``: whether anything has moved since the nests were touched."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from crenel.console import AsJson, fail, print_json, print_table, report_errors, warn
from crenel.parts.command_line import SOME_FAIL, SOME_UNDECIDED

if TYPE_CHECKING:
    from crenel.parts.nests.evaluate_moved import MovedCheck
    from crenel.parts.nests.maths_moved import Hypothesis


@report_errors
def check_nests(
    before: Annotated[
        Path,
        typer.Argument(metavar="BEFORE.csv", help="Touches of the nests, named in feature."),
    ],
    after: Annotated[Path, typer.Argument(metavar="AFTER.csv", help="Touches of the same again.")],
    part: Annotated[
        str, typer.Option(help="Nests on the part, with commas; the others are on the base.")
    ] = "",
    calibration: Annotated[
        Path | None, typer.Option(help="calibration.json; default: beside BEFORE.csv.")
    ] = None,
    arm: Annotated[Path | None, typer.Option(help="arm.json; default: beside BEFORE.csv.")] = None,
    as_json: AsJson = False,
) -> None:
    """Tell whether a nest, the part, or all against the arm has moved, by three nests or more.

    Ends with status 0 if nothing moved, 4 if something did, 5 if nothing says what.
    """
    from crenel.parts.nests.evaluate_moved import check_moved

    check = check_moved(
        before,
        after,
        calibration or before.parent / "calibration.json",
        arm or before.parent / "arm.json",
        [name.strip() for name in part.split(",") if name.strip()],
    )
    for text in check.warnings:
        warn(text)
    if as_json:
        print_json(_fields(check))
    else:
        rows = [
            (one.nest, f"{1e3 * one.length_mm:.1f} µm", f"{2e3 * one.u_mm:.1f} µm")
            for one in check.shifts
        ]
        print_table("Nests", ("nest", "shift", "U (k = 2)"), rows)
        chances = [(_describe(check, one), f"{one.chance:.2g}") for one in check.hypotheses]
        print_table("Hypotheses", ("moved", "chance"), chances)
    chosen = check.chosen
    if chosen is None:
        fail("something has moved, and the nests do not tell what", SOME_UNDECIDED)
    if chosen.culprit != "nothing":
        fail(f"moved: {_describe(check, chosen)}", SOME_FAIL)


def _describe(check: "MovedCheck", hypothesis: "Hypothesis") -> str:
    names = ", ".join(check.names(hypothesis))
    return {
        "nothing": "nothing",
        "nest": f"nest {names} alone",
        "part": f"the part with its nests {names}",
        "all": "all nests together, against the arm",
    }[hypothesis.culprit]


def _fields(check: "MovedCheck") -> dict[str, object]:
    """The check for programs."""
    chosen = check.chosen
    return {
        "moved": "unknown" if chosen is None else chosen.culprit,
        "moved_nests": [] if chosen is None else check.names(chosen),
        "nests": [
            {
                "nest": one.nest,
                "shift_mm": list(one.shift_mm),
                "standard_uncertainty_mm": one.u_mm,
            }
            for one in check.shifts
        ],
        "hypotheses": [
            {
                "moved": one.culprit,
                "nests": check.names(one),
                "chi_square": one.chi_square,
                "freedom": one.freedom,
                "chance": one.chance,
            }
            for one in check.hypotheses
        ],
        "warnings": list(map(str, check.warnings)),
    }
