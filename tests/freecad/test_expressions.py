# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of document objects that are bound to expressions."""

import helpers

import MeshQuality as mq


class Expressions(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.source = self.box()
        self.mesh = mq.add_quality_mesh(self.source)

    def bind(self, name, expression):
        self.mesh.setExpression(name, expression)
        self.document.recompute()

    def refused(self, words, **values):
        held = self.mesh.Fingerprint, self.mesh.Mesh.CountFacets
        with self.assertRaises(mq.Error) as caught:
            mq.update(self.mesh, **values)
        for word in (*words, "'Box quality mesh'", "clear that first", "setExpression("):
            self.assertIn(word, str(caught.exception))
        self.assertEqual((self.mesh.Fingerprint, self.mesh.Mesh.CountFacets), held)
        self.assertFalse(self.document.HasPendingTransaction)

    def test_update_does_not_pretend_to_change_them(self):
        self.bind("MaxEdge", "Box.Length / 5")
        self.assertEqual(self.mesh.MaxEdge.Value, 2.0)
        self.refused(("max_edge", "MaxEdge", "Box.Length / 5"), max_edge=1.0)
        self.refused(("max_edge", "MaxEdge"), max_edge=None)

    def test_other_options_can_be_changed(self):
        self.bind("MaxEdge", "Box.Length / 5")
        mq.update(self.mesh, min_angle=20.0)
        self.assertEqual((self.mesh.MinAngle.Value, self.mesh.MaxEdge.Value), (20.0, 2.0))
        mq.update(self.mesh, max_edge=2.0)  # what it is
        self.source.Length = 20.0
        self.document.recompute()
        self.assertEqual(self.mesh.MaxEdge.Value, 4.0)

    def test_after_the_expression_was_cleared(self):
        self.bind("MaxEdge", "Box.Length / 5")
        self.mesh.setExpression("MaxEdge", None)
        mq.update(self.mesh, max_edge=1.0)
        self.document.recompute()
        self.assertEqual(self.mesh.MaxEdge.Value, 1.0)

    def test_the_bound_on_the_distance_by_either_of_its_values(self):
        self.bind("ChordHeight", "Box.Length / 100")
        self.assertEqual((self.mesh.DistanceBound, self.mesh.ChordHeight.Value), ("Absolute", 0.1))
        for values in ({"chord_height": 0.2}, {"chord_height_relative": 0.01}, {"chord_height": "none"}):
            self.refused(("ChordHeight", "Box.Length / 100"), **values)

    def test_older_names_and_other_spellings(self):
        self.bind(".Growth", "1 + 1 / 2")
        self.assertEqual(self.mesh.GrowthRate, 1.5)
        self.refused(("growth_rate", "Growth"), growth_rate=2.0)

    def test_every_kind_of_object(self):
        other = self.document.addObject("Part::Sphere", "Sphere")
        self.document.recompute()
        for obj, name, values in ((mq.add_curved_mesh(self.source), "MinAngle", {"min_angle": 15.0}),
                                  (mq.add_boolean(self.source, other), "Tolerance", {"tolerance": 0.5}),
                                  (mq.add_improved_mesh(self.mesh), "FeatureAngle", {"feature_angle": 20.0})):
            with self.subTest(name):
                obj.setExpression(name, "10 * 1")
                obj.recompute()
                with self.assertRaisesRegex(mq.Error, f"the property {name} of .* is set by the expression 10 "):
                    mq.update(obj, **values)
