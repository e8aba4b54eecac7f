# SPDX-License-Identifier: Apache-2.0
"""The C interface of live skins: ionskin_live.h."""

import ctypes
import functools
import pathlib

import numpy

_INTERFACE = 1
TOUCH_ROWS = 16  # IONSKIN_LIVE_TOUCH_ROWS
NUMBERS = ctypes.POINTER(ctypes.c_double)


class Batch(ctypes.Structure):
    """The struct ionskin_live_batch of the C interface: inputs and outputs of a step of many skins."""

    _fields_ = [("times", ctypes.c_void_p), ("positions", ctypes.c_void_p), ("values", ctypes.c_void_p),
                ("signals", ctypes.c_void_p), ("flags", ctypes.c_void_p), ("columns", ctypes.c_void_p),
                ("column_count", ctypes.c_size_t), ("kind", ctypes.c_int), ("single", ctypes.c_int)]


@functools.cache
def load() -> ctypes.CDLL:
    """The library beside the package. ImportError where there is none of this version."""
    here = pathlib.Path(__file__).parent
    beside = here.parents[1]
    for folder in (here, beside, beside.parents[1]):  # a wheel; the build folder; lib, above lib/python3/dist-packages
        for name in ("libionskin_live.so", "libionskin_live.so.1"):
            if (folder / name).exists():
                library = ctypes.CDLL(str(folder / name))
                if library.ionskin_live_interface() == _INTERFACE:
                    return _declared(library)
    raise ImportError("libionskin_live.so of this version is not beside this package: build it (make build) and put "
                      "build/python on PYTHONPATH, or install all parts of ionskin")


def _declared(library: ctypes.CDLL) -> ctypes.CDLL:
    skin, text, number, size = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double, ctypes.c_size_t
    texts = ctypes.POINTER(text)
    for name, result, arguments in (
            ("open", skin, [text, text, size]), ("copy", skin, [skin]), ("close", None, [skin]),
            ("signal_count", size, [skin]), ("signal_name", text, [skin, size]),
            ("step", ctypes.c_uint32, [skin, number, number, number, ctypes.c_int, number, NUMBERS]),
            ("run", None, [skin, size, NUMBERS, NUMBERS, ctypes.c_int, NUMBERS, NUMBERS,
                           ctypes.POINTER(ctypes.c_uint32)]),
            ("stiffness", ctypes.c_int, [skin, NUMBERS]), ("charge_count", size, [skin]),
            ("charge_derivatives", ctypes.c_int, [skin, NUMBERS]),
            ("step_posed", ctypes.c_uint32, [skin, number, number, number, NUMBERS, ctypes.c_int, number, NUMBERS]),
            ("run_posed", None, [skin, size, NUMBERS, NUMBERS, NUMBERS, ctypes.c_int, NUMBERS, NUMBERS,
                                 ctypes.POINTER(ctypes.c_uint32)]),
            ("step_held", ctypes.c_uint32, [skin, number, number, number, number, number, NUMBERS, NUMBERS]),
            ("angles", None, [skin, NUMBERS]), ("pose_range", None, [skin, NUMBERS]), ("state_size", size, [skin]), ("save", None, [skin, NUMBERS]),
            ("restore", ctypes.c_int, [skin, NUMBERS, size]), ("reset", None, [skin]),
            ("set_friction", ctypes.c_int, [skin, number]), ("friction", None, [skin, NUMBERS]),
            ("text", text, [skin, text]), ("range", None, [skin, NUMBERS]), ("size", None, [skin, NUMBERS]),
            ("footprint", None, [skin, NUMBERS]), ("core_thickness", number, [skin]),
            ("taxel", ctypes.c_int, [skin, size, texts, NUMBERS]),
            ("event_error", ctypes.c_int, [skin, size, texts, texts, NUMBERS, NUMBERS, NUMBERS]),
            ("random_touch", size, [skin, ctypes.c_uint64, NUMBERS, ctypes.POINTER(ctypes.c_int)]),
            ("skins_open", skin, [skin, size, size]), ("skins_close", None, [skin]),
            ("skins_step", None, [skin, size, size, size, ctypes.POINTER(Batch)]),
            ("skins_step_posed", None, [skin, size, size, size, ctypes.POINTER(Batch), ctypes.c_void_p, ctypes.c_void_p]),
            ("skins_reset", None, [skin, size]), ("skins_save", None, [skin, size, NUMBERS]),
            ("skins_restore", ctypes.c_int, [skin, size, NUMBERS, size]),
            ("skins_set_friction", ctypes.c_int, [skin, size, number]), ("skins_friction", number, [skin, size]),
            ("skins_set_noise", None, [skin, size, number, ctypes.c_uint64, ctypes.c_uint64]),
            ("skins_noise_steps", ctypes.c_uint64, [skin, size])):
        function = getattr(library, "ionskin_live_" + name)
        function.restype, function.argtypes = result, arguments
    return library


def pointer(array: numpy.ndarray):
    """Pointer to the numbers of an array of doubles."""
    return array.ctypes.data_as(NUMBERS)
