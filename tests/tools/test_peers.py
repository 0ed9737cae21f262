# SPDX-License-Identifier: LGPL-2.1-or-later
"""benchmarks/peers: its command line, its page, its measures, and what becomes of rivals that crash, hang or fail."""

import importlib.util
import json
import os
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
sys.path += [str(BENCHMARKS / name) for name in ("peers", "harness", "boolean", "surfaces")]

import boolean_peers  # noqa: E402
import peer_environment  # noqa: E402
import peer_figures  # noqa: E402
import peer_page  # noqa: E402
import peer_sets  # noqa: E402
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
            able = {*own_runs.RUNS[name], *peer_runs.RUNS[name]} | ({"CGAL"} if task.cgal else set())
            self.assertEqual(set(task.meshers), able, name)
            self.assertLessEqual(set(task.relative), set(task.settings or ()), name)


class Page(unittest.TestCase):
    def test_a_row_of_each_and_a_dash_for_what_is_not_measured(self):
        self.assertEqual(peer_page.table(COLUMNS, rows()), [
            "| part | by | triangles | angle | closed | what went wrong |", "|---|---|---:|---:|---:|---|",
            "| plate | MeshQuality | 100 | 25.0 | yes |  |", "|  | Rival | 50 | 5.0 | no |  |",
            "|  | Other | - | - | - | crash: SIGSEGV |"])

    def test_the_front_page_has_the_first_part_without_reasons(self):
        columns = [peer_tasks.Column("triangles", "triangles", "d"), peer_tasks.Column("spread", "spread", ".0%")]
        self.assertEqual(peer_page.figures(columns, [*rows()[:2], {"case": "ball", "mesher": "MeshQuality", "triangles": 7}]),
                         "| part | by | triangles |\n|---|---|---:|\n| plate | MeshQuality | 100 |\n|  | Rival | 50 |")

    def test_rivals_ahead_come_first_with_their_faults(self):
        said = peer_page.section(mock.Mock(columns=COLUMNS, clean=lambda row: row["closed"], said="Said.", about=""), rows(),
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
        for mark in peer_page.marks("figures"):
            self.assertIn(mark, documents.ROOT.joinpath("README.md").read_text(encoding="utf-8"))


class Outcomes(unittest.TestCase):
    """A program in the place of a rival."""

    def rows(self, program, limit=20.0, threads=1):
        cores = sorted(os.sched_getaffinity(0))
        arguments = types.SimpleNamespace(limit=limit, clock=10.0, gibibytes=8.0, runs=2, judge=None, program=[], cores=cores[:1] * threads)
        with tempfile.TemporaryDirectory() as folder:
            made = peers.Runs("fill", arguments, mock.Mock(), folder)
            surface = Path(folder, "given.off")
            boolean_peers.write_off(surface, *TETRAHEDRON)
            case = {"name": "tetrahedron", "input": str(surface), "target": None}
            with mock.patch.object(peers.Runs, "_command", lambda self, job: [sys.executable, "-c", program.format(**job)]):
                try:
                    return peers.rows_of(made, case, ["Gmsh"], None)
                finally:
                    os.sched_setaffinity(0, cores)

    def test_a_result_is_measured(self):
        row, = self.rows("import numpy as np; np.savez('{out}', points=np.array([(0, 0, 0), (0, 1, 1), (1, 0, 1), (1, 1, 0.0)]), "
                         "tetrahedra=[(0, 1, 2, 3)]); print('{{\"seconds\": 0.5, \"wall\": 1.0}}')")
        self.assertNotIn("failed", row)
        self.assertEqual((row["tetrahedra"], row["conforms"], row["seconds"], row["rate"], row["runs"]), (1, True, 0.5, 2.0, 2))
        self.assertAlmostEqual(row["dihedral"], np.degrees(np.arccos(1 / 3)))

    def test_with_several_cores_there_are_times_of_both(self):
        row, = self.rows("import os; import numpy as np; np.savez('{out}', points=np.array([(0, 0, 0), (0, 1, 1), (1, 0, 1), (1, 1, 0.0)]), "
                         "tetrahedra=[(0, 1, 2, 3)]); print('{{\"seconds\": %s, \"wall\": 2}}' % os.environ['OMP_NUM_THREADS'])", threads=2)
        self.assertEqual((row["seconds"], row["seconds_all"], row["wall_all"], row["runs"]), (1.0, 2.0, 2.0, 2))

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

    @unittest.skipUnless(importlib.util.find_spec("vtk"), "needs VTK")
    def test_offsets_by_vtk(self):
        import made_meshes

        points, triangles = made_meshes.sphere(3)
        with tempfile.TemporaryDirectory() as folder:
            given, made = Path(folder, "given.off"), Path(folder, "made.off")
            boolean_peers.write_off(given, points, triangles)
            case = {"input": str(given), "distance": 0.1, "target": 0.01}
            for factor, distance in ((1.1, 0.0), (1.15, 5.0)):
                boolean_peers.write_off(made, factor * points, triangles)
                self.assertAlmostEqual(peer_figures.offset(case, made, None, sound=False)["distance"], distance, delta=0.5)
            case["distance"] = -0.1
            boolean_peers.write_off(made, 0.9 * points, triangles)
            self.assertAlmostEqual(peer_figures.offset(case, made, None, sound=False)["distance"], 0.0, delta=0.5)

    def test_three_operations_make_a_row(self):
        sound = {"triangles": 10, "closed": True, "crossings": 0, "volume": 2.0}
        made = {"union": sound, "intersection": {**sound, "crossings": 3, "volume": 1.0}, "difference": None}
        found = peer_tasks.counted({"size": 4.0}, made, {"union": 2.0, "intersection": 1.5})
        self.assertEqual(found, {"sound": 1, "closed": 2, "triangles": 20, "off": 0.125})
        unjudged = {"union": {**sound, "crossings": None}}
        self.assertIsNone(peer_tasks.counted({"size": 4.0}, unjudged, {})["sound"])


    def test_jacobians_of_quadratic_tetrahedra(self):
        corners = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)
        straight = np.vstack([corners, [corners[[i, j]].mean(axis=0) for i, j in ((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))]])
        np.testing.assert_allclose(peer_figures.sampled_jacobians(straight[None]), 1.0)
        # x = r + 4 a r (1 - r - s - t): J = 1 + 4 a (1 - 2 r - s - t), least at r = 1
        bent = straight.copy()
        bent[4, 0] += 0.2
        found = peer_figures.sampled_jacobians(bent[None])
        self.assertAlmostEqual(found.min(), 1.0 - 4.0 * 0.2)
        self.assertAlmostEqual(found.max(), 1.0 + 4.0 * 0.2)

    def test_counts_of_public_parts(self):
        good = {"closed_shells": True, "bodies": 1, "triangles": 100, "angle": 25.0, "forced": 25.0, "distance": 1.0, "watertight": True,
                "closed": True, "crossings": 0, "seconds": 0.5}
        found = {("a", "BRepMesh"): good | {"triangles": 50, "forced": 2.0}, ("b", "BRepMesh"): good | {"closed": False, "forced": 3.0},
                 ("c", "BRepMesh"): good, ("d", "BRepMesh"): {"failed": "crash: SIGSEGV"}, ("e", "BRepMesh"): good,
                 ("a", "MeshQuality"): good, ("b", "MeshQuality"): good | {"bodies": 2, "closed": False, "crossings": 4, "triangles": 300},
                 ("c", "MeshQuality"): good | {"distance": 1.2}, ("d", "MeshQuality"): {"failed": "time limit"}}
        rival, own = peer_sets.rows(found, ["BRepMesh", "MeshQuality"])
        self.assertEqual((own["case"], own["meshed"], own["late"], own["crashed"]), ("4 parts", 3, 1, 0))
        self.assertEqual((own["closed"], own["free"], own["good"], own["ratio"]), (100.0, 100.0, 50.0, 2.0))
        self.assertAlmostEqual(own["distance"], 200 / 3)
        self.assertEqual((rival["meshed"], rival["crashed"], rival["but_angles"], rival["good"]), (3, 1, 50.0, 25.0))
        self.assertAlmostEqual(rival["closed"], 200 / 3)

    def test_a_run_over_public_parts_goes_on_where_it_stopped(self):
        line = {"part": "8a", "mesher": "MeshQuality", "failed": "time limit"}
        with tempfile.TemporaryDirectory() as folder:
            kept, parts = Path(folder, "kept.jsonl"), Path(folder, "parts")
            parts.mkdir()
            for name in ("8a.step", "9b.txt", "0c.step"):
                (parts / name).touch()
            kept.write_text(json.dumps(line) + "\n", encoding="utf-8")
            arguments = types.SimpleNamespace(parts=parts, share="measure", most=0, afresh=False)
            found = peer_sets.results(mock.Mock(arguments=arguments), ["MeshQuality"], kept)
        self.assertEqual(found, {("8a", "MeshQuality"): line})


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

    def test_rivals_and_their_packages(self):
        found = {mesher: peer_environment.package_of(mesher) for mesher in ("Gmsh HXT", "fTetWild", "CGAL", "MeshQuality", "OpenCASCADE")}
        self.assertEqual(found, {"Gmsh HXT": "gmsh", "fTetWild": "pytetwild", "CGAL": "CGAL", "MeshQuality": None, "OpenCASCADE": None})

    def test_versions_are_pinned(self):
        for _, package, version in peer_environment.PACKAGES:
            self.assertRegex(f"{package}=={version}", r"^[a-z0-9-]+==[0-9][0-9a-z.]*$")


if __name__ == "__main__":
    unittest.main()
