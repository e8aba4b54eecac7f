# SPDX-License-Identifier: Apache-2.0
"""Libraries that some commands need and others do without."""

import importlib

from ..errors import CaseError

PACKAGES = {"openturns": "python3-openturns", "scipy": "python3-scipy", "h5py": "python3-h5py"}


def need(module: str, purpose: str):
    """Imports and returns a module; `purpose` names the command that needs it. Raises
    CaseError, with the package to install, without it."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = PACKAGES[module.partition(".")[0]]
        raise CaseError(f"{purpose} needs the Python module {module}: {error}\n  = apt-get install {package}") from error
