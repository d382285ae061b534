"""Health of the storage: disk, folders, database, records, recordings and backups."""

from collections.abc import Sequence

from crenel.errors import OperationError, sentence
from crenel.findings import Quality
from crenel.messages.message import Text, join, message, quantity
from crenel.monitoring.health import HealthItem

DISK_ATTENTION_GB, DISK_BAD_GB = 10.0, 1.0
BACKUP_DAYS = 7.0
LISTED_RECORDS, LISTED_DATASHEETS = 3, 200


def disk(free_gb: float, megabytes_s: float | None) -> HealthItem:
    """Whether there is space to record."""
    quality: Quality = "good"
    if free_gb < DISK_BAD_GB:
        quality = "bad"
    elif free_gb < DISK_ATTENTION_GB:
        quality = "attention"
    what = message("free", free=quantity(free_gb, "GB", 1))
    if megabytes_s:
        what = message(
            "free-enough-for-hours",
            free=quantity(free_gb, "GB", 1),
            hours=quantity(1000 * free_gb / megabytes_s / 3600, "", 1),
        )
    return HealthItem(
        "disk",
        message("disk"),
        quality,
        what,
        message("scan-does-start-less-than-0"),
        "" if quality == "good" else message("delete-scans-under-records-use-larger"),
    )


def folder(trouble: Text) -> HealthItem:
    """Whether records can be written."""
    return HealthItem(
        "folder",
        message("data-folder"),
        "bad" if trouble else "good",
        message("cannot-written", trouble=trouble) if trouble else message("can-written"),
        message("recordings-calibrations-journal-kept-there"),
        message("check-folders-owner-whether-disk-mounted") if trouble else "",
    )


def database(size_mb: float, trouble: str) -> HealthItem:
    """Whether the database is intact."""
    return HealthItem(
        "database",
        message("database"),
        "bad" if trouble else "good",
        message("damaged", trouble=trouble)
        if trouble
        else message("whole", size_mb=quantity(size_mb, "MB", 1)),
        message("holds-journal-every-step-accounts-what"),
        message("stop-station-keep-copy-data-folder") if trouble else "",
    )


def records(unreadable: Sequence[Text]) -> HealthItem:
    """Whether all stored records can be read; ``unreadable``: one sentence for each that cannot."""
    listed = _first(unreadable, LISTED_RECORDS)
    return HealthItem(
        "records",
        message("records"),
        "bad" if listed else "good",
        join(listed, " ") if listed else message("all-kept-can-read"),
        message("what-cannot-read-set-aside-everything"),
        message("put-file-back-last-backup-leave") if listed else "",
    )


def datasheets(aside: Sequence[Text]) -> HealthItem:
    """Whether all datasheets and certificates can be used; ``aside``: a sentence for each that
    cannot."""
    listed = _first(aside, LISTED_DATASHEETS)
    return HealthItem(
        "datasheets",
        message("datasheets"),
        "attention" if listed else "good",
        join(listed, " ") if listed else message("all-datasheets-can-read"),
        message("datasheets-set-aside-everything"),
        message("correct-remove-files-named") if listed else "",
    )


def _first(sentences: Sequence[Text], most: int) -> list[Text]:
    """The first of the sentences, and how many more there are."""
    more = len(sentences) - most
    rest = [message("and-more-records", count=more)] if more > 0 else []
    return [*sentences[:most], *rest]


def recordings(damaged: Sequence[Text]) -> HealthItem:
    """Whether the recordings are present and unchanged."""
    what = message("all-there-they-were-recorded")
    if damaged:
        what = message("recordings-damaged", first=damaged[0], more=len(damaged) - 1)
    return HealthItem(
        "recordings",
        message("recordings"),
        "bad" if damaged else "good",
        what,
        message("scan-can-made-again-recording-verification"),
        message("bring-back-last-backup-delete-under") if damaged else "",
    )


def backup(days: float | None, place: str, same_disk: bool, trouble: Text) -> HealthItem:
    """Whether the station could be restored from a backup."""
    why = message("disk-fails-takes-every-calibration-scan")
    remedy = message("make-one-below-crenel-backup")
    if trouble:
        return HealthItem("backup", message("backup"), "bad", trouble, why, remedy)
    if days is None:
        return HealthItem(
            "backup", message("backup"), "attention", message("there-none-yet"), why, remedy
        )
    what = message("last-days-old", days=quantity(days, "", 1), place=place)
    if days > BACKUP_DAYS:
        return HealthItem("backup", message("backup"), "attention", what, why, remedy)
    if same_disk:
        what = message("last-days-old-same-disk", days=quantity(days, "", 1), place=place)
        remedy = message("name-folder-another-disk-backups-station")
        return HealthItem("backup", message("backup"), "attention", what, why, remedy)
    return HealthItem("backup", message("backup"), "good", what, why, "")


def archive(
    place: str,
    waiting: int,
    waiting_gb: float,
    archived: int,
    away: int,
    trouble: OperationError | None,
    retry_s: float,
) -> HealthItem:
    """Whether finished records arrive in the archive.

    Args:
        archived: records that are here, too.
        away: records that are there only.
        retry_s: until the next attempt.
    """
    title, why = message("archive"), message("archive-why")
    if trouble is not None and trouble.code == "archive-inside":
        what, remedy = trouble.reason, sentence(trouble.remedy)
        return HealthItem("archive", title, "bad", what, why, remedy)
    if trouble is not None:
        what = message(
            "archive-trouble",
            trouble=trouble.reason,
            waiting=waiting,
            minutes=quantity(retry_s / 60, "min", 0),
        )
        remedy = sentence(trouble.remedy) if trouble.remedy else message("archive-look-at-log")
        return HealthItem("archive", title, "attention", what, why, remedy)
    if waiting:
        size = quantity(waiting_gb, "GB", 2)
        what = message("archive-copying", place=place, waiting=waiting, size=size)
        return HealthItem("archive", title, "good", what, why, "")
    what = message("archive-complete", place=place, archived=archived, away=away)
    return HealthItem("archive", title, "good", what, why, "")


def archive_disk(place: str, same_disk: bool | None) -> list[HealthItem]:
    """Whether the archive outlives the disk of the records.

    Args:
        same_disk: None where the archive is on no disk of this machine, or not known yet.
    """
    title, why = message("archive-disk"), message("archive-disk-why")
    if same_disk is None:
        return []
    if not same_disk:
        what = message("archive-on-own-disk", place=place)
        return [HealthItem("archive-disk", title, "good", what, why, "")]
    what, remedy = message("archive-on-same-disk", place=place), message("archive-name-other-disk")
    return [HealthItem("archive-disk", title, "attention", what, why, remedy)]
