# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nodes that draw a mesh in colour, and its legend."""

import unittest

import FreeCAD
import FreeCADGui
import gui_helpers
import numpy as np
import Part
from pivy import coin

from MeshQuality.gui.view.legend import BOTTOM_LEFT, BOTTOM_RIGHT, TOP_LEFT, TOP_RIGHT
from MeshQuality.gui.view.legend_node import LegendNode
from MeshQuality.gui.view.mesh_nodes import MeshNodes, ShadedTriangles

TWO = np.array([[(0, 0, 0), (2, 0, 0), (0, 3, 0)], [(2, 0, 0), (2, 3, 0), (0, 3, 0)]], dtype=np.float32)


def picture(width, height):
    return np.full((height, width, 4), 255, dtype=np.uint8)


def counted(node):
    """(triangles, lines) that would be drawn."""
    action = coin.SoGetPrimitiveCountAction()
    action.apply(node)
    return action.getTriangleCount(), action.getLineCount()


class Nodes(unittest.TestCase):
    def setUp(self):
        self.nodes = MeshNodes()

    def test_nothing_at_first(self):
        self.assertEqual(self.nodes.triangles, 0)
        self.assertEqual(counted(self.nodes.root), (0, 0))

    def test_triangles_take_the_place_of_those_before(self):
        self.nodes.show(TWO)
        self.assertEqual(counted(self.nodes.root), (2, 0))
        self.nodes.show(TWO[:1])
        self.assertEqual(self.nodes.triangles, 1)
        self.assertEqual(counted(self.nodes.root), (1, 0))

    def test_edges_are_lines(self):
        self.nodes.draw_edges(TWO[0], np.array([0, 1, 2, -1, 2, 0, -1], dtype=np.int32))
        self.assertEqual(counted(self.nodes.root)[1], 3)
        self.nodes.draw_edges(np.zeros((0, 3), dtype=np.float32), np.zeros(0, dtype=np.int32))
        self.assertEqual(counted(self.nodes.root)[1], 0)

    def test_lit_triangles_are_drawn_again_with_outlines(self):
        self.nodes.show(TWO)
        self.nodes.light_up(TWO[:1])
        self.assertEqual(counted(self.nodes.root)[1], 3)
        self.nodes.show(TWO)
        self.assertEqual(counted(self.nodes.root)[1], 0)

    def test_coarse_triangles_while_the_camera_moves(self):
        self.nodes.show(TWO)
        self.nodes.show_coarse(TWO[:1])
        for moves, triangles in ((True, 1), (False, 2)):
            self.nodes.moving(moves)
            self.assertEqual(counted(self.nodes.root)[0], triangles)

    def test_each_triangle_has_a_colour(self):
        self.nodes.show(TWO)
        with self.assertRaises(ValueError):
            self.nodes.colour(np.zeros((3, 4), dtype=np.uint8))

    def test_colours_are_weakly_shaded(self):
        shaded = ShadedTriangles()
        flat = np.array([[(0, 0, 0), (1, 0, 0), (2, 0, 0)]], dtype=np.float32)  # without a normal
        shaded.show(np.concatenate((TWO, TWO[:, ::-1], flat)))
        shaded.colour(np.tile(np.array((200, 100, 0, 77), dtype=np.uint8), (5, 1)))
        field = shaded.node.getChild(2).vertexProperty.getValue().orderedRGBA
        found = np.array([list(value.to_bytes(4, "big")) for value in (int(field[i]) for i in range(5))])
        self.assertEqual(found[:, 3].tolist(), [77] * 5)
        self.assertEqual(found[4, :3].tolist(), [200, 100, 0])
        np.testing.assert_allclose(found[:2, 0], 200 * (0.65 + 0.175 * 1.753), atol=1.0)
        np.testing.assert_allclose(found[2:4, 0], 200 * (0.65 + 0.175 * 0.247), atol=1.0)


class Legends(unittest.TestCase):
    def setUp(self):
        self.legend = LegendNode()

    def test_it_goes_again(self):
        self.legend.show(picture(20, 30), TOP_RIGHT, 0)
        self.assertEqual(self.legend.node.getNumChildren(), 1)
        self.legend.show(picture(0, 0), TOP_RIGHT, 0)
        self.assertEqual(self.legend.node.getNumChildren(), 0)

    def test_at_the_right_and_in_the_middle(self):
        self.legend.show(picture(100, 200), TOP_RIGHT, 0)
        self.assertEqual(self.legend.place_in(800, 600), (690, 200))

    def test_it_leaves_a_corner_free(self):
        width, height, reach = 100, 200, 150
        for high in (600, 400, 300, 220):
            for corner in (TOP_LEFT, TOP_RIGHT, BOTTOM_LEFT, BOTTOM_RIGHT):
                with self.subTest(high=high, corner=corner):
                    self.legend.show(picture(width, height), corner, reach)
                    left, low = self.legend.place_in(800, high)
                    at_left, at_top = corner in (TOP_LEFT, BOTTOM_LEFT), corner in (TOP_LEFT, TOP_RIGHT)
                    beside = left >= reach if at_left else left + width <= 800 - reach
                    above_or_below = low + height <= high - reach if at_top else low >= reach
                    self.assertTrue(beside or above_or_below)
                    self.assertTrue(left >= 0 and low >= 0 and left + width <= 800 and low + height <= high)


class InTheView(gui_helpers.GuiTest):
    def setUp(self):
        super().setUp()
        Part.show(Part.makeBox(10, 10, 10))
        self.view = FreeCADGui.activeDocument().activeView()
        self.view.viewAxonometric()
        self.view.fitAll()
        gui_helpers.wait()
        self.legend = LegendNode()
        self.legend.show(picture(100, 200), TOP_RIGHT, 0)
        graph = self.view.getSceneGraph()
        graph.addChild(self.legend.node)
        self.addCleanup(graph.removeChild, self.legend.node)

    def white(self, name):
        """How many pixels of the place of the legend are as white as it is."""
        left, low = self.legend.place_in(gui_helpers.WIDTH, gui_helpers.HEIGHT)
        rows = self.saved(name, background="Black")
        there = rows[gui_helpers.HEIGHT - low - 200:gui_helpers.HEIGHT - low, left:left + 100]
        return int((there.min(axis=2) == 255).sum())

    def test_fit_all_does_not_see_it(self):
        action = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(400, 300))
        action.apply(self.legend.node)
        self.assertTrue(action.getBoundingBox().isEmpty())
        before = self.view.getCameraNode().position.getValue().getValue()
        self.view.fitAll()
        np.testing.assert_allclose(self.view.getCameraNode().position.getValue().getValue(), before, rtol=1e-4)

    def test_clipping_planes_do_not_cut_it(self):
        self.assertEqual(self.white("legend_whole"), 20000)
        self.view.toggleClippingPlane(1, False, True, FreeCAD.Placement(FreeCAD.Vector(5, 5, 5), FreeCAD.Rotation()))
        self.addCleanup(self.view.toggleClippingPlane, 0)
        gui_helpers.wait(0.3)
        self.assertEqual(self.white("legend_clipped"), 20000)

    def test_it_is_not_picked(self):
        left, low = self.legend.place_in(*self.view.getSize())
        self.assertIsNone(self.view.getObjectInfo((left + 50, low + 100)))
