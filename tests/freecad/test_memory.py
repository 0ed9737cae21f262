# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects that are computed again and again keep no memory of it."""

import gc
import itertools
import sys

import helpers
import Mesh
import Part

import MeshQuality as mq

ROUNDS, COUNTINGS = 40, 4


def blocks_kept(action):
    """Blocks of Python's memory that one more `action` leaves behind, after many.

    The least of some countings: what is kept by mistake is so in each, caches grow in some.
    """
    def run():
        for _ in range(ROUNDS):
            action()
        gc.collect()
        return sys.getallocatedblocks()

    counts = [run() for _ in range(COUNTINGS + 1)]  # what is kept once is kept in the first
    return min(after - before for before, after in itertools.pairwise(counts)) / ROUNDS


class EditedAgainAndAgain(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.source = self.box()
        self.edits = 0

    def edit(self):
        """The box gets another length."""
        self.edits += 1
        self.source.Length = 5 + self.edits % 7
        self.document.recompute()

    def expect_nothing_kept(self, mesh, edit):
        fingerprint = mesh.Fingerprint
        edit()
        self.assertNotEqual(mesh.Fingerprint, fingerprint, "it was not computed again")
        # Not 0, for what happens to be there when it is counted; a value kept by mistake is one more each time for
        # each of several options.
        self.assertLess(blocks_kept(edit), 1.5)

    def test_a_quality_mesh(self):
        self.expect_nothing_kept(mq.add_quality_mesh(self.source, chord_height=0.1), self.edit)

    def test_a_curved_mesh(self):
        self.expect_nothing_kept(mq.add_curved_mesh(self.source, order=2), self.edit)

    def test_a_boolean(self):
        plain = self.document.addObject("Mesh::Feature", "Plain")
        plain.Mesh = Mesh.createBox(3, 3, 3)
        self.document.recompute()
        self.expect_nothing_kept(mq.add_boolean(self.source, plain, "union", tolerance=0.5), self.edit)

    def test_an_improved_mesh(self):
        plain = self.document.addObject("Mesh::Feature", "Plain")

        def edit():
            self.edits += 1
            points, facets = Part.makeCylinder(5, 5 + self.edits % 7).tessellate(0.5)
            plain.Mesh = Mesh.Mesh([points[i] for facet in facets for i in facet])
            plain.touch()
            self.document.recompute()

        edit()
        self.expect_nothing_kept(mq.add_improved_mesh(plain, min_angle=20, tolerance=0.5), edit)
