# SPDX-License-Identifier: Apache-2.0
"""The compiled solver, loaded when it is first needed: its libraries take half a second."""

import importlib
from types import ModuleType


def load() -> ModuleType:
    """The extension module. Raises ImportError with the remedy when it is not built."""
    try:
        return importlib.import_module("_ionskin_solver")
    except ModuleNotFoundError as missing:
        raise ImportError("the solver of ionskin is not beside this package: build it (make build), put build/python "
                          "on PYTHONPATH and use the Python it was built for, /usr/bin/python3") from missing
