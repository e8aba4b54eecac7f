# SPDX-License-Identifier: Apache-2.0
"""Builds the pages: copies docs/, adds the generated ones, runs Sphinx with warnings as errors.

With --material the verification set and the gallery's sweep are run first, once; without it the pages take what is
there, which takes seconds.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys

from case_reference import case_reference, command_line
from evidence import evidence
from gallery import gallery
from materials import materials
from mend_theme import mend_theme
from prediction import prediction
from python_api import python_api
from studio import studio
from verification import verification

DOCS = pathlib.Path(__file__).resolve().parent.parent
LEFT_OUT = ("_build", "generate", "__pycache__")


def make_material(program, material):
    """Runs what the verification page and the gallery show."""
    material.mkdir(parents=True, exist_ok=True)
    if not (material / "verification.csv").exists():
        # A row that fails is a row of the page, not the end of the pages.
        subprocess.run([program, "verify", "--csv", material / "verification.csv"], check=False)
    if not (material / "evidence.json").exists():
        subprocess.run([sys.executable, DOCS.parent / "benchmarks" / "evidence.py", program, "--json", material / "evidence.json"], check=True)
    sweep = material / "sweep"
    if not list(sweep.glob("figures/fig*.png")):
        subprocess.run([program, "sweep", DOCS.parent / "cases" / "quick.toml", "-o", sweep, "--overwrite", "--no-report",
                        "--over", "contact.friction=0.05:0.05:0.5"], check=True)
        subprocess.run([program, "report", sweep, "--figures"], check=True)


def copy_sources(source):
    """A fresh copy of the pages, to which generated ones can be added."""
    shutil.rmtree(source, ignore_errors=True)
    shutil.copytree(DOCS, source, ignore=shutil.ignore_patterns(*LEFT_OUT))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, required=True, help="the ionskin program")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for sources and what is run for them")
    parser.add_argument("--output", type=pathlib.Path, required=True, help="folder for the pages")
    parser.add_argument("--material", action="store_true", help="run what verification page and gallery show")
    options = parser.parse_args()
    program, material, source = options.program.resolve(), options.work / "material", options.work / "source"
    if options.material:
        make_material(program, material)
    copy_sources(source)
    pages = {"case_reference": case_reference(program), "command_line": command_line(program),
             "contributing": (DOCS.parent / "CONTRIBUTING.md").read_text(encoding="utf-8").replace("](docs/", "]("),
             "python_api": python_api(DOCS.parent / "python"),
             "materials": materials(DOCS.parent / "materials"),
             "verification_results": verification(material / "verification.csv", source),
             "evidence": evidence(material / "evidence.json", source),
             "prediction": prediction(DOCS / "prediction.json"),
             "gallery": gallery(material / "sweep" / "figures", source),
             "studio": studio(program.parent / "studio" / "pictures", source)}
    for name, text in pages.items():
        (source / f"{name}.md").write_text(text, encoding="utf-8")
    sphinx = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html", "-d", options.work / "doctrees"]
    code = subprocess.run([*sphinx, source, options.output], check=False).returncode
    mend_theme(options.output)
    return code


if __name__ == "__main__":
    sys.exit(main())
