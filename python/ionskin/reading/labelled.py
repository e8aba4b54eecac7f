# SPDX-License-Identifier: Apache-2.0
"""Results as labelled arrays, where xarray is installed."""


def xarray_module():
    """Imports and returns the module xarray. Raises ImportError, with the remedy, when it is missing."""
    try:
        import xarray
    except ImportError as missing:
        raise ImportError("labelled arrays need xarray, which is not installed: apt install python3-xarray; "
                          "without it, `signals` and the other tables give numpy arrays") from missing
    return xarray


def table_dataset(table):
    """Converts a Table to an xarray.Dataset over its time; each column has its SI unit as the attribute "units"."""
    arrays = {name: ("time", values, {"units": table.units[name]}) for name, values in table.columns.items()}
    time = {name: arrays.pop(name) for name in ("time", "cycle", "phase") if name in arrays}
    return xarray_module().Dataset(arrays, coords=time)


def sweep_dataset(sweep):
    """Converts the metrics of a Sweep to an xarray.Dataset over its points, with the swept values as coordinates."""
    coordinates = {key: ("point", sweep.values(key), {"units": unit}) for key, unit in sweep.keys.items()}
    metrics = {name: ("point", sweep.metric(name), {"units": unit}) for name, unit in sweep.units.items()}
    return xarray_module().Dataset(metrics, coords=coordinates)
