# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Analyse Quality: how good a mesh is, where it is worst, and why."""

from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Optional

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from ... import fault_phrases, phrases
from ...compat import flags
from ...core import colour_scale
from ...core.sources import convert, frames
from ...errors import Error
from .. import jobs, visibility
from ..fem_quality_data import FemQualityData
from ..quality_data import DEVIATION, DISTANCE, THICKNESS, Histogram, QualityData, Scale
from ..quantities import count_text
from ..section_data import SectionData
from ..translation import translated
from ..view import badge
from ..view.quality_scene import QualityScene
from .faults_box import AROUND, FaultsBox
from .histogram import HistogramView
from .mesh_panel import title_of
from .range_box import RangeBox
from .saving_box import SavingBox
from .section_box import SectionBox
from .task_form import Form, Message, Table, keep_choices, narrow

translate = FreeCAD.Qt.translate

WORST = 50  # elements in the list
_DIGITS = 3  # digits of the numbers in the table, which may be 230 pixels wide
_LISTS = 180  # pixels: height of the lists, which scroll, so that the whole panel is seen on a low screen
_AROUND_INSIDE = 10.0  # width of the view around an element inside, in sizes of it


@dataclass(frozen=True)
class _Found:
    """The values and figures of a measure that the panel shows.

    values     float64 (E,)
    scale      Scale of them
    of_all     (worst, mean) of all tetrahedra, of which the elements are those at the surface; None
               where the elements are all there are
    whole      float64, the values of all elements that a section cuts
    colours    uint8 (T, 4), of the triangles that are drawn
    coarse     uint8 (n, 4), of the coarse ones; None without them
    histogram  Histogram
    faces      [FaceRow, ...]
    worst      indices of the worst elements
    """

    values: np.ndarray
    scale: Scale
    of_all: Optional[tuple]
    whole: np.ndarray
    colours: np.ndarray
    coarse: Optional[np.ndarray]
    histogram: Histogram
    faces: list
    worst: np.ndarray


class QualityPanel:
    """A panel for FreeCADGui.Control.showDialog. The mesh and all else that is seen in its place are hidden while it is
    shown in colour.

    source   a document object with a mesh, or a link to one, see frames
    measure  the Measure that is shown first; None: the first one
    """

    def __init__(self, source, measure=None):
        self.obj = frames.object_of(source)
        self._document, self._label = self.obj.Document.Name, frames.leaf_of(source).Label
        self.data = (QualityData if convert.is_mesh(source) else FemQualityData)(source)
        self.values = self.measure = self.scale = None
        self.lit = None  # by element: whether it is lit up
        self.ended = False
        self._found = {}  # values by title of the measure
        self._own_ranges = {}  # the range that the user has chosen by title of the measure
        self._job = None
        self._make_form(source, measure)
        self.measures.setCurrentIndex(self.data.measures.index(measure) if measure in self.data.measures else 0)
        view = FreeCADGui.getDocument(self._document).activeView()
        self.scene = QualityScene(view)
        self.section.watch(self.scene)
        self.section.changed.connect(lambda: self._light_up(self.lit))
        self._source, self._hidden = source, None
        FreeCAD.addDocumentObserver(self)
        self._choose_measure()
        self.measures.currentIndexChanged.connect(self._choose_measure)

    def _make_form(self, source, measure):
        self.form = Form()
        measure = measure or self.data.measures[0]
        self.form.setWindowTitle(_title(measure))
        self.form.setWindowIcon(QtGui.QIcon(badge.path_of(_command(measure)[0])))
        of, self.summary = QtGui.QLabel(
            translate("MeshQuality", "Mesh: {0}").format(self._label)), QtGui.QLabel()
        self.measures, self.histogram, self.range = QtGui.QComboBox(), HistogramView(), RangeBox()
        self.meaning, self.hint, self.warning = QtGui.QLabel(), QtGui.QLabel(_hint()), Message()
        self.worst, self.faces = QtGui.QListWidget(), Table(0, 4)
        self.edges = QtGui.QCheckBox(translate("MeshQuality", "Draw edges"))
        self.edges.setEnabled(False)
        self.section = SectionBox(lambda: SectionData(self.data))  # its box to check stands beside that of the edges
        for measure in self.data.measures:
            self.measures.addItem(translate("MeshQuality", measure.title))
        keep_choices(self.measures)
        for label in (of, self.meaning, self.summary, self.hint):
            label.setWordWrap(True)
        self.worst.setWordWrap(True)
        self.worst.setAlternatingRowColors(True)
        self._lay_out_faces()
        self.tabs = QtGui.QTabWidget()
        self.tabs.setMaximumHeight(_LISTS)
        narrow(self.tabs.tabBar(), "QTabBar::tab { min-width: 0px; padding: 3px 4px }")
        self.tabs.addTab(self.worst, translate("MeshQuality", "Worst"))
        self.tabs.addTab(self.faces, translate("MeshQuality", "Faces"))
        self.faults = FaultsBox()
        if not self.data.curved:
            self.tabs.addTab(self.faults, translate("MeshQuality", "Faults"))
        self.saving = SavingBox(source, self._label, self._save_values)
        layout = QtGui.QVBoxLayout(self.form)
        layout.setContentsMargins(0, 0, 0, 0)
        boxes = QtGui.QHBoxLayout()
        for box in (self.edges, self.section.on):
            boxes.addWidget(box)
        for widget in (of, self.measures, self.meaning, self.summary, self.warning, self.histogram, self.range, self.hint):
            layout.addWidget(widget)
        layout.addLayout(boxes)  # above the lists, where it is seen on a low screen
        for widget in (self.section, self.tabs, self.saving):
            layout.addWidget(widget)
        self._show_numbers(False)
        self.histogram.picked.connect(self._pick_bar)
        self.range.chosen.connect(self._choose_range)
        self.faults.picked.connect(self._pick_faults)
        self.faults.searched.connect(self._name_faults)
        self.worst.currentRowChanged.connect(self._pick_worst)
        self.worst.itemClicked.connect(lambda _: self._pick_worst(self.worst.currentRow()))
        self.faces.itemSelectionChanged.connect(self._pick_face)
        self.edges.toggled.connect(self._draw_edges)
        self.saving.told.connect(lambda text, error: self.warning.say(text, error=error))

    def _lay_out_faces(self):
        self.faces.setHorizontalHeaderLabels([
            translate("MeshQuality", "Face"), translate("MeshQuality", "Count"),
            translate("MeshQuality", "Worst"), translate("MeshQuality", "Mean")])
        self.faces.verticalHeader().hide()
        self.faces.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.faces.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        self.faces.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
        self.faces.horizontalHeader().setMinimumSectionSize(0)
        self.faces.horizontalHeader().setSectionResizeMode(0, QtGui.QHeaderView.Stretch)
        self.faces.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        for column in range(4):
            self.faces.horizontalHeaderItem(column).setTextAlignment(_alignment(column))
        narrow(self.faces, "QHeaderView::section { padding: 0px } QTableView::item { padding: 0px }")

    def getStandardButtons(self):
        return flags(QtGui.QDialogButtonBox.Close)

    def reject(self):
        """Close: the view is as it was before."""
        self._end()
        FreeCADGui.Control.closeDialog()
        return True

    def slotDeletedDocument(self, document):
        """FreeCAD closes a document."""
        if document.Name == self._document:
            self._end(gone=True)
            FreeCADGui.Control.closeDialog()

    def slotDeletedObject(self, obj):
        """An object goes."""
        if obj is self.obj:
            self._end()
            FreeCADGui.Control.closeDialog()

    def _end(self, gone=False):
        if self.ended:
            return
        self.ended = True
        FreeCAD.removeDocumentObserver(self)
        for box in (self.faults, self.saving, self.section):
            with suppress(RuntimeError):  # FreeCAD 1.0 has closed the panel by itself, and deleted what it showed
                box.end()
        if self._job is not None and self._job.active:
            self._job.cancel()
        if gone:
            return
        self.scene.close()
        if self._hidden is not None:
            self._hidden.end()

    def _choose_measure(self, *_):
        measure = self.data.measures[self.measures.currentIndex()]
        if self._job is not None and self._job.active:
            self._job.cancel()
        if measure.title in self._found:
            self._show(measure, self._found[measure.title])
            return
        self._measuring()
        if len(jobs.queue()):
            self._say(translate("MeshQuality", "Measuring starts when other work has finished."))
        self._job = jobs.queue().add(jobs.Job(
            translate("MeshQuality", measure.title), lambda progress: self._compute(measure, progress),
            lambda found: self._take(measure, found), quiet=True, prepare=self._measuring))
        job = self._job
        job.changed.connect(lambda: self._tell(job))
        job.ended.connect(lambda: job.error and not self.ended and self._fail(translated(job.error)))

    def _fail(self, text):
        """There are no numbers to show: only why."""
        self._say(text[:1].upper() + text[1:])
        self._show_numbers(False)

    def _show_numbers(self, shown):
        for widget in (self.histogram, self.range, self.hint, self.section.on, self.saving):
            widget.setVisible(shown)
        for page in (self.worst, self.faces):  # one that is behind another would be drawn beside it
            page.setVisible(shown and page is self.tabs.currentWidget())
        self.section.setVisible(shown and self.section.on.isChecked())

    def _tell(self, job):
        if job is self._job and job.active and (job.fraction or job.wait):
            measuring = translate("MeshQuality", "Measuring: {0} %").format(round(100 * job.fraction))
            self._say("\n".join(filter(None, (measuring, job.wait, job.time))))

    def _measuring(self):
        self._say(translate("MeshQuality", "Measuring ..."))

    def _compute(self, measure, progress):
        self.data.prepare()
        if len(self.data.corners) <= visibility.MOST_WITH_EDGES:
            _ = self.data.lines
        whole = values = np.asarray(measure.values(self.data, progress))
        scale, of_all = self.data.scale(measure, values), None
        if self.data.tetrahedra:
            whole = np.asarray(measure.of_all(self.data, progress))
            of_all = whole[measure.order(whole)[0]], _mean(whole)
        colours = colour_scale.bytes_of(scale.goodness(values))[self.data.element]
        coarse = None if self.data.coarse is None else self.data.coarse_colours(colours)
        order = measure.order(values)
        return _Found(values, scale, of_all, whole, colours, coarse, Histogram.of(values, scale),
                      self.data.faces(values, measure), order[~np.isnan(values[order])][:WORST])

    def _take(self, measure, found):
        if not self._found and not self.data.curved:
            self.faults.begin(self.data.faults)
        if not self._found:
            self._hidden = visibility.Hidden(self._source)
            self.scene.show(self.data)
            self.edges.setChecked(len(self.data.corners) <= visibility.MOST_WITH_EDGES)
            self.edges.setEnabled(True)
        self._found[measure.title] = found
        self._show(measure, found)

    def _show(self, measure, found):
        found = self._within_range(measure, found)
        self.measure, self.values, self._bars, self._whole = measure, found.values, found.histogram, found.whole
        self._worst, self.scale = found.worst, found.scale
        self._show_numbers(True)
        self.meaning.setText(self._meaning(measure))
        self._say(self._summary(found))
        self.histogram.show_histogram(found.histogram, found.scale)
        self.range.show_scale(found.scale, measure.title in self._own_ranges)
        self.hint.setText(_hint())
        self._list_worst()
        self._list_faces(found.faces)
        self.scene.colour(found.colours, found.coarse, found.scale)
        self._light_up(self.data.marked(measure, found.values))

    def _within_range(self, measure, found):
        """What was found of a measure, in the colours of the range that the user has chosen for it."""
        if measure.title not in self._own_ranges:
            return found
        scale = found.scale.within(*self._own_ranges[measure.title])
        colours = colour_scale.bytes_of(scale.goodness(found.values))[self.data.element]
        coarse = None if self.data.coarse is None else self.data.coarse_colours(colours)
        return replace(found, scale=scale, colours=colours, coarse=coarse, histogram=Histogram.of(found.values, scale))

    def _choose_range(self, ends):
        if ends is None:
            self._own_ranges.pop(self.measure.title, None)
        else:
            self._own_ranges[self.measure.title] = ends
        self._show(self.measure, self._found[self.measure.title])

    def _meaning(self, measure):
        words = translate("MeshQuality", measure.help)
        if measure is DEVIATION:
            return words + " " + translate("MeshQuality", "The colours end at ± {0}.").format(self.scale.text(self.scale.high))
        if measure is not DISTANCE or measure.title in self._own_ranges:
            return words
        if self.data.bound is None:
            return words + " " + translate("MeshQuality", "Red: the largest distance of this mesh.")
        return words + " " + translate("MeshQuality", "Red: more than the requested {0}.").format(
            self.scale.text(self.data.bound))

    def _summary(self, found):
        text = found.scale.text
        worst, mean = text(found.values[found.worst[0]]), text(_mean(found.values))
        if found.of_all is not None:
            everything = translate("MeshQuality", "{0} tetrahedra: worst {1}, mean {2}")
            shown = translate("MeshQuality", "Shown are the {0} at the surface: worst {1}, mean {2}")
            inside = translate("MeshQuality", "A clipping plane shows the surface only; click one of the worst to look inside.")
            return "\n".join((everything.format(count_text(self.data.tetrahedra), *map(text, found.of_all)),
                              shown.format(count_text(self.data.shown), worst, mean), inside))
        words = translate("MeshQuality", "{0} elements: worst {1}, mean {2}") if self.data.curved \
            else translate("MeshQuality", "{0} triangles: worst {1}, mean {2}")
        words = words.format(count_text(self.data.elements), worst, mean)
        unbounded = translate("MeshQuality", "∞, grey: {0} of them").format(count_text(found.scale.unbounded)) \
            if found.scale.unbounded else ""
        return "\n".join(filter(None, (words, unbounded, self.data.remark())))

    def _list_worst(self):
        self.worst.blockSignals(True)
        self.worst.clear()
        for element in self._worst:
            text = f"{self.scale.text(self.values[element])}: {self.data.place(element)}"
            reason = translated(self.data.reason(element))
            item = QtGui.QListWidgetItem(text + (f"\n{reason}" if reason else ""))
            item.setToolTip(reason or translate("MeshQuality", "Click to move the camera there"))
            self.worst.addItem(item)
        self.worst.blockSignals(False)

    def _list_faces(self, faces):
        self._faces = faces
        unit = self.scale.unit.strip()
        self.tabs.setTabText(1, translate("MeshQuality", "Patches") if self.data.patches else translate("MeshQuality", "Faces"))
        mean = translate("MeshQuality", "Mean")
        self.faces.horizontalHeaderItem(3).setText(f"{mean}\n[{unit}]" if unit else mean)
        self.faces.blockSignals(True)
        self.faces.setRowCount(len(faces))
        for i, row in enumerate(faces):
            texts = (row.name, count_text(row.elements), self.scale.number(row.worst, _DIGITS),
                     self.scale.number(row.mean, _DIGITS))
            for k, text in enumerate(texts):
                item = QtGui.QTableWidgetItem(text)
                item.setTextAlignment(_alignment(k))
                item.setToolTip(text)
                self.faces.setItem(i, k, item)
        self.faces.blockSignals(False)

    def _pick_bar(self, bar, last):
        chosen = (self._bars.bar >= bar) & (self._bars.bar <= last) & (self._bars.bar >= 0)
        self.hint.setText(self.histogram.words(bar, last) if bar >= 0 else _hint())
        self._light_up(chosen)

    def _pick_worst(self, row):
        if row < 0:
            return
        chosen = np.zeros(self.data.elements, dtype=bool)
        chosen[self._worst[row]] = True
        self._light_up(chosen)
        corners = self.data.triangles_of(chosen)
        if not self.data.is_inside(self._worst[row]):
            self.scene.fly_to(corners)
            return
        if self.section.plane is None:
            self.scene.open_before(corners)
        else:
            self.section.through(self.section.data.centre(self._worst[row]))
        self.scene.fly_to(corners, _AROUND_INSIDE)

    def _pick_face(self):
        rows = {index.row() for index in self.faces.selectedIndexes()}
        self._light_up(np.isin(self.data.group, [self._faces[row].face for row in rows]))

    def _name_faults(self, found):
        if found:
            words = phrases.Text(fault_phrases.HAS_FAULTS, list=[faults.words() for faults in found])
            self.warning.say(translated(phrases.sentence(words)), error=True, scroll=False)

    def _pick_faults(self, chosen, place):
        lit = np.zeros(self.data.elements, dtype=bool)
        lit[chosen] = True
        self._light_up(lit)
        if len(place):
            self.scene.fly_to(self.data.corners[place], AROUND)

    def _light_up(self, chosen):
        self.lit = chosen
        self.scene.close_again()
        self.scene.light_up(self.data.triangles_of(chosen))
        if self.section.plane is not None:
            self._cut(self.section.plane)

    def _cut(self, plane):
        """Draws the half of the mesh behind a plane, in the colours of its elements; those that are lit up stay so."""
        whole, data = self.section.whole.isChecked(), self.section.data
        drawn = data.whole(plane) if whole else data.cut(plane)
        values = np.append(self._whole, np.nan)[drawn.element]  # the last one: of no element
        colours = colour_scale.bytes_of(np.where(np.isnan(values), np.nan, self.scale.goodness(values)))
        lines = drawn.lines if self.edges.isChecked() else None
        is_lit = np.append(self.lit, False)[drawn.element] if len(self.lit) == len(self._whole) else np.zeros(len(values), dtype=bool)
        if whole:
            self.scene.show_part(drawn.corners, colours, lines)
            self.scene.light_up(drawn.corners[is_lit])
        else:
            self.scene.clip(plane, drawn.corners, colours, is_lit, lines)

    def _draw_edges(self, *_):
        if not self.edges.isChecked() or self.data.has_lines:
            self.scene.draw_edges(self.data, self.edges.isChecked())
            if self.section.plane is not None:
                self._light_up(self.lit)
            return
        jobs.queue().add(jobs.Job(
            translate("MeshQuality", "Draw edges"), lambda progress: self.data.lines, lambda lines: self._draw_edges(),
            lambda: not self.ended and self.edges.isChecked(), quiet=True))

    def _save_values(self, path):
        """Writes the table of all measures, with what else was shown; any thread may call it."""
        table, shown = self.data.table, {title: found.values for title, found in self._found.items()}
        table.write_csv(path, {title: values for title, values in shown.items() if len(values) == len(table)})

    def _say(self, text):
        self.summary.setText(text)


def _mean(values):
    """The mean of the values that are finite."""
    finite = values[np.isfinite(values)]
    return finite.mean() if len(finite) else values[0]


def _hint():
    return translate("MeshQuality", "Click or drag over bars to highlight; heights are logarithmic.")


_shown = None


def _alignment(column):
    """How the cells of a column of the table of faces, and its header, are aligned: names on the left, numbers on the right."""
    return int((QtCore.Qt.AlignRight if column else QtCore.Qt.AlignLeft) | QtCore.Qt.AlignVCenter)


def _command(measure):
    """The name and the text of the command that begins with this measure."""
    if measure is DEVIATION:
        return "MeshQuality_Deviation", "Deviation"
    return ("MeshQuality_Thickness", "Wall thickness") if measure is THICKNESS else ("MeshQuality_Analyse", "Analyse quality")


def _title(measure):
    return title_of(*_command(measure))


def shown():
    """The panel that is open; None without one."""
    return _shown if _shown is not None and not _shown.ended else None


def open_panel(source, measure=None):
    """Opens the panel for a mesh, with this measure or the first one; what is wrong with it goes to the report view."""
    try:
        panel = QualityPanel(source, measure)
    except (Error, ImportError) as error:
        FreeCAD.Console.PrintError(f"{frames.leaf_of(source).Label}: {translated(error)}\n")
        QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(),
                                  _title(measure), translated(error))
        return None
    FreeCADGui.Control.showDialog(panel)
    global _shown
    _shown = panel
    return panel
