"""How the command line speaks: results on stdout, progress and errors on stderr."""

import errno
import json
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import wraps
from typing import Annotated, Any, NoReturn, ParamSpec

import typer
from typer.core import TyperGroup

from crenel.errors import OperationError
from crenel.messages.language_file import languages
from crenel.messages.message import Text
from crenel.native.sources import LibraryError
from crenel.progress import Progress, no_progress
from crenel_hardware.errors import DeviceError

P = ParamSpec("P")
AsJson = Annotated[bool, typer.Option("--json", help="Print the result for programs on stdout.")]
Language = Annotated[
    str, typer.Option("--language", help=f"Of what is written: {', '.join(languages())}.")
]

FAILED = 1
SOME_LEFT_OUT = 3
"""The result is there without a part of what was asked for: pictures that cannot be read or do not
show what was looked for, recordings that are refused, more than a tenth of a scan. 2 is a wrong
command line."""
INTERRUPTED = 130


class FullHelpGroup(TyperGroup):
    """Commands whose list shows each summary in full, where click would cut it."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:  # click's, private in typer
        commands = [(name, self.get_command(ctx, name)) for name in self.list_commands(ctx)]
        rows = [
            (name, command.get_short_help_str(limit=1000))
            for name, command in commands
            if command is not None and not command.hidden
        ]
        with formatter.section("Commands"):
            formatter.write_dl(rows)


def report_errors(command: Callable[P, None]) -> Callable[P, None]:
    """A command whose failures end in one line on stderr and status 1, never in a traceback.

    Python's development mode (``python -X dev``) lets a fault of the program itself
    through, traceback and all.
    """

    @wraps(command)
    def guarded(*args: P.args, **kwargs: P.kwargs) -> None:
        try:
            command(*args, **kwargs)
        except OperationError as error:
            fail(error.line)
        except KeyboardInterrupt:
            fail("interrupted.", INTERRUPTED)
        except (DeviceError, LibraryError) as error:
            fail(str(error))
        except OSError as error:
            if error.errno == errno.EPIPE:  # who read our output has gone
                raise
            from crenel.formats.io_errors import error_from_os  # not what every command waits for

            fail(error_from_os(error).line)
        except MemoryError:
            fail("there is not enough memory. Close other programs, or use less data.")
        except (typer.Exit, typer.Abort, typer.BadParameter):
            raise
        except Exception as error:
            if sys.flags.dev_mode:
                raise
            fail(f"internal error: {type(error).__name__}: {error}. Please report it.")

    return guarded


def fail(text: str, status: int = FAILED) -> NoReturn:
    """Says why on one line of stderr and ends with ``status``."""
    print("crenel: " + " ".join(text.split()), file=sys.stderr)
    raise typer.Exit(status)


def fail_if_left_out(left_out: int, of: int, none: str, some: str) -> None:
    """The end of every command over many inputs of which each counts by itself.

    Args:
        left_out: inputs of which nothing was found or made, ``of`` how many.
        none: said where that is all of them; the status is then ``FAILED``.
        some: said where it is a part of them; the status is then ``SOME_LEFT_OUT``.
    """
    if left_out:
        fail(*((none, FAILED) if left_out >= of else (some, SOME_LEFT_OUT)))


def warn(text: Text) -> None:
    """One line of warning on stderr."""
    print("crenel: warning: " + " ".join(str(text).split()), file=sys.stderr)


def print_json(result: Mapping[str, object]) -> None:
    """A result for programs: the only thing on stdout."""
    print(json.dumps(result, indent=1, ensure_ascii=False, allow_nan=False))


@contextmanager
def progress_bar(title: str, shown: bool = True) -> Iterator[Progress]:
    """A bar on stderr while the block runs, where stderr is a terminal.

    Yields:
        Called with the share done (0 to 1) and, where it changes, what is being done.
    """
    if not (shown and sys.stderr.isatty()):
        yield no_progress
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn("{task.description}"), BarColumn(40), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(title, total=1.0)

        def report(share: float, text: Text) -> None:
            bar.update(task, completed=share, description=str(text) or title)

        yield report


def print_figures(title: str, figures: Sequence[tuple[Text, Text]]) -> None:
    """A list of named figures under a title."""
    from rich.table import Table

    table = Table.grid(padding=(0, 2))
    table.add_column(style="dim")
    table.add_column()
    for name, value in figures:
        table.add_row(str(name), str(value))
    _print(title, table)


def print_table(title: str, columns: Sequence[Text], rows: Sequence[Sequence[Text]]) -> None:
    """A table whose first column is text and the others are numbers."""
    from rich import box
    from rich.table import Table

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 1))
    for i, column in enumerate(columns):
        table.add_column(str(column), justify="left" if i == 0 else "right", overflow="fold")
    for row in rows:
        table.add_row(*map(str, row))
    _print(title, table)


def _print(title: str, content: object) -> None:
    from rich.console import Console

    console = Console(emoji=False, highlight=False, markup=False)
    if not console.is_terminal:  # a file or a pipe has no width to fold at
        console = Console(emoji=False, highlight=False, markup=False, width=200)
    console.print(title, style="bold")
    console.print(content)
