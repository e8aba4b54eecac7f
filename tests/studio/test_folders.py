# SPDX-License-Identifier: Apache-2.0
"""Contents of a workspace: damaged results, names that several pages ask for, links that are swapped while they are
read."""

import concurrent.futures
import json
import os
import shutil
import threading
import unittest

from studio_server import QUICK, StudioTest

DEEP = "[" * 1_000_000 + "]" * 1_000_000


def special(path):
    """Makes what is not an ordinary file under each of the names that it gives."""
    return {"a pipe": lambda: os.mkfifo(path), "a folder": lambda: os.mkdir(path), "a device": lambda: os.symlink("/dev/zero", path),
            "a link to itself": lambda: os.symlink(path, path), "a link to a pipe": lambda: (os.mkfifo(f"{path}.pipe"), os.symlink(f"{path}.pipe", path))}


class Folders(StudioTest):
    def result(self, name, **files):
        folder = self.folder / name
        folder.mkdir()
        for file, text in {"manifest": "{}", "case": QUICK, "summary": "{}", **files}.items():
            (folder / f"{file}.{'toml' if file == 'case' else 'json'}").write_text(text)
        return folder

    def test_a_damaged_result_is_one_row(self):
        self.result("good", manifest='{"state": "finished", "started": "2026-01-01T00:00:00Z"}',
                    summary='{"metrics": {"mean_shear_slide": {"value": null, "unit": "N"}}, "warnings": ["one"]}')
        damaged = [("manifest", text) for text in ('{"state": 3}', '{"started": null}', '{"started": [1]}', '{"command": {}}', "[]", "null", "3", "{", "",
                                                   DEEP, f'{{"state": {DEEP}}}', f'{{"other": {DEEP}}}', '{"a":' * 100_000 + "1" + "}" * 100_000)]
        damaged += [("summary", text) for text in ('{"warnings": 3}', '{"warnings": [3]}', '{"warnings": {"a": "b"}}', '{"metrics": []}',
                                                   '{"metrics": {"mean_shear_slide": 3}}', '{"metrics": {"mean_shear_slide": {"value": "1", "unit": "N"}}}',
                                                   '{"metrics": {"a": {"value": 1}}}', '{"metrics": {"a": {"value": 1, "unit": null}}}', '{"error_estimate": 1}',
                                                   '{"error_estimate": {"a": "b"}}', '{"timing": {"a": []}}', '{"column": 3}', DEEP, f'{{"metrics": {DEEP}}}',
                                                   "[1]", '{"parameters": {"a": {"value": 1, "unit": "1", "lower_95": "x"}}}', " " * 9_000_000)]
        for number, (file, text) in enumerate(damaged):
            self.result(f"bad-{number:02d}", **{file: text})
        (self.result("large") / "case.toml").write_bytes(b"#" * 9_000_000)
        runs = {run["path"]: run for run in self.studio.json("GET", "/api/runs")}
        self.assertEqual(len(runs), len(damaged) + 2)
        self.assertEqual((runs["good"]["state"], runs["good"]["warnings"]), ("finished", ["one"]))
        for path, run in runs.items():
            whole = self.studio.json("GET", f"/api/result?path={path}")
            self.assertEqual(whole["state"], run["state"])
            if path != "good":
                with self.subTest(path):
                    self.assertEqual((run["state"], run["started"], run["metrics"], whole["summary"]), ("damaged", "", {}, {}))
                    self.assertEqual(len(run["warnings"]), 1)

    def test_a_command_that_is_copied_is_one_of_ionskin_alone(self):
        commands = ["ionskin run a.toml -o a", "ionskin run 'a b.toml' -o 'it'\\''s'", "rm -r ~", "ionskin run a.toml; rm -r ~", "ionskin run $(id)", "ionskin `id`",
                    "ionskin run a\nid", "ionskin run 'a", "ionskin run a\\", "ionskin run a > b", "ionskin run 'a\x1b[2J'", "ionskin run \\'a;id", "ionskin run ~"]
        for number, command in enumerate(commands):
            self.result(f"run-{number:02d}", manifest=json.dumps({"command": command}))
        runs = sorted(self.studio.json("GET", "/api/runs"), key=lambda run: run["path"])
        self.assertEqual([run["command"] for run in runs], commands[:2] + [""] * (len(commands) - 2))

    def test_titles_are_texts_whatever_a_case_holds(self):
        for number, title in enumerate((f'"{DEEP[:100_000]}"', DEEP[:100_000], f'"a" {DEEP[:100_000]} "b"', '"\\ud800"', '"""', "'x'", '"', "\0", '"a\\u0000b"')):
            self.result(f"run-{number}", case=f"title = {title}\n")
        for run in self.studio.json("GET", "/api/runs"):
            self.assertIsInstance(run["title"], str)

    def test_files_that_are_none_are_passed_over(self):
        for number, kind in enumerate(special("")):
            for file in ("manifest.json", "summary.json", "case.toml", "sweep.csv", "fit.json", "results.h5", "signals.csv", "report.html"):
                path = self.result(f"{file}-{number}") / file
                path.unlink(missing_ok=True)
                special(path)[kind]()
        with concurrent.futures.ThreadPoolExecutor(4) as pool:  # as several pages do
            lists = [pool.submit(self.studio.json, "GET", "/api/runs") for _ in range(4)]
            self.assertGreater(min(len(one.result()) for one in lists), 0)
        for folder in self.folder.iterdir():
            for call in ("result?path={0}", "fields?path={0}", "table?path={0}&name=signals", "table?path={0}&name=sweep",
                         "text?path={0}/case.toml", "text?path={0}/summary.json", "download?path={0}/report.html", "compare?first={0}&second={0}"):
                with self.subTest(folder=folder.name, call=call):
                    self.assertIn(self.studio.call("GET", "/api/" + call.format(folder.name))[0], (200, 403, 404, 422))
        os.mkfifo(self.folder / "source.toml")
        os.mkfifo(self.folder / "measured.csv")
        body = {"kind": "run", "name": "a", "case": QUICK}
        self.assertIn(self.studio.call("POST", "/api/jobs", {**body, "source": "source.toml"})[0], (400, 403, 404, 422))
        body = {**body, "kind": "fit", "data": "measured.csv", "column": "current_difference", "free": ["coupling.coefficient"]}
        self.assertIn(self.studio.call("POST", "/api/jobs", body)[0], (400, 403, 404, 422))
        self.assertFalse((self.folder / "a").exists())

    def test_every_job_has_a_name_of_its_own_however_many_ask_at_once(self):
        cases = [QUICK.replace("friction = 0.3", f"friction = 0.{20 + number}") for number in range(20)]
        (self.folder / "shared.toml").write_text(QUICK)
        gate = threading.Barrier(20)

        def ask(number):
            gate.wait()
            if number % 2:
                return self.studio.run("same", source="shared.toml"), QUICK
            return self.studio.run("same", cases[number]), cases[number]

        with concurrent.futures.ThreadPoolExecutor(20) as pool:
            started = list(pool.map(ask, range(20)))
        for job in reversed(self.studio.json("GET", "/api/jobs")):
            self.studio.call("POST", f"/api/jobs/{job['id']}/cancel", {})
        self.assertEqual(len({job["folder"] for job, _ in started}), 20)
        for job, case in started:
            file = job["command"].split()[2]
            self.assertEqual((self.folder / file).read_text(), case)
            self.assertEqual(file, "shared.toml" if case == QUICK else f"{job['folder']}.toml")

    def test_measurements_get_names_of_their_own(self):
        def upload(number):
            _, _, body = self.studio.call("POST", "/api/upload?name=same.csv", f"{number}\n".encode(), headers={"Content-Type": "text/csv"})
            return json.loads(body)["path"]

        with concurrent.futures.ThreadPoolExecutor(20) as pool:
            paths = list(pool.map(upload, range(20)))
        self.assertEqual([(self.folder / path).read_text() for path in paths], [f"{number}\n" for number in range(20)])

    def test_a_job_that_is_refused_leaves_no_file(self):
        run = {"kind": "run", "name": "a", "case": QUICK}
        huge = QUICK.replace('preset = "coarse"', 'preset = "fine"\nmesh_refinement = 8')
        for body in ({**run, "case": huge}, {**run, "case": "x"}, {**run, "kind": "sweep"}, {**run, "kind": "sweep", "over": [{"key": "no.key", "values": [1]}]},
                     {**run, "kind": "fit"}, {**run, "kind": "fit", "data": "none.csv"}, {**run, "source": "none.toml"}, {**run, "name": "../a"},
                     {**run, "kind": "sweep", "over": [{"key": "contact.friction", "values": ["0.1,0.2"]}]},
                     {**run, "kind": "sweep", "over": [{"key": "strain.file", "values": ["/etc/passwd"]}]}):
            status = self.studio.call("POST", "/api/jobs", body)[0]
            self.assertIn(status, (400, 403, 404, 409, 422), body)
            self.assertEqual(os.listdir(self.folder), [], (status, body))
        for _ in range(64):
            self.studio.run("full", QUICK)
        for _ in range(64):  # of those before, some may have ended
            before = sorted(os.listdir(self.folder))
            status = self.studio.call("POST", "/api/jobs", run)[0]
            if status != 201:
                break
        self.assertEqual(status, 429)
        after = [name for name in os.listdir(self.folder) if not name.startswith("full")]
        self.assertEqual(sorted(after), [name for name in before if not name.startswith("full")])
        for job in reversed(self.studio.json("GET", "/api/jobs")):
            self.studio.call("POST", f"/api/jobs/{job['id']}/cancel", {})

    def test_a_link_that_is_swapped_in_gives_nothing_from_outside(self):
        inside, outside = self.result("inside"), self.scratch / "outside"
        (inside / "signals.csv").write_text("time [s],a [A]\n0,1\n")
        shutil.copytree(inside, outside)
        secret = "secret_of_this_user"
        for name, text in (("case.toml", f'title = "{secret}"\n'), ("summary.json", json.dumps({"warnings": [secret]})),
                           ("manifest.json", json.dumps({"state": secret})), ("signals.csv", f"{secret},b\n0,1\n"), ("results.h5", secret)):
            (outside / name).write_text(text)
        swapped = {self.folder / "folder": outside, **{inside / name: outside / name for name in ("case.toml", "summary.json", "signals.csv")}}
        shutil.copytree(inside, self.folder / "folder")
        ended = threading.Event()

        def swap():
            """Now the user's own, now a link out, each at once."""
            while not ended.is_set():
                for path, target in swapped.items():
                    aside, link = path.with_name(path.name + ".aside"), path.with_name(path.name + ".link")
                    os.symlink(target, link)
                    os.rename(path, aside)
                    os.rename(link, path)
                    os.rename(path, link)
                    os.rename(aside, path)
                    os.unlink(link)

        calls = ["text?path=folder/case.toml", "download?path=folder/signals.csv", "result?path=folder", "table?path=folder&name=signals", "runs",
                 "fields?path=folder", "text?path=inside/case.toml", "download?path=inside/summary.json", "result?path=inside",
                 "table?path=inside&name=signals"]
        swapper = threading.Thread(target=swap)
        swapper.start()
        try:
            for _ in range(60):
                for call in calls:
                    status, _, body = self.studio.call("GET", f"/api/{call}")
                    self.assertIn(status, (200, 403, 404, 422), body)
                    self.assertNotIn(secret.encode(), body, call)
        finally:
            ended.set()
            swapper.join()


if __name__ == "__main__":
    unittest.main()
