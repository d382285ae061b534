"""The functions of Aravis that the driver calls, through ctypes.

Aravis is the C library ``libaravis`` (LGPL), a client for GigE Vision and USB3 Vision. It is a
package of the system, and is loaded when the first camera is opened or searched for.

Source:
    https://aravisproject.github.io/aravis, the reference of the classes ``ArvCamera``,
    ``ArvDevice``, ``ArvStream`` and ``ArvBuffer``; all functions but the optional ones have existed
    since 0.8.0.
"""

import ctypes
import ctypes.util
from ctypes import (
    POINTER,
    byref,
    c_char_p,
    c_double,
    c_int,
    c_int64,
    c_size_t,
    c_uint,
    c_uint32,
    c_uint64,
    c_void_p,
)
from functools import cache
from typing import Any

from crenel.messages.message import message
from crenel_hardware.errors import DeviceError
from crenel_hardware.sensor.genicam.features import FeatureError

_SONAMES = ("libaravis-0.8.so.0", "libaravis-0.10.so.0")
_LIBRARY_NAMES = ("aravis-0.8", "aravis-0.10")
PACKAGE = "libaravis-0.8-0"
"""The name of the system package in Debian and Ubuntu."""

_Doubles, _Integers = POINTER(c_double), POINTER(c_int64)
_FALLIBLE: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "arv_camera_new": (c_void_p, (c_char_p,)),
    "arv_camera_create_stream": (c_void_p, (c_void_p, c_void_p, c_void_p)),
    "arv_camera_start_acquisition": (None, (c_void_p,)),
    "arv_camera_stop_acquisition": (None, (c_void_p,)),
    "arv_camera_get_vendor_name": (c_char_p, (c_void_p,)),
    "arv_camera_get_model_name": (c_char_p, (c_void_p,)),
    "arv_camera_get_device_serial_number": (c_char_p, (c_void_p,)),
    "arv_camera_get_payload": (c_uint, (c_void_p,)),
    "arv_camera_get_sensor_size": (None, (c_void_p, POINTER(c_int), POINTER(c_int))),
    "arv_camera_get_region": (None, (c_void_p,) + 4 * (POINTER(c_int),)),
    "arv_camera_set_region": (None, (c_void_p, c_int, c_int, c_int, c_int)),
    "arv_camera_get_exposure_time": (c_double, (c_void_p,)),
    "arv_camera_set_exposure_time": (None, (c_void_p, c_double)),
    "arv_camera_get_exposure_time_bounds": (None, (c_void_p, _Doubles, _Doubles)),
    "arv_camera_is_exposure_time_available": (c_int, (c_void_p,)),
    "arv_camera_get_gain": (c_double, (c_void_p,)),
    "arv_camera_set_gain": (None, (c_void_p, c_double)),
    "arv_camera_get_gain_bounds": (None, (c_void_p, _Doubles, _Doubles)),
    "arv_camera_is_gain_available": (c_int, (c_void_p,)),
    "arv_camera_get_frame_rate": (c_double, (c_void_p,)),
    "arv_camera_set_frame_rate": (None, (c_void_p, c_double)),
    "arv_camera_get_frame_rate_bounds": (None, (c_void_p, _Doubles, _Doubles)),
    "arv_camera_is_frame_rate_available": (c_int, (c_void_p,)),
    "arv_camera_clear_triggers": (None, (c_void_p,)),
    "arv_camera_is_feature_available": (c_int, (c_void_p, c_char_p)),
    "arv_camera_dup_available_enumerations_as_strings": (
        c_void_p,
        (c_void_p, c_char_p, POINTER(c_uint)),
    ),
    "arv_camera_get_integer": (c_int64, (c_void_p, c_char_p)),
    "arv_camera_set_integer": (None, (c_void_p, c_char_p, c_int64)),
    "arv_camera_get_float": (c_double, (c_void_p, c_char_p)),
    "arv_camera_set_float": (None, (c_void_p, c_char_p, c_double)),
    "arv_camera_get_boolean": (c_int, (c_void_p, c_char_p)),
    "arv_camera_get_string": (c_char_p, (c_void_p, c_char_p)),
    "arv_camera_set_string": (None, (c_void_p, c_char_p, c_char_p)),
    "arv_camera_set_boolean": (None, (c_void_p, c_char_p, c_int)),
    "arv_camera_gv_set_packet_size": (None, (c_void_p, c_int)),
    "arv_device_read_memory": (c_int, (c_void_p, c_uint64, c_uint32, c_void_p)),
    "arv_device_read_register": (c_int, (c_void_p, c_uint64, POINTER(c_uint32))),
    "arv_device_write_register": (c_int, (c_void_p, c_uint64, c_uint32)),
    "arv_chunk_parser_get_float_value": (c_double, (c_void_p, c_void_p, c_char_p)),
    "arv_chunk_parser_get_integer_value": (c_int64, (c_void_p, c_void_p, c_char_p)),
}
"""Functions whose last argument receives an error: result and other arguments."""
_INFALLIBLE: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "arv_update_device_list": (None, ()),
    "arv_get_n_devices": (c_uint, ()),
    "arv_get_device_id": (c_char_p, (c_uint,)),
    "arv_get_device_address": (c_char_p, (c_uint,)),
    "arv_get_device_protocol": (c_char_p, (c_uint,)),
    "arv_get_device_vendor": (c_char_p, (c_uint,)),
    "arv_get_device_model": (c_char_p, (c_uint,)),
    "arv_get_device_serial_nbr": (c_char_p, (c_uint,)),
    "arv_enable_interface": (None, (c_char_p,)),
    "arv_disable_interface": (None, (c_char_p,)),
    "arv_camera_get_device": (c_void_p, (c_void_p,)),
    "arv_camera_is_gv_device": (c_int, (c_void_p,)),
    "arv_camera_create_chunk_parser": (c_void_p, (c_void_p,)),
    "arv_gv_device_is_controller": (c_int, (c_void_p,)),
    "arv_gv_device_set_packet_size_adjustment": (None, (c_void_p, c_int)),
    "arv_stream_push_buffer": (None, (c_void_p, c_void_p)),
    "arv_stream_timeout_pop_buffer": (c_void_p, (c_void_p, c_uint64)),
    "arv_buffer_new_allocate": (c_void_p, (c_size_t,)),
    "arv_buffer_get_status": (c_int, (c_void_p,)),
    "arv_buffer_has_chunks": (c_int, (c_void_p,)),
    "arv_buffer_get_frame_id": (c_uint64, (c_void_p,)),
    "arv_buffer_get_timestamp": (c_uint64, (c_void_p,)),
    "arv_buffer_get_system_timestamp": (c_uint64, (c_void_p,)),
    "arv_buffer_get_image_data": (c_void_p, (c_void_p, POINTER(c_size_t))),
    "arv_buffer_get_image_width": (c_int, (c_void_p,)),
    "arv_buffer_get_image_height": (c_int, (c_void_p,)),
    "arv_buffer_get_image_pixel_format": (c_uint32, (c_void_p,)),
    "arv_buffer_get_image_padding": (None, (c_void_p, POINTER(c_int), POINTER(c_int))),
    "g_object_unref": (None, (c_void_p,)),
    "g_free": (None, (c_void_p,)),
    "g_error_free": (None, (c_void_p,)),
}
"""Functions that cannot fail: result and arguments."""
_OPTIONAL: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "arv_stream_get_info_uint64_by_name": (c_uint64, (c_void_p, c_char_p)),
    "arv_buffer_get_n_parts": (c_uint, (c_void_p,)),
    "arv_buffer_get_part_data": (c_void_p, (c_void_p, c_uint, POINTER(c_size_t))),
    "arv_buffer_get_part_pixel_format": (c_uint32, (c_void_p, c_uint)),
    "arv_buffer_get_part_width": (c_int, (c_void_p, c_uint)),
    "arv_buffer_get_part_height": (c_int, (c_void_p, c_uint)),
    "arv_buffer_get_part_padding": (None, (c_void_p, c_uint, POINTER(c_int), POINTER(c_int))),
}
"""Functions of later versions that cannot fail; to be called only if ``Aravis.has`` them."""
_OPTIONAL_FALLIBLE: dict[str, tuple[Any, tuple[Any, ...]]] = {
    "arv_camera_gv_is_multipart_supported": (c_int, (c_void_p,)),
    "arv_camera_gv_set_multipart": (None, (c_void_p, c_int)),
}
"""Those that can."""


def _can_fail(name: str) -> bool:
    return name in _FALLIBLE or name in _OPTIONAL_FALLIBLE


class AravisError(FeatureError):
    """Aravis or the camera refused a call."""


class _GError(ctypes.Structure):
    """An error of GLib."""

    _fields_ = (("domain", c_uint32), ("code", c_int), ("message", c_char_p))


class Aravis:
    """The loaded library."""

    def __init__(self, library: ctypes.CDLL) -> None:
        self._functions: dict[str, Any] = {}
        required = _FALLIBLE | _INFALLIBLE
        for name, (result, arguments) in (required | _OPTIONAL | _OPTIONAL_FALLIBLE).items():
            if name not in required and not hasattr(library, name):
                continue
            function = getattr(library, name)
            function.restype = result
            extra = (POINTER(POINTER(_GError)),) if _can_fail(name) else ()
            function.argtypes = (*arguments, *extra)
            self._functions[name] = function

    def has(self, name: str) -> bool:
        """Whether this version has the function."""
        return name in self._functions

    def call(self, name: str, *arguments: Any) -> Any:
        """Calls a function by its name; texts go in and out as bytes.

        Raises:
            AravisError: the function reported an error.
        """
        if not _can_fail(name):
            return self._functions[name](*arguments)
        error = POINTER(_GError)()
        result = self._functions[name](*arguments, byref(error))
        if error:
            text = (error.contents.message or b"").decode("utf-8", "replace")
            self._functions["g_error_free"](error)
            raise AravisError(text)
        return result

    def entries(self, camera: int, feature: str) -> list[str]:
        """The values that an enumeration of the camera offers now."""
        count = c_uint()
        found = self.call(
            "arv_camera_dup_available_enumerations_as_strings",
            camera,
            feature.encode(),
            byref(count),
        )
        if not found:
            return []
        names = ctypes.cast(found, POINTER(c_char_p))
        entries = [(names[i] or b"").decode("utf-8", "replace") for i in range(count.value)]
        self.call("g_free", found)
        return entries


@cache
def load_aravis() -> Aravis:
    """The library, loaded once.

    Raises:
        DeviceError: the system does not have it; says which package to install.
    """
    found = (ctypes.util.find_library(name) for name in _LIBRARY_NAMES)
    for name in (*_SONAMES, *(name for name in found if name)):
        try:
            return Aravis(ctypes.CDLL(name))
        except (OSError, AttributeError):
            continue
    raise DeviceError(message("aravis-missing"), message("install-system-package", package=PACKAGE))
