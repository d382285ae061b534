"""The features of a camera that also finds the laser line itself, and sends its rows.

The scan type chooses between pictures and profiles. The picture has a region on the sensor, and so
has the profile; a third region is what is sent of the profiles, and its height is their number in
a buffer. As real cameras of this kind do, it counts rows from the last one up at power-on, and puts
many profiles into a buffer.

Source:
    EMVA, GenICam Standard Features Naming Convention (SFNC) 2.7, chapters Image Format Control and
    3D Scan Control; SICK, operating instructions of Ranger3, sections 7.4 and 7.13, which this
    camera follows (``RangeAxis`` is no name of SFNC).
"""

from dataclasses import replace

from crenel_hardware.simulator.devices.gige_camera.feature import Feature
from crenel_hardware.simulator.devices.gige_camera.pixels import ROWS_CODE

PICTURES, PROFILES = 0, 1
"""Values of ``DeviceScanType``."""
PICTURE, SOURCE, EXTRACTION = 0, 1, 2
"""Values of ``RegionSelector``."""
REFLECTANCE = 2
"""A value of ``ComponentSelector``."""
UNCALIBRATED, CALIBRATED = 0, 1
"""Values of ``Scan3dOutputMode``."""
STANDARD, REVERSED = 0, 1
"""Values of ``RangeAxis``."""
SCALE_PX, OFFSET_PX = 1 / 16, -2.0
"""Row in the profile's region = number * scale + offset."""
INVALID = 0
"""The number of a column without a line."""
PROFILES_AT_POWER_ON = 64
MOST_LINES_HZ = 1000.0
_SIZES = ("Width", "Height", "OffsetX", "OffsetY")


def profile_features(ordered: list[Feature], fewest_profiles: int) -> list[Feature]:
    """The features of a camera with pictures alone, and those of profiles among them."""
    with_regions = []
    for feature in ordered:
        if feature.name in _SIZES:
            with_regions.append(_by_region(feature, fewest_profiles))
        elif feature.name == "PixelFormat":
            with_regions.append(
                replace(
                    feature,
                    entries={**feature.entries, "Coord3D_C16": ROWS_CODE},
                    selector="RegionSelector",
                    values=(feature.value, feature.value, ROWS_CODE),
                )
            )
        else:
            with_regions.append(feature)
    return [*with_regions, *_selectors(), *_scan_features()]


def _by_region(feature: Feature, fewest_profiles: int) -> Feature:
    values = [feature.value] * 3
    if feature.name == "Height":
        values[EXTRACTION] = max(PROFILES_AT_POWER_ON, fewest_profiles)
        feature = replace(feature, least=fewest_profiles, step=1)
    return replace(feature, selector="RegionSelector", values=tuple(values))


def _choice(
    name: str, category: str, entries: dict[str, int], value: int = 0, locked: bool = True
) -> Feature:
    return Feature(name, "enumeration", category, value, entries=entries, locked=locked)


def _selectors() -> list[Feature]:
    group = "ImageFormatControl"
    components = {"Intensity": 0, "Range": 1, "Reflectance": REFLECTANCE}
    regions = {"Region0": PICTURE, "Region1": SOURCE, "Scan3dExtraction1": EXTRACTION}
    return [
        _choice("DeviceScanType", "DeviceControl", {"Areascan": PICTURES, "Linescan3D": PROFILES}),
        _choice("RegionSelector", group, regions, locked=False),
        _choice("ComponentSelector", group, components, locked=False),
        Feature(
            "ComponentEnable",
            "boolean",
            group,
            selector="ComponentSelector",
            values=(1, 1, 0),
            locked=True,
        ),
        Feature("AcquisitionLineRate", "float", "AcquisitionControl", 50.0, 0.1, MOST_LINES_HZ),
    ]


def _scan_features() -> list[Feature]:
    group = "Scan3dControl"
    modes = {"UncalibratedC": UNCALIBRATED, "CalibratedC": CALIBRATED}
    coordinates = {"CoordinateA": 0, "CoordinateB": 1, "CoordinateC": 2}
    by_coordinate = "Scan3dCoordinateSelector"
    least, most = -1e6, 1e6
    return [
        replace(
            _choice("Scan3dExtractionSource", group, {"Region1": SOURCE}, SOURCE), writable=False
        ),
        _choice("Scan3dOutputMode", group, modes, CALIBRATED),
        _choice("Scan3dDistanceUnit", group, {"Millimeter": 0, "Pixel": 1}),
        _choice("RangeAxis", group, {"Standard": STANDARD, "Reversed": REVERSED}, REVERSED),
        _choice(by_coordinate, group, coordinates, locked=False),
        *(
            Feature(
                name,
                "float",
                group,
                least=least,
                most=most,
                writable=False,
                selector=by_coordinate,
                values=values,
            )
            for name, values in (
                ("Scan3dCoordinateScale", (1.0, 1.0, SCALE_PX)),
                ("Scan3dCoordinateOffset", (0.0, 0.0, OFFSET_PX)),
                ("Scan3dInvalidDataValue", (0.0, 0.0, float(INVALID))),
            )
        ),
        Feature(
            "Scan3dInvalidDataFlag",
            "boolean",
            group,
            writable=False,
            selector=by_coordinate,
            values=(0, 0, 1),
        ),
    ]
