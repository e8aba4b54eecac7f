# SPDX-License-Identifier: Apache-2.0
"""Loading of the compiled solver on first use, since its libraries take half a second to load."""

import contextlib
import importlib
import signal
from types import ModuleType


def load() -> ModuleType:
    """Loads and returns the compiled extension module `_ionskin_solver`. Raises ImportError, with the remedy, without it."""
    _own_interrupt()
    with contextlib.suppress(ModuleNotFoundError):
        importlib.import_module("ionskin_program")  # of a wheel: says where its units are
    try:
        return importlib.import_module("_ionskin_solver")
    except ModuleNotFoundError as missing:
        raise ImportError("the solver of ionskin is not beside this package: build it (make build), put build/python "
                          "on PYTHONPATH and use the Python it was built for, /usr/bin/python3") from missing


def _own_interrupt() -> None:
    """Restores Python's handler of SIGINT (Ctrl-C): OpenTURNS replaces it by one that ends the process."""
    handler = signal.getsignal(signal.SIGINT)
    if handler is not None:
        with contextlib.suppress(ValueError):  # only the main thread may
            signal.signal(signal.SIGINT, handler)
