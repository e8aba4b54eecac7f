# SPDX-License-Identifier: Apache-2.0
"""Inputs made to break the program are answered: exit code 2, soon, with a short message that no terminal acts on."""

import os
import signal
import subprocess
import unittest

from program import QUICK, ProgramTest

# A skin, slider and waypoints in the middle of what is allowed, whose height map touches next to nothing.
RIDGE = "mm, -1.5, 0, 1.5\n-0.75, 0.1, 0, 0.1\n0, 0.05, 0, 0.05\n0.75, 0.1, 0, 0.1\n"
BUMPS = "mm,-1.5,0,1.5\n-0.75,0.006,0.001,0.006\n-0.375,0.008,0.0001,0.002\n0,0.007,0.005,0.005\n0.75,0.004,0.005,0.001\n"


class HostileInput(ProgramTest):
    def answer(self, *arguments, expect=2, within=20, **settings):
        """Runs the program within so many seconds of a processor; its answer is short and harmless."""
        process = self.run_program(*arguments, expect=expect, processor_seconds=within, text=False, stdin=subprocess.DEVNULL,
                                   **settings)
        self.assertLess(len(process.stderr), 20000)
        for byte in process.stderr + process.stdout:
            self.assertTrue(byte >= 32 or byte in b"\n\t", f"control byte {byte}")
        self.assertNotIn(b"internal error", process.stderr)
        return process.stderr.decode(errors="replace") + process.stdout.decode(errors="replace")

    def profile_case(self, heights, height):
        """The quick case with a height map that lands and slides at one height."""
        text = QUICK.read_text()
        self.write("profile.csv", heights)
        begin, end = text.index("[slider]"), text.index("[contact]")
        slider = '[slider]\nshape = "profile"\nsize = ["3 mm", "1.5 mm"]\nprofile = "profile.csv"\n'
        motion = '[motion]\nkind = "waypoints"\n'
        for instant, x, z in ((0, 5, "0.5 mm"), (0.5, 5, height), (1.5, 8, height), (2, 8, "0.5 mm")):
            motion += (f'[[motion.waypoints]]\ntime = "{instant} s"\nposition = ["{x} mm", "1 mm"]\n'
                       f'height = "{z}"\n')
        return self.write("profile.toml", text[:begin] + slider + motion + text[end:])

    def test_case_files(self):
        deep = self.write("deep.toml", "x = " + "[" * 20000)
        self.assertIn("brackets", self.answer("check", deep))
        self.assertIn("folder", self.answer("check", self.folder))
        self.assertIn("device", self.answer("check", "/dev/zero"))
        self.assertIn("device", self.answer("check", "/dev/stdin"))
        fifo = self.folder / "fifo"
        os.mkfifo(fifo)
        self.assertIn("pipe", self.answer("check", fifo))
        (self.folder / "latin.toml").write_bytes(QUICK.read_bytes() + b"# \xe4\xff\n")
        self.assertIn("UTF-8", self.answer("check", "latin.toml"))

    def test_command_line(self):
        self.answer("check", QUICK, "--set", "coupling.law=\x1b[31mred")
        self.answer("check", QUICK, "--set", "coupling.law=" + "x" * 30000)
        self.answer("check", "\x1b[2J\nnothing.toml")
        self.answer("sweep", QUICK, "-o", "out", "--over", "contact.friction=\x1b[31m:1:" + "9" * 5000)
        self.answer("\x1b[31mrun")

    def test_files_of_a_case(self):
        for name in ("/dev/zero", "."):
            self.answer("check", QUICK, "--set", "motion.kind=waypoints", "--set", f"motion.file={name}")

    def test_lists_as_long_as_they_may_be_take_no_time(self):
        """Each takes a third of a second at most, and 20 s and more where the time goes with the square."""
        case = QUICK.read_text()
        instants = ", ".join(f'"{4 * i / 10001:.5f} s"' for i in range(1, 10001))
        self.write("instants.toml", f"{case.split('[output]')[0]}[output]\nfields = [{instants}]\n")
        self.write("unknown.toml", case + "".join(f"key_{i} = 1\n" for i in range(12000)))
        places = (5000 - abs(i % 10000 - 5000) for i in range(50000))
        self.write("way.csv", "time [s],x [mm],y [mm],height [mm]\n" + "".join(
            f"{i / 1000},{4.5 + place / 1000},1,{1 if i in (0, 49999) else -0.001}\n" for i, place in enumerate(places)))
        after = f"[contact]{case.split('[contact]')[1].split('[output]')[0]}"
        self.write("way.toml", f'{case.split("start = [")[0]}[motion]\nkind = "waypoints"\nfile = "way.csv"\n{after}')
        for name, expect in (("instants", 0), ("way", 0), ("unknown", 2)):
            self.run_program("check", f"{name}.toml", expect=expect, processor_seconds=5)

    def test_readings_before_any_work(self):
        message = self.answer("run", QUICK, "-o", "out", "--set", "readout.sample_interval=1 ns")
        self.assertIn("readings", message)
        self.assertFalse((self.folder / "out").exists())

    def test_files_of_gigabytes_before_any_work(self):
        fields = ", ".join(f'"{0.6 + 1e-4 * i:.4f} s"' for i in range(2500))
        case = self.write("fields.toml", QUICK.read_text().replace('fields = ["0.5 s", "1.5 s"]', f"fields = [{fields}]"))
        answered = " ".join(self.answer("check", case, expect=0).split())
        self.assertRegex(answered, r"take about 1\.\d GB: the run lasts 4 s, .* instants in output.fields: 2500")
        errors = self.end_at_file(1, "run", case, "-o", "out", below="out", how=signal.SIGINT, expect=130)
        self.assertRegex(" ".join(errors.split()), r"take about 1\.\d GB")

    def test_memory_before_any_work(self):
        environment = {**os.environ, "IONSKIN_MEMORY_LIMIT": "100 MB"}
        message = self.answer("run", QUICK, "-o", "out", env=environment)
        self.assertIn("0.1 GB are allowed by IONSKIN_MEMORY_LIMIT", message)
        self.assertFalse((self.folder / "out").exists())
        films = [option for layer in range(3) for option in ("--set", f"skin.layers[{layer}].thickness=200 nm")]
        message = self.answer("run", QUICK, "-o", "out", "--set", "motion.preload=1 nm", *films)
        self.assertRegex(message, "memory|unknowns|elements")

    def test_files_that_find_no_room_before_any_work(self):
        """The disk's own free room, and a limit in its place, refuse runs before any work: run, sweep, plan and
        batch."""
        fields = ", ".join(f'"{0.6 + 1e-4 * i:.4f} s"' for i in range(2500))
        case = self.write("fields.toml", QUICK.read_text().replace('fields = ["0.5 s", "1.5 s"]', f"fields = [{fields}]"))
        for limit, room in (("1 GB", "1.0 GB are allowed by IONSKIN_DISK_LIMIT"), ("1 kB", "0.0 MB are allowed")):
            message = self.answer("run", case, "-o", "out", env={**os.environ, "IONSKIN_DISK_LIMIT": limit})
            self.assertIn(room, message)
            self.assertIn("fewer instants in output.fields", message)
            self.assertFalse((self.folder / "out").exists())
        sweep = (QUICK, "--over", "contact.friction=0.1,0.2", "-o", "out", "--no-report")
        small = {**os.environ, "IONSKIN_DISK_LIMIT": "1 kB"}
        for more in ((), ("--plan",)):
            self.assertIn("IONSKIN_DISK_LIMIT", self.answer("sweep", *sweep, *more, env=small))
            self.assertFalse((self.folder / "out").exists())
        self.run_program("sweep", *sweep, "--plan")
        self.assertIn("IONSKIN_DISK_LIMIT", self.answer("sweep", "--do-batch", 0, "-o", "out", env=small))
        self.assertFalse((self.folder / "out" / "points").exists())
        self.assertIn("is not a size", self.answer("run", QUICK, "-o", "no", env={**os.environ, "IONSKIN_DISK_LIMIT": "some"}))

    def test_slider_that_touches_no_cell(self):
        case = self.profile_case(BUMPS, "-0.2 nm")
        self.assertIn("touches no cell", self.answer("check", case))
        self.assertIn("touches no cell", self.answer("run", case, "-o", "out"))

    def test_round_slider_that_never_touches(self):
        text = QUICK.read_text()
        begin, end = text.index("[slider]"), text.index("[contact]")
        for height in ("50 um", "0 um"):
            motion = '[motion]\nkind = "waypoints"\n' + "".join(
                f'[[motion.waypoints]]\ntime = "{instant} s"\nposition = ["5 mm", "1 mm"]\nheight = "{z}"\n'
                for instant, z in ((0, "100 um"), (1, height), (2, "100 um")))
            case = self.write("sphere.toml", text[:begin] + '[slider]\nshape = "sphere"\nradius = "4 mm"\n' + motion + text[end:])
            for soft in ((), ("--set", "slider.youngs_modulus=1 MPa", "--set", "slider.poissons_ratio=0.4")):
                self.assertIn("never touches the skin", self.answer("check", case, *soft))
                self.assertIn("never touches the skin", self.answer("run", case, "-o", "out", *soft))
        self.assertIn("never touches the skin", self.answer("sweep", case, "-o", "out", "--over", "contact.friction=0.1,0.2"))

    def test_height_map_with_a_small_preload(self):
        case = self.profile_case(RIDGE, "-1 um")
        self.answer("check", case, expect=0)

    def test_formulas_in_tables(self):
        self.answer("sweep", QUICK, "-o", "out", "--only", "mechanics", "--no-report", "--over", 'title="=1+1"',
                    expect=0, within=300)
        self.assertIn("\"'=1+1\"", (self.folder / "out" / "sweep.csv").read_text())


if __name__ == "__main__":
    unittest.main()
