# SPDX-License-Identifier: LGPL-2.1-or-later
"""The replay of recorded tasks on a number of threads."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks" / "triangulate"))

import schedule  # noqa: E402

# A stage of 1 s with two sections and another stage. Of the first section's tasks the second calls the third section.
RECORD = {
    "tasks": [(-1, 1.0), (0, 4.0), (0, 1.0), (2, 2.0), (2, 2.0), (0, 3.0), (1, 0.5), (1, 0.5), (-1, 2.0)],
    "sections": [(0, 2), (0, 3), (2, 2)],
    "stages": [("first", 0)],
}


class Makespan(unittest.TestCase):
    def test_takes_tasks_in_their_order(self):
        # 0: 3, 4 (until 7); 1: 2, 2, 2 (until 6).
        self.assertEqual(schedule.makespan([3, 2, 2, 4, 2], 2), 7)
        self.assertEqual(schedule.makespan([1, 1, 1, 1, 4], 2), 6)
        self.assertEqual(schedule.makespan([4, 1, 1, 1, 1], 2), 4)

    def test_is_the_sum_on_one_and_the_longest_on_many(self):
        seconds = [0.5, 2.0, 0.25, 1.25]
        self.assertEqual(schedule.makespan(seconds, 1), 4.0)
        self.assertEqual(schedule.makespan(seconds, 4), 2.0)
        self.assertEqual(schedule.makespan(seconds, 9), 2.0)
        self.assertEqual(schedule.makespan([], 3), 0.0)

    def test_adds_the_start(self):
        self.assertEqual(schedule.makespan([1, 1], 2, 0.5), 1.5)


class Replay(unittest.TestCase):
    def test_of_sections_within_tasks(self):
        # Section 2: 2 s. Section 0: tasks of 4, 1 + 2 and 3 s on two threads: 6 s. Section 1: 0.5 s.
        found = schedule.durations(RECORD, {2: 0.0, 3: 0.0})
        self.assertEqual(found[0], 1.0 + 6.0 + 0.5)
        self.assertEqual(found[2], 3.0)
        self.assertEqual(found[8], 2.0)

    def test_adds_the_start_of_every_section(self):
        # Section 2: 2.25 s. Section 0: 4, 3.25 and 3 s on two threads, 6.25 s, and its start. Section 1: 0.5 s.
        self.assertEqual(schedule.durations(RECORD, {2: 0.25, 3: 0.125})[0], 1.0 + 6.5 + 0.625)

    def test_on_one_thread_is_the_sum(self):
        self.assertEqual(schedule.durations_on_one(RECORD)[0], 14.0)

    def test_of_stages_by_name(self):
        self.assertEqual(schedule.stage_seconds(RECORD, {2: 0.0, 3: 0.0}), {"first": (14.0, 7.5), "": (2.0, 2.0)})
        self.assertEqual(schedule.numbers_of_threads(RECORD), [2, 3])


if __name__ == "__main__":
    unittest.main()
