# SPDX-License-Identifier: Apache-2.0
"""Every command of the README and of the pages runs, and prints what the pages say."""

import os
import re
import shlex
import subprocess
import unittest

from documented import console_blocks, first_difference, indented_commands
from program import PROGRAM, ROOT, ProgramTest
from tiers import long_test

DOCS = ROOT / "docs"
# Only the case, its mesh and the number of points are made smaller.
COARSE = "--set numerics.mesh_refinement=0.3 --set numerics.time_refinement=0.3 --set skin.sides=symmetry"
SMALLER = (("init my_skin.toml", "init my_skin.toml --from quick"), ("cases/paper.toml", "cases/paper/coarse.toml"),
           ("contact.friction=0.05:0.05:0.5", "contact.friction=0.1,0.4"))
# The tests `verification`, `program_fit` and `studio_jobs` run these.
ELSEWHERE = ("build/ionskin verify", "build/ionskin fit", "build/ionskin studio")
# The exit code that the commands of a page on errors end with.
EXIT_CODES = {"wrong_case.md": 2, "files.md": 2, "solver.md": 3}


class DocumentedTest(ProgramTest):
    def setUp(self):
        super().setUp()
        for name in ("cases", "materials", "python"):
            (self.folder / name).symlink_to(ROOT / name)
        (self.folder / "build").symlink_to(PROGRAM.parent)
        os.environ["PATH"] = f"{PROGRAM.parent}:{os.environ['PATH']}"

    def shell(self, command):
        """Runs a command line in the scratch folder: what it printed, errors last, and how it ended."""
        process = subprocess.run(["bash", "-c", command], capture_output=True, text=True, cwd=self.folder, check=False)
        errors = process.stderr[process.stderr.find("error:"):] if process.returncode else ""
        return (process.stdout + errors).splitlines(), process.returncode

    def check_page(self, name, code=0):
        """Runs the console blocks of a page in order and compares what they print and how they end."""
        pairs = console_blocks((DOCS / name).read_text())
        self.assertTrue(pairs, name)
        for command, expected in pairs:
            with self.subTest(command):
                printed, ended = self.shell(command)
                self.assertIsNone(first_difference(expected, printed), "\n".join(printed))
                if code or "error:" not in "".join(expected):
                    self.assertEqual(ended, code)


class Pages(DocumentedTest):
    @long_test
    def test_tutorial(self):
        self.check_page("tutorial.md")

    @long_test
    def test_touch(self):
        self.check_page("touch.md")

    @long_test
    def test_friction(self):
        self.check_page("friction.md")

    @long_test
    def test_what_slip_looks_like(self):
        self.check_page("what-slip-looks-like.md")

    def test_errors(self):
        self.shell("ionskin init my_skin.toml --from quick")
        for page in sorted((DOCS / "errors").glob("*.md")):
            if "```console" in page.read_text():
                self.check_page(page.relative_to(DOCS), EXIT_CODES[page.name])


class Readme(DocumentedTest):
    def test_commands(self):
        commands = indented_commands((ROOT / "README.md").read_text(), ("build/ionskin",))
        self.assertGreater(len(commands), 8)
        for command in commands:
            if command.startswith(ELSEWHERE):
                continue
            for whole, part in SMALLER:
                command = command.replace(whole, part)
            if command.startswith(("build/ionskin run", "build/ionskin sweep", "build/ionskin fit")):
                command = f"{command} {COARSE}"
            with self.subTest(command):
                printed, code = self.shell(command)
                self.assertEqual(code, 0, "\n".join(printed))
        self.python_page()

    def python_page(self):
        """The example of reading on the page on Python, on the run and the sweep that the commands left."""
        reading = (DOCS / "python.md").read_text().partition("## Read")[2]
        example = re.search(r"```python\n(.*?)```", reading, re.DOTALL)[1]
        process = subprocess.run(["/usr/bin/python3", "-c", example], cwd=self.folder, capture_output=True, text=True,
                                 check=False)
        self.assertEqual(process.returncode, 0, process.stderr)
        self.assertIn("slide", process.stdout)


class Words(DocumentedTest):
    def known(self):
        """Verbs and options that the program has."""
        top = self.run_program("--help").stdout
        verbs = [line.split()[0] for line in top.split("Subcommands:")[1].split("Exit codes")[0].splitlines()
                 if re.match(r"  \w", line)]
        option = re.compile(r"^  (?:-\w,)?(--[a-z-]+)", re.MULTILINE)
        options = {verb: set(option.findall(self.run_program(verb, "--help").stdout)) for verb in verbs}
        return options, set(option.findall(top))

    def test_every_verb_and_option_of_the_pages_exists(self):
        options, general = self.known()
        pages = [ROOT / "README.md", *DOCS.glob("*.md"), *DOCS.glob("errors/*.md")]
        found = 0
        for page in pages:
            for verb, rest in re.findall(r"\bionskin (\w+)((?: [^\n`|]*)?)", page.read_text()):
                if verb not in options:
                    continue
                for option in re.findall(r"--[a-z-]+", rest):
                    found += 1
                    self.assertIn(option, options[verb] | general, f"{page.name}: ionskin {verb} {option}")
        self.assertGreater(found, 20)

    def test_contributing_names_what_exists(self):
        text = (ROOT / "CONTRIBUTING.md").read_text()
        files = {name for name in re.findall(r"`([\w*./]+)`", text) if "/" in name and "FOLDER" not in name}
        self.assertGreater(len(files), 10)
        for name in files:
            self.assertTrue(list(ROOT.glob(name)), name)
        for word in ("mechanics_hash", "channel_rules", "channels_for"):
            self.assertIn(word, text)
            place = next(line for line in text.split("\n") if word in line)
            source = re.search(r"`(src/[\w./]+)`", text[text.index(place):])[1]
            self.assertIn(word, (ROOT / source).read_text(), source)

    def test_manual_page_and_completion_know_every_option(self):
        options, _ = self.known()
        manual = self.run_program("man").stdout.replace("\\-", "-")
        script = self.run_program("completion", "bash").stdout
        for verb, names in options.items():
            self.assertIn(f'.SS "ionskin {verb}"', manual)
            section = manual.split(f'.SS "ionskin {verb}"')[1].split(".SS")[0]
            for name in names:
                self.assertIn(name, section, verb)
                self.assertIn(name, script)

    def test_completion(self):
        script = self.write("completion.bash", self.run_program("completion", "bash").stdout)

        def complete(*words):
            line = f"source {script}; COMP_WORDS=({shlex.join(words)}); COMP_CWORD={len(words) - 1}; _ionskin; " \
                   'printf "%s\\n" "${COMPREPLY[@]}"'
            return subprocess.run(["bash", "-c", line], capture_output=True, text=True, cwd=self.folder,
                                  check=False).stdout.split()

        self.assertEqual(complete("ionskin", "swe"), ["sweep"])
        self.assertIn("--resume", complete("ionskin", "run", "--re"))
        self.assertEqual(complete("ionskin", "run", "--only", "m"), ["mechanics"])
        self.assertEqual(complete("ionskin", "sweep", "--over", "contact.fr"), ["contact.friction="])

    def test_citation_file_agrees_with_cite(self):
        citation = (ROOT / "CITATION.cff").read_text()
        cited = self.run_program("cite").stdout
        version = re.search(r"^version: (.+)$", citation, re.MULTILINE)[1]
        self.assertIn(f"version = {{{version}}}", cited)
        self.assertIn(version, self.run_program("--version").stdout)
        for pattern in (r'name: "(.+)"', r'title: "ionskin: (.+)"', r"date-released: (\d{4})-"):
            self.assertIn(re.search(pattern, citation)[1], cited)

    def test_pages_name_the_version_of_the_program(self):
        version = self.run_program("--version").stdout.split()[1]
        latest = re.search(r"^## (\d+\.\d+\.\d+)", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)[1]
        self.assertEqual(version, latest)
        page = f"docs/release-{version.rpartition('.')[0]}.md"
        self.assertTrue((ROOT / page).exists(), page)
        for name in ("README.md", "docs/install.md"):
            packages = re.findall(r"ionskin[_-](\d+\.\d+\.\d+)[_-]", (ROOT / name).read_text())
            self.assertEqual(set(packages), {version}, name)


if __name__ == "__main__":
    unittest.main()
