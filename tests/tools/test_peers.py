# SPDX-License-Identifier: LGPL-2.1-or-later
"""benchmarks/peers: its command line, its page, its measures, and what becomes of rivals that crash, hang or fail."""

import subprocess
import sys
import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

import documents
import numpy as np

BENCHMARKS = documents.ROOT / "benchmarks"
sys.path += [str(BENCHMARKS / name) for name in ("peers", "harness", "boolean")]

import boolean_peers  # noqa: E402
import peer_environment  # noqa: E402
import peer_figures  # noqa: E402
import peer_page  # noqa: E402
import peer_tasks  # noqa: E402
import peers  # noqa: E402

TETRAHEDRON = (np.array([(0, 0, 0), (0, 1, 1), (1, 0, 1), (1, 1, 0)], float), np.array([(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]))
COLUMNS = (peer_tasks.Column("triangles", "triangles", "d", -1), peer_tasks.Column("angle", "angle", ".1f", 1),
           peer_tasks.Column("closed", "closed"))


def rows():
    return [{"case": "plate", "mesher": "MeshQuality", "triangles": 100, "angle": 25.0, "closed": True, "runs": 3},
            {"case": "plate", "mesher": "Rival", "triangles": 50, "angle": 5.0, "closed": False, "runs": 3},
            {"case": "plate", "mesher": "Other", "failed": "crash: SIGSEGV"}]


class CommandLine(unittest.TestCase):
    def test_help_names_every_task_and_option_of_its_page(self):
        done = subprocess.run([sys.executable, str(BENCHMARKS / "peers" / "peers.py"), "--help"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in (*peers.TASKS, "--judge", "--write", "--cache"):
            self.assertIn(word, done.stdout)

    def test_tasks_and_runs_agree(self):
        import own_runs
        import peer_runs

        self.assertEqual(set(peers.TASKS), set(peer_tasks.TASKS))
        for name, task in peer_tasks.TASKS.items():
            able = {*own_runs.RUNS[name], *peer_runs.RUNS[name]} | ({"CGAL"} if name == "boolean" else set())
            self.assertEqual(set(task.meshers), able, name)
            self.assertLessEqual(set(task.relative), set(task.settings or ()), name)


class Page(unittest.TestCase):
    def test_a_row_of_each_and_a_dash_for_what_is_not_measured(self):
        self.assertEqual(peer_page.table(COLUMNS, rows()), [
            "| part | by | triangles | angle | closed | what went wrong |", "|---|---|---:|---:|---:|---|",
            "| plate | MeshQuality | 100 | 25.0 | yes |  |", "|  | Rival | 50 | 5.0 | no |  |",
            "|  | Other | - | - | - | crash: SIGSEGV |"])

    def test_rivals_ahead_come_first_with_their_faults(self):
        said = peer_page.section(mock.Mock(columns=COLUMNS, clean=lambda row: row["closed"], said="Said."), rows(),
                                 {"rival": "1.2"}, {"Absent": "no wheel"}, "command", False)
        self.assertIn("Ahead of MeshQuality:\n\n- Rival: triangles, on 1 of 1, 2.00 times in the median, 1 of them with faults.\n\nSaid.", said)
        self.assertTrue(said.startswith("    command\n"))
        self.assertIn("Versions: rival 1.2.\nLeft out: Absent (no wheel).", said)
        self.assertNotIn("angle, on", said)

    def test_nobody_ahead(self):
        self.assertEqual(peer_page.ahead(COLUMNS[1:], rows(), lambda row: True), [])

    def test_a_table_goes_between_its_marks_only(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder, "peers.md")
            first, last = peer_page.marks("fill")
            page.write_text(f"before\n{first}old{last}\nafter\n", encoding="utf-8")
            peer_page.put(page, "fill", "new")
            self.assertEqual(page.read_text(encoding="utf-8"), f"before\n{first}new{last}\nafter\n")
            with self.assertRaisesRegex(ValueError, "peers.md has no marks of surface"):
                peer_page.put(page, "surface", "new")

    def test_the_page_has_marks_of_every_task(self):
        text = peers.PAGE.read_text(encoding="utf-8")
        for name in peers.TASKS:
            for mark in peer_page.marks(name):
                self.assertIn(mark, text)


class Outcomes(unittest.TestCase):
    """A program in the place of a rival."""

    def rows(self, program, limit=20.0):
        arguments = types.SimpleNamespace(limit=limit, gibibytes=8.0, runs=2, judge=None)
        with tempfile.TemporaryDirectory() as folder:
            made = peers.Runs("fill", arguments, mock.Mock(), folder)
            surface = Path(folder, "given.off")
            boolean_peers.write_off(surface, *TETRAHEDRON)
            case = {"name": "tetrahedron", "input": str(surface), "target": None}
            with mock.patch.object(peers.Runs, "_command", lambda self, job: [sys.executable, "-c", program.format(**job)]):
                return peers.rows_of(made, case, ["Gmsh"], None)

    def test_a_result_is_measured(self):
        row, = self.rows("import numpy as np; np.savez('{out}', points=np.array([(0, 0, 0), (0, 1, 1), (1, 0, 1), (1, 1, 0.0)]), "
                         "tetrahedra=[(0, 1, 2, 3)]); print('{{\"seconds\": 0.5, \"wall\": 1.0}}')")
        self.assertNotIn("failed", row)
        self.assertEqual((row["tetrahedra"], row["conforms"], row["seconds"], row["rate"], row["runs"]), (1, True, 0.5, 2.0, 2))
        self.assertAlmostEqual(row["dihedral"], np.degrees(np.arccos(1 / 3)))

    def test_a_crash_is_a_row(self):
        row, = self.rows("import os; os.kill(os.getpid(), 11)")
        self.assertEqual(row["failed"], "crash: SIGSEGV")
        self.assertNotIn("seconds", row)

    def test_a_hang_is_a_row(self):
        row, = self.rows("while True: pass", limit=1.0)
        self.assertEqual(row["failed"], "time limit")

    def test_an_error_and_a_missing_result_are_rows(self):
        self.assertEqual(self.rows("raise SystemExit('no | such thing')")[0]["failed"], "error: no / such thing")
        self.assertEqual(self.rows("print('{{\"seconds\": 1, \"wall\": 1}}')")[0]["failed"], "no result")


class Measures(unittest.TestCase):
    def test_triangles(self):
        points, triangles = TETRAHEDRON
        np.testing.assert_allclose(peer_figures.angles(points, triangles), 60.0)
        self.assertAlmostEqual(abs(peer_figures.volume(points, triangles)), 1 / 3)
        self.assertTrue(peer_figures.is_closed(triangles))
        self.assertFalse(peer_figures.is_closed(triangles[:3]))
        self.assertFalse(peer_figures.is_closed(np.vstack([triangles[:3], triangles[3:, ::-1]])))

    def test_borders(self):
        points, triangles = TETRAHEDRON
        self.assertTrue(peer_figures.conforms((points, triangles), points, np.array([(0, 1, 2, 3)])))
        moved = points + [(0, 0, 0), (0, 0, 0), (0, 0, 0), (1e-9, 0, 0)]
        self.assertFalse(peer_figures.conforms((points, triangles), moved, np.array([(0, 1, 2, 3)])))

    def test_three_operations_make_a_row(self):
        sound = {"triangles": 10, "closed": True, "crossings": 0, "volume": 2.0}
        made = {"union": sound, "intersection": {**sound, "crossings": 3, "volume": 1.0}, "difference": None}
        found = peer_tasks.counted({"size": 4.0}, made, {"union": 2.0, "intersection": 1.5})
        self.assertEqual(found, {"sound": 1, "closed": 2, "triangles": 20, "off": 0.125})
        unjudged = {"union": {**sound, "crossings": None}}
        self.assertIsNone(peer_tasks.counted({"size": 4.0}, unjudged, {})["sound"])


class Scratch(unittest.TestCase):
    def test_what_cannot_be_installed_is_named_once_with_its_reason(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(peer_environment, "_said") as said:
            said.side_effect = [None, "ERROR: no wheel at /some/where for it"]
            for _ in range(2):
                found = peer_environment.Environment(folder, sys.executable, (("absent", "absent-mesher", "1.0"),))
                self.assertEqual((found.versions, found.missing), ({}, {"absent": "ERROR: no wheel at ... for it"}))
                found.python.parent.mkdir(parents=True, exist_ok=True)
                found.python.touch()
            self.assertEqual(said.call_count, 2)

    def test_versions_are_pinned(self):
        for _, package, version in peer_environment.PACKAGES:
            self.assertRegex(f"{package}=={version}", r"^[a-z0-9-]+==[0-9][0-9a-z.]*$")


if __name__ == "__main__":
    unittest.main()
