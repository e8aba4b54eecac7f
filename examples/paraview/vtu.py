# SPDX-License-Identifier: Apache-2.0
"""Reads what ionskin writes for ParaView with NumPy alone."""

import pathlib
import re
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np

TYPES = {"Float32": "<f4", "Float64": "<f8", "Int64": "<i8", "UInt8": "u1"}


def _values(data, offset, kind):
    """One compressed array of the appended part: number and size of blocks, size of the last, sizes as stored."""
    blocks = int(np.frombuffer(data, "<u8", 1, offset)[0])
    sizes = np.frombuffer(data, "<u8", blocks, offset + 24)
    begin = offset + 24 + 8 * blocks
    parts = []
    for size in sizes:
        parts.append(zlib.decompress(data[begin:begin + int(size)]))
        begin += int(size)
    return np.frombuffer(b"".join(parts), TYPES[kind])


def read_vtu(path):
    """A dictionary of arrays: `Points` [point, 3], `connectivity` [cell, corner], and the fields, [place] or [place, component]."""
    text = pathlib.Path(path).read_bytes()
    head, data = re.split(rb'<AppendedData encoding="raw">\n_', text, maxsplit=1)
    root = ElementTree.fromstring(head + b"</VTKFile>")
    arrays = {}
    for entry in root.iter("DataArray"):
        values = _values(data, int(entry.get("offset")), entry.get("type"))
        components = int(entry.get("NumberOfComponents", "1"))
        arrays[entry.get("Name")] = values.reshape(-1, components) if components > 1 else values
    cells = int(root.find(".//Piece").get("NumberOfCells"))
    arrays["connectivity"] = arrays["connectivity"].reshape(cells, -1)
    return arrays


def read_collection(path):
    """Contents of a .pvd file: pairs of instant [s] and a dictionary of files by their names: core, layers, contact,
    slider."""
    path = pathlib.Path(path)
    instants = {}
    for entry in ElementTree.parse(path).getroot().iter("DataSet"):
        instants.setdefault(float(entry.get("timestep")), {})[entry.get("name")] = path.parent / entry.get("file")
    return sorted(instants.items())
