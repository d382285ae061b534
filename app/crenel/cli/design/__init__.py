"""``crenel design``: calibration targets for a sensor, before they are made."""

import typer

from crenel.cli.design.block import block
from crenel.cli.design.board import board
from crenel.console import FullHelpGroup

design = typer.Typer(cls=FullHelpGroup, help="Design an object for a sensor.", no_args_is_help=True)
design.command()(block)
design.command()(board)
