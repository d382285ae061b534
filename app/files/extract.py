"""Stripes of pictures as a table."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from app.files.atomic import write_atomically
from app.files.images import read_grey
from app.files.mask import Mask
from app.files.progress import Progress, no_progress
from app.files.tables import table_text
from app.metrology.refusal import Refusal
from app.metrology.stripe import AUTOMATIC, Stripe, StripeSettings, extract_stripe

COLUMNS = ("u", "v", "intensity", "sigma_px")


@dataclass(frozen=True)
class PictureStripe:
    """The stripe found in one picture file."""

    file: Path
    stripe: Stripe


def extract(
    images: Sequence[Path],
    axis: str,
    progress: Progress = no_progress,
    settings: StripeSettings = AUTOMATIC,
    mask: Mask | None = None,
) -> list[PictureStripe]:
    """The stripe of every picture, outside a mask's zones.

    Raises:
        Refusal: a picture cannot be read, has none, or is of another size than the mask.
    """
    found: list[PictureStripe] = []
    where = None if mask is None else mask.where()
    for done, path in enumerate(images):
        progress(done / len(images), path.name)
        picture = read_grey(path)
        if mask is not None:
            mask.check_size(path, picture.shape[1], picture.shape[0])
        stripe = extract_stripe(picture, axis, where, settings)
        if not len(stripe.u):
            raise Refusal(
                "stripe-not-found",
                f"{path} shows no laser stripe{' outside the mask' if mask else ''}",
                f"no bright line runs {'across' if axis == 'u' else 'down'} the picture",
                "Take it with the laser on and the exposure set, or choose the other --axis",
            )
        found.append(PictureStripe(path, stripe))
    progress(1.0, "")
    return found


def write_stripes(path: Path, stripes: Sequence[PictureStripe]) -> None:
    """Writes ``u,v,intensity,sigma_px``; of several pictures with a last column ``image``."""
    several = len(stripes) > 1
    rows: list[tuple[float | str, ...]] = []
    for picture in stripes:
        stripe = picture.stripe
        mark = (str(picture.file),) if several else ()
        columns = (stripe.u, stripe.v, stripe.intensity, stripe.sigma_px)
        points = zip(*(column.tolist() for column in columns), strict=True)
        rows.extend((*point, *mark) for point in points)
    text = table_text((*COLUMNS, "image") if several else COLUMNS, rows)
    write_atomically(path, text.encode())
