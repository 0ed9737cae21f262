# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyse Quality: which range of values the colours and the histogram show, and bars that are chosen together."""

import gui_helpers
import numpy as np
import Part
import test_quality_view
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality.gui import quality_data
from MeshQuality.gui.panels import quality_panel


class Range(gui_helpers.GuiTest):
    def open(self, shape):
        source = self.document.addObject("Part::Feature", "Part")
        source.Shape = shape
        self.document.recompute()
        panel = quality_panel.open_panel(mq.add_quality_mesh(source, chord_height=0.05))
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        return panel

    def choose(self, panel, measure):
        panel.measures.setCurrentIndex(panel.data.measures.index(measure))
        self.until(lambda: panel.measure is measure)

    def test_bars_that_the_mouse_is_drawn_over_light_up(self):
        panel = self.open(Part.makeCone(1, 5, 9))
        view, counts = panel.histogram, panel.histogram.counts
        step = view.width() / len(counts)
        for kind, bar in ((QtCore.QEvent.MouseButtonPress, 18), (QtCore.QEvent.MouseMove, 25), (QtCore.QEvent.MouseMove, 30),
                          (QtCore.QEvent.MouseButtonRelease, 30)):
            QtGui.QApplication.sendEvent(view, QtGui.QMouseEvent(
                kind, QtCore.QPointF((bar + 0.5) * step, 20), QtCore.Qt.LeftButton, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier))
        self.assertEqual((view.chosen, view.last, panel.lit.sum()), (18, 30, counts[18:31].sum()))
        self.assertGreater(panel.lit.sum(), counts[18])
        self.assertRegex(panel.hint.text(), rf"^{counts[18:31].sum():,} from 27° to 46\.5°")

    def test_the_range_of_colours_is_seen_and_chosen(self):
        panel = self.open(Part.makeCone(1, 5, 9))
        self.assertEqual((panel.range.low.text(), panel.range.high.text(), panel.range.unit.text()), ("0", "60", "°"))
        before = self.picture("quality_whole_range")
        self.write(panel.range.low, "40")
        self.assertEqual((panel.scale.low, panel.scale.high), (40.0, 60.0))
        np.testing.assert_array_equal(panel.scale.goodness(np.array([30.0, 40.0, 50.0, 60.0])), [0.0, 0.0, 0.5, 1.0])
        self.assertEqual(panel.histogram.counts.sum(), panel.data.elements)
        self.assertEqual(panel.histogram.counts[0], (panel.values < 40.5).sum())
        self.assertGreater(test_quality_view.share_of(self.picture("quality_own_range"), (217, 26, 26)), 2 * test_quality_view.share_of(before, (217, 26, 26)))
        for wrong in ("x", "60", "70"):
            self.write(panel.range.low, wrong)
            self.assertEqual((panel.range.low.text(), panel.scale.low), ("40", 40.0))
        self.choose(panel, quality_data.DISTANCE)
        self.write(panel.range.high, "0.2 mm")
        self.assertAlmostEqual(panel.scale.high, 0.2)
        self.assertEqual(panel.scale.goodness(np.array([0.0, 0.1, 0.2])).tolist(), [1.0, 0.5, 0.0])
        self.choose(panel, quality_data.MIN_ANGLE)
        self.assertEqual(panel.range.low.text(), "40")
        panel.range.reset.click()
        self.assertEqual((panel.scale.low, panel.range.low.text(), panel.range.reset.isEnabled()), (0.0, "0", False))
        self.assertLess(np.abs(self.picture("quality_reset") - before).mean(), 0.5)

    def write(self, field, text):
        field.setText(text)
        field.editingFinished.emit()
