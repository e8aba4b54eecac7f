# SPDX-License-Identifier: Apache-2.0
"""Fields that a run writes for ParaView, read back by examples/paraview, which shares no code with the writer, and by
ParaView's library."""

import subprocess
import sys
import unittest

import numpy

from program import QUICK, ROOT, SMALL, ProgramTest, signals
from tiers import long_test

EXAMPLE = ROOT / "examples" / "paraview"
sys.path.insert(0, str(EXAMPLE))
from vtu import read_collection, read_vtu  # noqa: E402


def areas(grid):
    """Areas of quadrilaterals along x and y [m2]."""
    corners = grid["Points"][grid["connectivity"]]
    return numpy.prod(corners[:, 2, :2] - corners[:, 0, :2], axis=1)


class ParaView(ProgramTest):
    def expect_pressed(self, folder, time, files):
        """Skin, contact and slider carry the force that signals.csv tells."""
        table = signals(folder)
        force = numpy.interp(time, table["time"], table["normal_force"])
        layers, contact, slider = (read_vtu(files[name]) for name in ("layers", "contact", "slider"))
        pressed = (contact["pressure"] * areas(contact)).sum()
        self.assertAlmostEqual(pressed / force, 1, delta=1e-3)
        top, middle = layers["Points"][:, 2].max(), layers["Points"][layers["connectivity"]].mean(axis=1)
        row = numpy.isclose(middle[:, 2], middle[:, 2].max())
        lower = layers["Points"][layers["connectivity"]][row]
        size = numpy.prod(lower[:, 2, :2] - lower[:, 0, :2], axis=1)
        self.assertAlmostEqual(-(layers["stress"][row, 2] * size).sum() / force, 1, delta=1e-2)
        self.assertEqual(set(layers["layer"]), {0, 1, 2})
        self.assertTrue((layers["displacement"][numpy.isclose(layers["Points"][:, 2], 0)] == 0).all())
        self.assertLess(slider["Points"][:, 2].min(), top)

    def test_one_collection_opens_core_layers_contact_and_slider(self):
        self.run_case(QUICK, *SMALL, "-o", "out")
        out = self.folder / "out"
        instants = read_collection(out / "fields" / "fields.pvd")
        self.assertEqual([time for time, _ in instants], [0.5, 1.5])
        for time, files in instants:
            self.assertEqual(set(files), {"core", "layers", "contact", "slider"})
            self.expect_pressed(out, time, files)
            core = read_vtu(files["core"])
            self.assertEqual(len(core["potential"]), len(core["Points"]))
        subprocess.run([sys.executable, EXAMPLE / "picture.py", out / "fields" / "fields.pvd", self.folder / "picture.png"],
                       check=True)
        self.assertGreater((self.folder / "picture.png").stat().st_size, 10_000)

    def test_the_mechanics_alone_is_there_and_stays_when_the_ions_follow(self):
        case = (QUICK, *SMALL, "--set", "output.fields=[3.9 s, 1.5 s]")
        self.run_case(*case, "-o", "out", "--only", "mechanics")
        out = self.folder / "out"
        (pressed, files), (lifted, rest) = read_collection(out / "fields" / "fields.pvd")
        self.assertEqual((pressed, lifted, set(files)), (1.5, 3.9, {"layers", "contact", "slider"}))
        self.expect_pressed(out, pressed, files)
        self.assertEqual(numpy.abs(read_vtu(rest["layers"])["stress"]).max(), 0)
        self.run_case(*case, "-o", "out", "--only", "electrochemistry", "--resume")
        for _, files in read_collection(out / "fields" / "fields.pvd"):
            self.assertEqual(set(files), {"core", "layers", "contact", "slider"})

    @long_test
    def test_the_library_of_paraview_reads_the_same(self):
        try:
            from vtkmodules.util.numpy_support import vtk_to_numpy
            from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
        except ImportError:
            self.skipTest("no VTK on this machine: apt-get install python3-vtk9 to read the files with it")
        self.run_case(QUICK, *SMALL, "-o", "out")
        for _, files in read_collection(self.folder / "out" / "fields" / "fields.pvd"):
            for block, path in files.items():
                with self.subTest(block):
                    reader, failures = vtkXMLUnstructuredGridReader(), []
                    self.assertTrue(reader.CanReadFile(str(path)))
                    for event in ("ErrorEvent", "WarningEvent"):
                        reader.AddObserver(event, lambda _, event: failures.append(event))
                    reader.SetFileName(str(path))
                    reader.Update()
                    grid, own = reader.GetOutput(), read_vtu(path)
                    self.assertEqual((failures, reader.GetErrorCode()), ([], 0))
                    numpy.testing.assert_array_equal(vtk_to_numpy(grid.GetPoints().GetData()), own["Points"])
                    numpy.testing.assert_array_equal(vtk_to_numpy(grid.GetCells().GetConnectivityArray()), own["connectivity"].ravel())
                    kinds = (grid.GetPointData(), grid.GetCellData(), grid.GetFieldData())
                    fields = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for data in kinds for i in range(data.GetNumberOfArrays())}
                    self.assertEqual(set(fields), set(own) - {"Points", "connectivity", "offsets", "types"})
                    for name, values in fields.items():
                        numpy.testing.assert_array_equal(values, own[name], name)


if __name__ == "__main__":
    unittest.main()
