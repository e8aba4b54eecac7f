# SPDX-License-Identifier: Apache-2.0
"""An installed copy works by itself, wherever it is moved: program, Python package, library, manual, completion."""

import gzip
import json
import os
import re
import subprocess
import unittest
import zipfile

from program import PROGRAM, QUICK, ROOT, ProgramTest, summary
from tiers import long_test

BUILD = PROGRAM.parent
PYTHON = "/usr/bin/python3"
SMALL = ("--set", "numerics.mesh_refinement=0.3", "--set", "numerics.time_refinement=0.3", "--threads", "1")


class Install(ProgramTest):
    def setUp(self):
        super().setUp()
        # As a package is made: put below a folder, and moved from there.
        self.command("cmake", "--install", BUILD, "--prefix", "/usr", environment={"DESTDIR": str(self.folder / "staged")})
        self.prefix = self.folder / "moved"
        (self.folder / "staged" / "usr").rename(self.prefix)
        self.home = self.folder / "home"
        self.home.mkdir()

    def command(self, *words, environment=(), expect=0):
        """Runs a command with none of this environment but the path; asserts the exit code."""
        process = subprocess.run(
            [*map(str, words)], cwd=self.folder, capture_output=True, text=True, check=False,
            env={"PATH": os.environ["PATH"], "HOME": str(self.folder / "home"), **dict(environment)})
        self.assertEqual(process.returncode, expect, f"{words}\n{process.stdout}\n{process.stderr}")
        return process.stdout

    def test_installed_copy(self):
        self.program()
        self.python()
        self.shell_files()
        # No file names the tree it was made in, but for the fallback of programs that stand elsewhere.
        for file in (*self.prefix.rglob("*.cmake"), *self.prefix.rglob("*.py")):
            self.assertNotIn(str(ROOT), file.read_text(), file)

    @long_test
    def test_programs_that_link_to_it(self):
        """Most of its time goes into compiling them."""
        self.command(self.prefix / "bin" / "ionskin", "init", "case.toml", "--from", "quick")
        self.library()
        self.live()

    def program(self):
        program = self.prefix / "bin" / "ionskin"
        doctor = self.command(program, "doctor")
        for part in ("libexec/ionskin/ionskin-solver", "share/ionskin", "lib/python3/dist-packages"):
            self.assertIn(str(self.prefix / part), doctor)
        self.assertNotIn(str(ROOT), doctor)
        self.assertIn("Nothing is missing", doctor)
        configuration = (BUILD / "CPackConfig.cmake").read_text()
        packaged = {kind: set(re.search(f'CPACK_DEBIAN_PACKAGE_{kind} "(.*)"', configuration)[1].split(", "))
                    for kind in ("DEPENDS", "RECOMMENDS", "SUGGESTS")}
        needed = re.findall(r"Python module (\w+)$", doctor, re.MULTILINE)
        optional = re.findall(r"Python module (\w+): for", doctor)
        self.assertIn("numpy", needed)
        self.assertIn("scipy", optional)
        self.assertLessEqual({f"python3-{module}" for module in needed}, packaged["DEPENDS"])
        self.assertLessEqual({f"python3-{module}" for module in optional}, packaged["RECOMMENDS"] | packaged["SUGGESTS"])
        self.command(program, "init", "case.toml", "--from", "quick")
        self.command(program, "run", "case.toml", "-o", "out", *SMALL)
        self.assertTrue((self.folder / "out" / "report.html").exists())
        self.assertIn("no differences", self.command(program, "compare", "out", "out"))

    def python(self):
        path = {"PYTHONPATH": str(self.prefix / "lib/python3/dist-packages"), "PYTHONDONTWRITEBYTECODE": "1"}
        code = ("import ionskin, json; case = ionskin.Case.from_file('case.toml');"
                "case['numerics.mesh_refinement'] = case['numerics.time_refinement'] = 0.3; result = ionskin.run(case, 'from_python', threads=1);"
                "print(json.dumps([ionskin.__file__, result.metrics['normal_force_slide'].value]))")
        place, force = json.loads(self.command(PYTHON, "-c", code, environment=path))
        self.assertTrue(place.startswith(str(self.prefix)), place)
        self.assertAlmostEqual(force / summary(self.folder / "out")["metrics"]["normal_force_slide"]["value"], 1, 9)

        code = ("import ionskin, ionskin.live\ntry: ionskin.live.Skin('none.live')\n"
                "except ionskin.CaseError as error: print(error)")
        self.assertIn("none.live", self.command(PYTHON, "-c", code, environment=path))  # the library was found

    def shell_files(self):
        page = gzip.decompress((self.prefix / "share/man/man1/ionskin.1.gz").read_bytes()).decode()
        self.assertTrue(page.startswith(".TH IONSKIN 1"), page[:80])
        completion = self.prefix / "share/bash-completion/completions/ionskin"
        self.assertIn("complete -F _ionskin ionskin", completion.read_text())
        self.command("bash", "-n", completion)

    def library(self):
        """The example that links to the library; and every header that is installed includes installed ones only."""
        source = self.folder / "embed"
        self.command("cp", "-r", self.prefix / "share/doc/ionskin/examples/embed", source)
        headers = sorted(file.relative_to(self.prefix / "include") for file in self.prefix.rglob("*.hpp"))
        (source / "headers.cpp").write_text("".join(f'#include "{header}"\n' for header in headers))
        with (source / "CMakeLists.txt").open("a") as file:
            file.write("target_sources(embed PRIVATE headers.cpp)\n")
        self.command("cmake", "-S", source, "-B", "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.command("cmake", "--build", "build")
        self.command("sed", "-i", 's/^preset = "coarse"/&\\nmesh_refinement = 0.3\\ntime_refinement = 0.3/', "case.toml")
        out = self.command("build/embed", "case.toml", "embedded")
        self.assertRegex(out, r"friction 0.1: tangential_force_slide = 0\.2 N\nfriction 0.3: .* = 0\.6 N\n")

    def live(self):
        """Controllers that link to the live skin alone, and an FMU with the installed library in it."""
        path = {"PYTHONPATH": str(self.prefix / "lib/python3/dist-packages"), "PYTHONDONTWRITEBYTECODE": "1"}
        self.command(self.prefix / "bin" / "ionskin", "live", "case.toml", "-o", "skin.live", "--fmu", "skin.fmu",
                     "--trajectories", "2", "--validation", "2", *SMALL, "--quiet")
        source = self.folder / "controller"
        self.command("cp", "-r", self.prefix / "share/doc/ionskin/examples/live", source)
        self.command("cmake", "-S", source, "-B", "live", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.command("cmake", "--build", "live")
        for controller in ("controller", "controller_c"):
            rows = [line.split(",") for line in self.command(f"live/{controller}", "skin.live").splitlines()]
            self.assertEqual(len(rows), 101)
            self.assertTrue(all(float(row[1]) > 0 and row[3] == "0" for row in rows), controller)
        needed = self.command("readelf", "-d", "live/controller")
        self.assertNotIn("libionskin.so", needed)
        code = ("import ionskin.live; skin = ionskin.live.Skin('skin.live'); r = skin.range; s = 0;\n"
                "for i in range(1001):\n"
                "  s = skin.step(1e-3 * i, (r.lowest[0] + (r.highest[0] - r.lowest[0]) * 1e-3 * i / 2, r.lowest[1]),"
                " force=r.force / 2)\n"
                "print(f'{s[\"normal_force\"]:g},{s[\"current_top\"]:g}')")
        by_python = self.command(PYTHON, "-c", code, environment=path)
        self.assertIn(by_python.strip(), self.command("live/controller", "skin.live").splitlines()[-1])
        with zipfile.ZipFile(self.folder / "skin.fmu") as archive:
            library = archive.read("binaries/linux64/ionskin_live.so")
        self.assertEqual(library, (self.prefix / "libexec/ionskin/ionskin_live_fmu.so").read_bytes())

    def test_missing_part(self):
        """Where `make demo` has built the solver alone, the verbs of other parts name the command that builds them."""
        for part, verb in (("ionskin-extras", ("verify",)), ("ionskin-extras", ("live", QUICK, "--output", "skin.live")),
                           ("ionskin-studio", ("studio", "--no-browser"))):
            (self.prefix / "libexec" / "ionskin" / part).unlink(missing_ok=True)
            process = subprocess.run([self.prefix / "bin" / "ionskin", *verb], cwd=self.folder, capture_output=True, text=True,
                                     check=False)
            self.assertEqual(process.returncode, 2, process.stderr)
            self.assertIn(f"libexec/ionskin/{part}", process.stderr)
            self.assertIn("make build", process.stderr)


if __name__ == "__main__":
    unittest.main()
