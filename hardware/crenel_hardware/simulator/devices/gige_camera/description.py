"""The camera's description in GenICam XML, from which a client learns its features.

Source:
    EMVA, GenICam standard 2.1 (GenApi); schema version 1.1.
"""

from collections.abc import Iterable, Mapping
from itertools import groupby
from xml.sax.saxutils import quoteattr

from crenel_hardware.simulator.devices.gige_camera.feature import Feature

_HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<RegisterDescription ModelName="SimulatedGigeCamera" VendorName="Crenel"
 ToolTip="Simulated GigE camera" StandardNameSpace="GEV" SchemaMajorVersion="1"
 SchemaMinorVersion="1" SchemaSubMinorVersion="0" MajorVersion="1" MinorVersion="0"
 SubMinorVersion="0" ProductGuid="8f1f8a86-3f4e-4c2e-9f63-0c7e1d9a5b11"
 VersionGuid="2f0c2f43-6e5d-4b1f-9d0b-7b8b7c1b3a20"
 xmlns="http://www.genicam.org/GenApi/Version_1_1"
 xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
 xsi:schemaLocation="http://www.genicam.org/GenApi/Version_1_1 GenApiSchema_Version_1_1.xsd">
"""
_TAIL = '<Port Name="Device" NameSpace="Standard"></Port>\n</RegisterDescription>\n'
_TEXTS = {
    "DeviceVendorName": (0x0048, 32),
    "DeviceModelName": (0x0068, 32),
    "DeviceVersion": (0x0088, 32),
    "DeviceManufacturerInfo": (0x00A8, 48),
    "DeviceSerialNumber": (0x00D8, 16),
    "DeviceUserID": (0x00E8, 16),
}
"""Addresses and bytes of texts among the registers of the standard."""
_STANDARD = {
    "GevHeartbeatTimeout": (0x0938, 4, "RW"),
    "GevTimestampTickFrequency": (0x093C, 8, "RO"),
    "GevTimestampValue": (0x0948, 8, "RO"),
    "GevCCP": (0x0A00, 4, "RW"),
    "GevSCPHostPort": (0x0D00, 4, "RW"),
    "GevSCPD": (0x0D08, 4, "RW"),
    "GevSCDA": (0x0D18, 4, "RW"),
}
"""Addresses, bytes and access of numbers among the registers of the standard."""
_PACKET_SIZE_AT = 0x0D04
_ACCESS_NAMES = {True: "RW", False: "RO"}


def describe(features: Mapping[int, Feature]) -> str:
    """The description of a camera with these features by address."""
    kinds = {
        "integer": _integer,
        "float": _float,
        "enumeration": _enumeration,
        "boolean": _boolean,
        "command": _command,
    }
    bodies = [_group(features.values())]
    for at, feature in features.items():
        bodies.append(kinds[feature.kind](feature) + _register(at, feature))
    bodies += [_text(name, at, size) for name, (at, size) in _TEXTS.items()]
    bodies += [_number(name, at, size, access) for name, (at, size, access) in _STANDARD.items()]
    return _HEAD + "".join(bodies) + _packet_size() + _commands() + _TAIL


def _group(features: Iterable[Feature]) -> str:
    """The tree of categories."""
    named = {
        "DeviceControl": list(_TEXTS),
        "TransportLayerControl": [*_STANDARD, "GevSCPSPacketSize"],
    }
    for category, members in groupby(sorted(features, key=lambda one: one.category), _category):
        named.setdefault(category, []).extend(feature.name for feature in members)
    root = "".join(f"<pFeature>{name}</pFeature>" for name in sorted(named))
    groups = [f'<Category Name="Root" NameSpace="Standard">{root}</Category>\n']
    for category, names in named.items():
        listed = "".join(f"<pFeature>{name}</pFeature>" for name in names)
        groups.append(f'<Category Name="{category}" NameSpace="Standard">{listed}</Category>\n')
    return "".join(groups)


def _category(feature: Feature) -> str:
    return feature.category


def _node(kind: str, name: str, *parts: str) -> str:
    space = "Custom" if name.endswith(("Register", "Limit")) else "Standard"
    return f'<{kind} Name={quoteattr(name)} NameSpace="{space}">{"".join(parts)}</{kind}>\n'


def _lock(feature: Feature) -> str:
    return "<pIsLocked>TLParamsLocked</pIsLocked>" if feature.locked else ""


def _access(feature: Feature) -> str:
    return "" if feature.writable else "<ImposedAccessMode>RO</ImposedAccessMode>"


def _value(feature: Feature) -> str:
    """A selector has its value in the client alone."""
    return f"<pValue>{feature.name}Register</pValue>"


def _integer(feature: Feature) -> str:
    limits = f"<Min>{feature.least:g}</Min>"
    formula = ""
    if feature.limit:
        whole, part = feature.limit.split(" - ")
        limits += f"<pMax>{feature.name}Limit</pMax>"
        # registers: a feature would need its own limit, which needs this one
        formula = _node(
            "IntSwissKnife",
            f"{feature.name}Limit",
            f'<pVariable Name="A">{whole}Register</pVariable>',
            f'<pVariable Name="B">{part}Register</pVariable>',
            "<Formula>A - B</Formula>",
        )
    else:
        limits += f"<Max>{feature.most:.0f}</Max>"
    return formula + _node(
        "Integer",
        feature.name,
        _lock(feature),
        _access(feature),
        _value(feature),
        limits,
        f"<Inc>{feature.step}</Inc>",
        f"<Unit>{feature.unit}</Unit>" if feature.unit else "",
    )


def _float(feature: Feature) -> str:
    limits = f"<Min>{feature.least:g}</Min><Max>{feature.most:g}</Max>"
    unit = f"<Unit>{feature.unit}</Unit>" if feature.unit else ""
    return _node(
        "Float", feature.name, _lock(feature), _access(feature), _value(feature), limits, unit
    )


def _enumeration(feature: Feature) -> str:
    entries = "".join(
        f'<EnumEntry Name="{name}" NameSpace="Standard"><Value>{value}</Value></EnumEntry>'
        for name, value in feature.entries.items()
    )
    parts = _lock(feature), _access(feature), entries, _value(feature)
    return _node("Enumeration", feature.name, *parts)


def _boolean(feature: Feature) -> str:
    return _node("Boolean", feature.name, _lock(feature), _access(feature), _value(feature))


def _command(feature: Feature) -> str:
    return _node("Command", feature.name, _value(feature), "<CommandValue>1</CommandValue>")


def _register(at: int, feature: Feature) -> str:
    name, size = f"{feature.name}Register", 8 if feature.kind == "float" else 4
    index = ""
    if feature.selector:
        index = f'<pIndex Offset="{size}">{feature.selector}Register</pIndex>'
    place = f"<Address>0x{at:X}</Address>{index}<Length>{size}</Length>"
    access = f"<AccessMode>{_ACCESS_NAMES[feature.writable]}</AccessMode><pPort>Device</pPort>"
    cached = "<Cachable>NoCache</Cachable>"
    if feature.kind == "float":
        return _node("FloatReg", name, place, access, cached, "<Endianess>BigEndian</Endianess>")
    return _node("IntReg", name, place, access, cached, _BIG_ENDIAN)


_BIG_ENDIAN = "<Sign>Unsigned</Sign><Endianess>BigEndian</Endianess>"


def _text(name: str, at: int, size: int) -> str:
    access = "RW" if name == "DeviceUserID" else "RO"
    return _node(
        "StringReg",
        name,
        f"<Address>0x{at:X}</Address><Length>{size}</Length>",
        f"<AccessMode>{access}</AccessMode><pPort>Device</pPort>",
    )


def _number(name: str, at: int, size: int, access: str) -> str:
    return _node("Integer", name, f"<pValue>{name}Register</pValue>") + _node(
        "IntReg",
        f"{name}Register",
        f"<Address>0x{at:X}</Address><Length>{size}</Length>",
        f"<AccessMode>{access}</AccessMode><pPort>Device</pPort>",
        "<Cachable>NoCache</Cachable>",
        _BIG_ENDIAN,
    )


def _packet_size() -> str:
    """The lower half of its register; the upper half has switches."""
    return _node(
        "Integer",
        "GevSCPSPacketSize",
        "<pValue>PacketSizeRegister</pValue><Min>576</Min><Max>16000</Max><Inc>4</Inc>",
        "<Unit>B</Unit>",
    ) + _node(
        "MaskedIntReg",
        "PacketSizeRegister",
        f"<Address>0x{_PACKET_SIZE_AT:X}</Address><Length>4</Length>",
        "<AccessMode>RW</AccessMode><pPort>Device</pPort><Cachable>NoCache</Cachable>",
        f"<LSB>31</LSB><MSB>16</MSB>{_BIG_ENDIAN}",
    )


def _commands() -> str:
    """The latch of the camera's clock."""
    return _node(
        "Command",
        "GevTimestampControlLatch",
        "<pValue>TimestampControlRegister</pValue><CommandValue>2</CommandValue>",
    ) + _node(
        "IntReg",
        "TimestampControlRegister",
        "<Address>0x944</Address><Length>4</Length>",
        "<AccessMode>WO</AccessMode><pPort>Device</pPort>",
        _BIG_ENDIAN,
    )
