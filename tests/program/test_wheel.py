# SPDX-License-Identifier: Apache-2.0
"""The wheel: what is in it works from where it is unpacked."""

import base64
import csv
import hashlib
import io
import os
import re
import subprocess
import unittest
import zipfile

from program import PROGRAM, QUICK, ROOT, ProgramTest


class WheelTest(ProgramTest):
    def python(self, *arguments, **settings):
        return subprocess.run(["/usr/bin/python3", *map(str, arguments)], capture_output=True, text=True, check=False,
                              env={"PATH": "/usr/bin:/bin", "PYTHONPATH": str(self.folder / "site")}, cwd=self.folder, **settings)

    def test_live_skins_and_the_program_work_from_it(self):
        made = subprocess.run([ROOT / "scripts" / "make_wheel.py", PROGRAM.parent, "0.3.0"], capture_output=True, text=True,
                              check=False)
        self.assertEqual(made.returncode, 0, made.stderr)
        wheel = made.stdout.strip()
        self.assertRegex(wheel, r"/ionskin-0\.3\.0-py3-none-manylinux_2_\d+_\w+\.whl$")
        with zipfile.ZipFile(wheel) as archive:
            rows = list(csv.reader(io.StringIO(archive.read("ionskin-0.3.0.dist-info/RECORD").decode())))
            self.assertEqual({row[0] for row in rows}, set(archive.namelist()))
            for name, digest, _ in rows[:-1]:
                expected = base64.urlsafe_b64encode(hashlib.sha256(archive.read(name)).digest()).rstrip(b"=").decode()
                self.assertEqual(digest, f"sha256={expected}", name)
            for item in archive.infolist():  # as pip does
                os.chmod(archive.extract(item, self.folder / "site"), item.external_attr >> 16 & 0o777)
        told = self.python("-c", "import sys, ionskin.live.library as own; own.load(); print(own.__file__); "
                           "print(sorted({name.split('.')[0] for name in sys.modules} & {'numpy', 'h5py', 'matplotlib', 'jinja2'}))")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertIn(str(self.folder), told.stdout)
        self.assertIn("['numpy']", told.stdout)
        live = self.folder / "site" / "ionskin" / "live"
        subprocess.run(["cc", ROOT / "examples" / "live" / "controller.c", "-I", live, "-L", live, "-l:libionskin_live.so.1",
                        f"-Wl,-rpath,{live}", "-o", self.folder / "controller"], check=True)
        program = self.folder / "site" / "ionskin_program"
        for file in (program / "bin" / "ionskin", program / "libexec" / "ionskin" / "ionskin-solver"):
            loaded = subprocess.run(["ldd", file], capture_output=True, text=True, check=True).stdout
            for name in ("libhdf5_serial", "libudunits2", "libfmt"):
                for place in re.findall(rf"{name}\S* => (\S+)", loaded):
                    self.assertTrue(os.path.realpath(place).startswith(str(program / "lib")), place)
        ran = self.python("-c", "import ionskin_program as own; own.main()", "run", QUICK, "--set", "numerics.mesh_refinement=0.3",
                          "--set", "numerics.error_estimate=off", "-o", "out", "--quiet")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertTrue((self.folder / "out" / "report.html").exists())


if __name__ == "__main__":
    unittest.main()
