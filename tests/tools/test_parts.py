# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of public parts, and what a run over them counts."""

import sys
import unittest
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks" / "corpus_runs"))

import parts_report  # noqa: E402
import parts_sources  # noqa: E402

OPTIONS = {"min_angle": 25.0, "chord_height_relative": 0.002}
GOOD = {
    "file": "00.step", "state": "ok", "valid": True, "faces": 6, "solids": 1, "free_shells": 0,
    "closed_shells": True, "surfaces": {"Plane": 6}, "triangles": 12,
    "closed": True, "manifold": True, "oriented": True,
    "min_angle": 26.0, "min_angle_unexempted": 26.0, "exempt": 0, "exempt_forced": 0,
    "max_chord_height": 0.1, "chord_height_asked": 0.1, "self_intersections": 0, "overlaps": 0,
    "brepmesh": {"triangles": 12, "cpu_seconds": 0.0}, "cpu_seconds": 0.0,
}


class List(unittest.TestCase):
    def setUp(self):
        self.rows = parts_sources.read_list()

    def test_names_every_part_once(self):
        self.assertGreaterEqual(len(self.rows), 1000)
        self.assertEqual(len({row["digest"] for row in self.rows}), len(self.rows))

    def test_is_spread(self):
        of_repository = Counter(row["repository"] for row in self.rows)
        self.assertLessEqual(max(of_repository.values()), parts_sources.MOST_OF_REPOSITORY)
        kin = Counter(parts_sources.family(row["repository"], row["path"]) for row in self.rows)
        self.assertLessEqual(max(kin.values()), parts_sources.MOST_OF_FAMILY)

    def test_shares_follow_from_the_digests(self):
        for row in self.rows:
            self.assertEqual(row["share"], parts_sources.share_of(row["digest"]))
        self.assertEqual({row["share"] for row in self.rows}, {"develop", "measure"})


class Choice(unittest.TestCase):
    def test_takes_one_of_every_family_first(self):
        files = [(name, "", 0) for name in ("m3.step", "m4.step", "m5.step", "nut.step")]
        names = [name for name, _, _ in parts_sources.in_turn("a/b", files)]
        self.assertIn("nut.step", names[:2])

    def test_leaves_what_holds_no_faces(self):
        curve = b"ISO-10303-21;\n#1=CIRCLE('',#2,1.);"
        self.assertFalse(parts_sources.holds_faces("a.step", curve))
        face = curve + b"#3=ADVANCED_FACE('',(),#4,.T.);"
        self.assertTrue(parts_sources.holds_faces("a.STEP", face))
        self.assertFalse(parts_sources.holds_faces("a.FCStd", b"no archive"))


class Symptoms(unittest.TestCase):
    def of(self, **changes):
        return parts_report.symptoms({**GOOD, **changes}, OPTIONS)

    def test_a_good_part_has_none(self):
        self.assertEqual(self.of(), [])

    def test_each_is_named(self):
        self.assertEqual(self.of(state="timeout"), ["timeout"])
        self.assertEqual(self.of(state="error", error="GeometryError: Face7: no"),
                         ["error: GeometryError: Face#: no"])
        self.assertEqual(self.of(closed=False), ["not watertight"])
        self.assertEqual(self.of(manifold=False), ["not manifold"])
        self.assertEqual(self.of(max_chord_height=0.2), ["mesh far from the part"])
        self.assertEqual(self.of(self_intersections=1), ["crossings"])
        self.assertEqual(self.of(triangles=241),
                         ["more than 20 times the triangles of BRepMesh"])

    def test_bodies_that_touch_may_share_edges(self):
        self.assertEqual(self.of(solids=2, manifold=False), [])
        self.assertEqual(self.of(solids=0, free_shells=2, manifold=False), [])

    def test_a_missed_angle_is_told_from_a_forced_one(self):
        self.assertEqual(self.of(min_angle=3.0, exempt=2), ["angle missed"])
        self.assertEqual(self.of(min_angle=3.0, exempt=2, exempt_forced=2), [])

    def test_the_judge_decides_what_is_forced(self):
        judge = {"min_angle": 3.0, "min_angle_unexcused": 3.0, "chord_max_L": 0.001, "reverse_max_L": 0.001, "hausdorff_L": 0.001,
                 "self_intersections": 0}
        self.assertEqual(self.of(min_angle=3.0, exempt=2, exempt_forced=2, judge=judge),
                         ["angle claimed"])
        self.assertEqual(self.of(min_angle=3.0, exempt=2,
                                 judge={**judge, "min_angle_unexcused": 25.0}), [])

    def test_a_far_place_of_the_judge_can_be_refuted(self):
        judge = {"min_angle": 30.0, "min_angle_unexcused": 30.0, "chord_max_L": 0.01, "reverse_max_L": 0.001, "hausdorff_L": 0.01,
                 "self_intersections": 0}
        asked = {**GOOD, **{"chord_height_asked": 0.1, "max_chord_height": 0.1}}
        far = ["mesh far from the part"]
        for near, report, wrong in (None, 0.1, far), (0.2, 0.1, far), (0.05, 0.2, far), (0.05, 0.1, []):
            figures = {**asked, "max_chord_height": report, "judge": {**judge, "farthest_place_mm": near}}
            self.assertEqual(parts_report.far_distances(figures, {"chord_height_relative": 0.002}), wrong)

    def test_the_measuring_share_is_not_named(self):
        text = parts_report.text([{**GOOD, "file": "deadbeef", "closed": False}], OPTIONS, False)
        self.assertNotIn("deadbeef", text)
        self.assertIn("deadbeef", parts_report.text(
            [{**GOOD, "file": "deadbeef", "closed": False}], OPTIONS, True))


if __name__ == "__main__":
    unittest.main()
