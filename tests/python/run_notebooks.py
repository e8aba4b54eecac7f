# SPDX-License-Identifier: Apache-2.0
"""Executes every notebook of the gallery: run_notebooks.py [NAME...]. Fails when a cell does, or when one holds outputs."""

import pathlib
import sys

import nbformat
from nbclient import NotebookClient

FOLDER = pathlib.Path(__file__).resolve().parent.parent.parent / "notebooks"


def main(names):
    paths = [path for path in sorted(FOLDER.glob("*.ipynb")) if not names or path.stem in names]
    if not paths:
        raise SystemExit("no notebook was found")
    for path in paths:
        notebook = nbformat.read(path, as_version=4)
        if any(cell.get("outputs") for cell in notebook.cells):
            raise SystemExit(f"{path.name} holds outputs: clear them")
        NotebookClient(notebook, timeout=None, kernel_name="python3", resources={"metadata": {"path": str(FOLDER)}}).execute()
        print(f"{path.name}: {sum(cell.cell_type == 'code' for cell in notebook.cells)} cells", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
