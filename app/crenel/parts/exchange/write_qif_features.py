"""Features of an inspection in QIF 3.0: as drawn, and as measured, in the part frame.

Tori, slots and constructed features are left out: QIF describes them otherwise than a program
does. Their dimensions are characteristics all the same.
"""

from collections.abc import Iterator, Sequence
from math import sqrt
from xml.etree import ElementTree as ET

from crenel.formats.exchange.qif import qif_name
from crenel.formats.xml_text import add
from crenel.parts.document_results import FeatureResult, Parameters

NAMES = {
    "plane": "PlaneFeature",
    "circle": "CircleFeature",
    "cylinder": "CylinderFeature",
    "cone": "ConeFeature",
    "sphere": "SphereFeature",
}
SIZED = ("circle", "cylinder", "sphere")


def add_features(
    root: ET.Element, features: Sequence[FeatureResult], ids: Iterator[int]
) -> dict[str, int]:
    """Definition, nominal and item of each feature; the items' ids by the features' ids."""
    drawn: dict[str, FeatureResult] = {}
    for one in features:
        if one.kind in NAMES and one.nominal is not None:
            drawn.setdefault(one.id, one)
    if not drawn:
        return {}
    parent, number = add(root, qif_name("Features")), str(len(drawn))
    definitions, nominals, items = (
        add(parent, qif_name(f"Feature{name}"), n=number)
        for name in ("Definitions", "Nominals", "Items")
    )
    found = {}
    for name, one in drawn.items():
        assert one.nominal is not None
        kind, (definition, nominal, item) = NAMES[one.kind], (next(ids) for _ in range(3))
        element = add(definitions, qif_name(f"{kind}Definition"), id=str(definition))
        _define(element, one, one.nominal)
        element = add(nominals, qif_name(f"{kind}Nominal"), id=str(nominal))
        add(element, qif_name("Name"), name)
        add(element, qif_name("FeatureDefinitionId"), str(definition))
        _place(element, one.kind, one.nominal)
        element = add(items, qif_name(f"{kind}Item"), id=str(item))
        add(element, qif_name("FeatureNominalId"), str(nominal))
        add(element, qif_name("FeatureName"), name)
        add(add(element, qif_name("DeterminationMode")), qif_name("Checked"))
        found[name] = item
    return found


def add_feature_measurements(
    results: ET.Element,
    features: Sequence[FeatureResult],
    items: dict[str, int],
    ids: Iterator[int],
) -> None:
    """Each feature as each of the means found it; by tip its name has ``(touch)``."""
    measured = [one for one in features if one.id in items]
    if not measured:
        return
    parent = add(results, qif_name("MeasuredFeatures"), n=str(len(measured)))
    for one in measured:
        element = add(parent, qif_name(f"{NAMES[one.kind]}Measurement"), id=str(next(ids)))
        add(element, qif_name("FeatureItemId"), str(items[one.id]))
        add(element, qif_name("FeatureName"), f"{one.id} ({one.source})")
        _place(element, one.kind, one.parameters)
        if one.kind in SIZED:
            diameter = add(element, qif_name("Diameter"), _length(one.parameters["diameter_mm"]))
            u_mm = _diameter_uncertainty_mm(one)
            if u_mm is not None:
                diameter.set("combinedUncertainty", _length(u_mm))
                diameter.set("meanError", "0")
        elif one.kind == "cone":
            add(element, qif_name("Diameter"), "0")
            add(element, qif_name("HalfAngle"), _angle(one.parameters["half_angle_deg"]))


def _define(element: ET.Element, one: FeatureResult, nominal: Parameters) -> None:
    """What features of one kind and size have in common; of planes nothing."""
    if one.kind == "plane":
        return
    add(element, qif_name("InternalExternal"), "INTERNAL" if one.internal else "EXTERNAL")
    if one.kind == "cone":  # its locating point is the apex
        add(element, qif_name("Diameter"), "0")
        add(element, qif_name("HalfAngle"), _angle(nominal["half_angle_deg"]))
    else:
        add(element, qif_name("Diameter"), _length(nominal["diameter_mm"]))


def _place(element: ET.Element, kind: str, given: Parameters) -> None:
    point = _vector(given["point_mm"], 6)
    if kind in ("cylinder", "cone"):
        axis = add(element, qif_name("Axis"))
        add(axis, qif_name("AxisPoint"), point)
        add(axis, qif_name("Direction"), _vector(given["direction"], 9))
        return
    add(element, qif_name("Location"), point)
    if kind != "sphere":
        add(element, qif_name("Normal"), _vector(given["normal"], 9))


def _diameter_uncertainty_mm(one: FeatureResult) -> float | None:
    """Standard, k = 1; None where only the scatter is known."""
    if one.covariance is None:
        return None
    place = one.free.index("radius_mm")
    return 2 * sqrt(max(one.covariance[place][place], 0.0))


def _vector(value: object, decimals: int) -> str:
    assert isinstance(value, tuple)
    # adding 0 makes -0 a 0
    return " ".join(f"{round(number, decimals) + 0.0:.{decimals}f}" for number in value)


def _length(value: object) -> str:
    assert isinstance(value, float | int)
    return f"{value:.6f}"


def _angle(value: object) -> str:
    assert isinstance(value, float | int)
    return f"{value:.7f}"
