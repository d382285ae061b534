"""Changes a profile camera between pictures and profiles.

A profile camera finds the laser line in each picture by itself, and sends its row in each column.
Its features have the names of SFNC: ``DeviceScanType`` is ``Areascan`` for pictures and
``Linescan3D`` for profiles. Of its output modes ``UncalibratedC`` alone is used: rows in pixels of
the sensor. All others are lengths by a calibration of the camera's own, and rectified.

Cameras with a ``RegionSelector`` have a region for the picture (``Region0``), one on the sensor for
the profile (``Scan3dExtractionSource``), and one for what is sent (``Scan3dExtraction1``), whose
height is the number of profiles in a buffer.

Source:
    EMVA, GenICam Standard Features Naming Convention (SFNC) 2.7, chapters Image Format Control and
    3D Scan Control; SICK, operating instructions of Ranger3, sections 7.4 (regions, scan type,
    ``RangeAxis``, which is no name of SFNC) and 7.13.
"""

from contextlib import suppress

from crenel.messages.message import Text, message
from crenel_hardware.errors import DeviceError
from crenel_hardware.sensor.genicam.features import FeatureCamera, FeatureError
from crenel_hardware.sensor.genicam.profiles.profile_points import COORDINATES, ProfileFormat
from crenel_hardware.sensor.genicam.settings import (
    CameraSettings,
    ProfileOptions,
    set_trigger,
)
from crenel_hardware.sensor.genicam.setup.picture_format import (
    select_components,
    select_intensity,
    set_region,
)
from crenel_hardware.sensor.genicam.setup.refusals import not_offered_error, refusals

SCAN_TYPE, PICTURES, PROFILES = "DeviceScanType", "Areascan", "Linescan3D"
REGION, PICTURE_REGION, EXTRACTION = "RegionSelector", "Region0", "Scan3dExtraction1"
OUTPUT_MODE, UNCALIBRATED = "Scan3dOutputMode", "UncalibratedC"
SCALE = "Scan3dCoordinateScale"
ROWS, BRIGHTNESS = ("Range", "Disparity"), ("Reflectance", "Intensity")
"""The components with the rows, and with the brightness of the line; of each, the first one that
the camera has is used."""


def offers_profiles(camera: FeatureCamera) -> bool:
    """Whether an open camera sends pictures and usable profiles; it is left to send pictures.

    Many of its features exist only while it sends profiles, so it is changed to them and back.
    Raises ``FeatureError`` if it does not change back.
    """
    if not {PICTURES, PROFILES} <= set(camera.choices(SCAN_TYPE)):
        return False
    try:
        camera.choose(SCAN_TYPE, PROFILES)
        _select_extraction(camera)
        if UNCALIBRATED not in camera.choices(OUTPUT_MODE):
            return False
        _set_output(camera)
        return _coordinates(camera) is not None and camera.has(SCALE)
    except FeatureError:
        return False
    finally:
        _show_pictures(camera)


def set_profiles(
    title: Text,
    camera: FeatureCamera,
    options: ProfileOptions,
    pictures: CameraSettings,
    exposure_us: float,
) -> ProfileFormat:
    """Has a camera that is stopped send profiles, one in each buffer.

    Args:
        title: the camera in words, for errors.
        pictures: the settings of the pictures; profiles are those of the same region.
        exposure_us: the present exposure.

    Raises:
        DeviceError: the camera does not do that; it may be half set.
    """
    with refusals(title):
        camera.choose(SCAN_TYPE, PROFILES)
        source = _select_source(camera)
        if source is not None:
            set_region(title, camera, list(pictures.region))
        _select_extraction(camera)
        _set_output(camera)
        pixel_format = _coordinates(camera)
        if pixel_format is None:
            raise not_offered_error(
                title,
                "PixelFormat",
                ", ".join(COORDINATES),
                ", ".join(camera.choices("PixelFormat")),
            )
        camera.choose("PixelFormat", pixel_format)
        _set_one_profile(title, camera, pictures.region[2])
        profile = _read_format(camera, options, pictures.region)
        if options.line_rate_hz is not None:
            _set_rate(camera, options.line_rate_hz)
        if source is not None:  # the exposure is that of the region on the sensor
            camera.choose(REGION, source)
        _set_exposure_and_trigger(title, camera, options, exposure_us)
    return profile


def set_pictures(
    title: Text,
    camera: FeatureCamera,
    options: ProfileOptions,
    pictures: CameraSettings,
    exposure_us: float,
) -> None:
    """Has a camera that is stopped send pictures again, as they were set before.

    Raises ``DeviceError``; the arguments are those of ``set_profiles``.
    """
    with refusals(title):
        _show_pictures(camera)
        select_intensity(camera)
        camera.choose("PixelFormat", pictures.pixel_format.name)
        set_region(title, camera, list(pictures.region))
        _set_exposure_and_trigger(title, camera, options, exposure_us)


def _choose_if_offered(camera: FeatureCamera, feature: str, value: str) -> None:
    if value in camera.choices(feature):
        camera.choose(feature, value)


def _show_pictures(camera: FeatureCamera) -> None:
    camera.send_parts(False)
    camera.choose(SCAN_TYPE, PICTURES)
    _choose_if_offered(camera, REGION, PICTURE_REGION)


def _select_source(camera: FeatureCamera) -> str | None:
    """Selects the region on the sensor for the profile; None of a camera with one region."""
    if EXTRACTION not in camera.choices(REGION):
        return None
    source = camera.choice("Scan3dExtractionSource")
    camera.choose(REGION, source)
    return source


def _select_extraction(camera: FeatureCamera) -> None:
    _choose_if_offered(camera, REGION, EXTRACTION)
    _choose_if_offered(camera, "Scan3dExtractionSelector", EXTRACTION)


def _set_output(camera: FeatureCamera) -> None:
    """Rows in pixels of the sensor, from the top down, and their brightness if it can come with
    them in one buffer."""
    camera.choose(OUTPUT_MODE, UNCALIBRATED)
    _choose_if_offered(camera, "Scan3dDistanceUnit", "Pixel")
    _choose_if_offered(camera, "RangeAxis", "Standard")
    offered = camera.choices("ComponentSelector")
    rows = [name for name in ROWS if name in offered][:1]
    if rows:
        beside = [name for name in BRIGHTNESS if name in offered][:1]
        wanted = [*rows, *beside] if beside and camera.send_parts(True) else rows
        select_components(camera, wanted)
        camera.choose("ComponentSelector", rows[0])


def _coordinates(camera: FeatureCamera) -> str | None:
    """The best pixel format of rows that the camera offers now."""
    offered = camera.choices("PixelFormat")
    return next((name for name in COORDINATES if name in offered), None)


def _set_one_profile(title: Text, camera: FeatureCamera, width_px: int) -> None:
    """Each profile needs a time of its own, so each buffer has one."""
    with suppress(FeatureError):
        camera.set_integer("Height", 1)
    # the region of what is sent may have no offsets
    width, height = camera.integer("Width"), camera.integer("Height")
    if height != 1:
        raise DeviceError(
            message("camera-sends-several-profiles", title=title, count=height),
            message("record-pictures-instead"),
        )
    if width != width_px:
        raise not_offered_error(title, "Width", str(width_px), str(width))


def _read_format(
    camera: FeatureCamera, options: ProfileOptions, region: tuple[int, int, int, int]
) -> ProfileFormat:
    _choose_if_offered(camera, "Scan3dCoordinateSelector", "CoordinateC")
    offset_px = options.line_offset_px
    if camera.has("Scan3dCoordinateOffset"):
        offset_px += camera.real("Scan3dCoordinateOffset")
    if options.line_rows == "sensor":
        offset_px -= region[1]
    marks = camera.has("Scan3dInvalidDataFlag") and camera.is_on("Scan3dInvalidDataFlag")
    invalid = camera.real("Scan3dInvalidDataValue") if marks else None
    return ProfileFormat(camera.real(SCALE), offset_px, invalid, region[2:], options.line_sigma_px)


def _set_rate(camera: FeatureCamera, rate_hz: float) -> None:
    if camera.has("AcquisitionLineRate"):
        camera.set_real("AcquisitionLineRate", rate_hz)
    else:
        camera.set_quantity("frame_rate", rate_hz)


def _set_exposure_and_trigger(
    title: Text, camera: FeatureCamera, options: ProfileOptions, exposure_us: float
) -> None:
    """As they were before: a change of the scan type may have set them back."""
    if camera.offers("exposure_time") and exposure_us:
        camera.set_quantity("exposure_time", exposure_us)
    if options.trigger is not None:
        set_trigger(title, camera, options.trigger, options.trigger_edge)
