# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh objects that are seen through links, in other places than their own."""

import os

import numpy as np
import test_placement
from FreeCAD import Placement, Rotation, Vector

import MeshQuality as mq
from MeshQuality.core.sources import convert, frames


class ThroughLinks(test_placement.PlacementTest):
    """Mesh objects of ours that a link shows in another place."""

    def setUp(self):
        super().setUp()
        self.source = self.box("B", Length=1, Width=2, Height=3)
        self.home = self.part("Home", Placement(Vector(0, 0, 100), Rotation(0, 0, 30)), self.source)
        self.document.recompute()

    def links_to(self, obj):
        """A link, one that adds its placement to that of the object, one to a link in a container, and below a link."""
        plain = self.add("App::Link", "Plain", LinkedObject=obj, Placement=test_placement.TURNED)
        adding = self.add("App::Link", "Adding", LinkedObject=obj, LinkTransform=True, Placement=test_placement.TURNED)
        chained = self.add("App::Link", "Chained", LinkedObject=plain)
        holder = self.part("Holder", test_placement.TURNED, chained)
        below = self.add("App::Link", "Below", LinkedObject=holder, Placement=Placement(Vector(7, 8, 9), Rotation()))
        self.document.recompute()
        return plain, adding, chained, (below, "Chained.")

    def test_curved_elements_are_where_the_link_has_the_mesh(self):
        obj = mq.add_curved_mesh(self.source)
        for source in self.links_to(obj):
            with self.subTest(frames.leaf_of(source).Name):
                wanted = convert.arrays_of_mesh(source)[0]
                nodes = mq.CurvedMesh.of(source).nodes
                self.assert_same_box(test_placement.box_of(nodes), test_placement.box_of(wanted))
                self.assertGreater(np.abs(test_placement.box_of(nodes) - test_placement.box_of(mq.CurvedMesh.of(obj).nodes)).max(), 1.0)
                path = os.path.join(self.folder, "elements.msh")
                mq.export_curved_mesh(source, path)
                with open(path, encoding="ascii") as stream:
                    lines = [line.split() for line in stream if line.count(" ") == 2 and not line.startswith("4.1 ")]
                numbers = np.array([line for line in lines if "." in "".join(line)], dtype=float)
                self.assert_same_box(test_placement.box_of(numbers), test_placement.box_of(nodes), 1e-4)
        many = self.add("App::Link", "Many", LinkedObject=obj, ElementCount=2)
        scaled = self.add("App::Link", "Scaled", LinkedObject=obj, Scale=2.0)
        self.document.recompute()
        with self.assertRaisesRegex(mq.InvalidInput, "'Many' holds no curved mesh"):
            mq.CurvedMesh.of(many)
        with self.assertRaisesRegex(mq.InvalidInput, "'Scaled' is scaled"):
            mq.CurvedMesh.of(scaled)
        with self.assertRaisesRegex(mq.InvalidInput, "holds no curved mesh"):
            mq.CurvedMesh.of(7)

    def test_a_link_to_a_mesh_is_updated_as_the_mesh(self):
        obj = mq.add_quality_mesh(self.source)
        plain = self.links_to(obj)[0]
        mq.update(plain, max_edge=0.5)
        self.assertEqual(obj.MaxEdge.Value, 0.5)
        self.assertGreater(obj.Mesh.CountFacets, 50)

    def test_a_link_to_a_mesh_is_improved_and_measured_where_it_stands(self):
        obj = mq.add_quality_mesh(self.source)
        for source in self.links_to(obj):
            with self.subTest(frames.leaf_of(source).Name):
                better = mq.add_improved_mesh(source)
                self.assert_same_box(test_placement.box_in_document(better), test_placement.box_of(convert.arrays_of_mesh(source)[0]))
                self.assertEqual(mq.quality(source).triangles, obj.Mesh.CountFacets)
