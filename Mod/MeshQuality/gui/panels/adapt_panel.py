# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Adapt mesh: what is asked for, and the error over the unknowns, step by step."""

import FreeCAD
from PySide import QtCore, QtGui

from ... import options
from ...features import adapted_mesh
from .. import jobs
from ..document_thread import DocumentThread
from ..panel_operation import obstacle_in
from ..quantities import count_text, length_text
from .convergence_plot import ConvergencePlot
from .option_form import OptionForm
from .task_form import Table, is_in_task_view, narrow
from .writing_panel import WritingPanel

translate = FreeCAD.Qt.translate


class AdaptPanel(WritingPanel):
    """OK adapts, step by step; each that is better than those before is in the document at once, as one undo step. The panel stays open
    with the plot and the table; Cancel ends the work, and the last good step stays.

    source  an analysis
    """

    COMMAND, TITLE = "MeshQuality_Adapt", "Adapt mesh"
    STAYS = True

    def add_fields(self, layout):
        self.options = OptionForm(options.adapt.ADAPT)
        self.plot, self.table, self.doing = ConvergencePlot(), Table(0, 3), QtGui.QLabel()
        self.table.setHorizontalHeaderLabels([translate("MeshQuality", "Unknowns"), translate("MeshQuality", "Error"),
                                              translate("MeshQuality", "Size")])
        self.table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.table.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.Stretch)
        self.table.horizontalHeader().setSectionResizeMode(0, QtGui.QHeaderView.ResizeToContents)
        self.table.verticalHeader().hide()
        narrow(self.table, "QHeaderView::section { padding: 0px }")
        self.table.setSizeAdjustPolicy(QtGui.QAbstractScrollArea.AdjustToContents)
        of = QtGui.QLabel(translate("MeshQuality", "Analysis: {}").format(self.label))
        for label in (of, self.doing):
            label.setWordWrap(True)
        layout.addWidget(of)
        self.add_work(layout)
        for widget in (self.doing, self.options, self.plot, self.table):
            layout.addWidget(widget)
        self.fields = (self.options,)
        self._show_steps(adapted_mesh.steps_in(self.obj))

    def _show_steps(self, steps):
        self.plot.show_steps([(unknowns, error) for _, unknowns, _, error, _ in steps], self.options.values()["target_error"])
        self.table.setRowCount(len(steps))
        for row, (_, unknowns, _, error, size) in enumerate(steps):
            for column, text in enumerate((count_text(unknowns), f"{100 * error:.3g} %", length_text(size))):
                item = QtGui.QTableWidgetItem(text)
                item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
                self.table.setItem(row, column, item)
        self.plot.setVisible(bool(steps))
        self.table.setVisible(bool(steps))

    def prepare(self):
        values = options.check(options.adapt.ADAPT, self.options.values())
        thread = DocumentThread(lambda: obstacle_in(self.document))

        def in_document(progress, function):
            def run():
                result = function()
                if is_in_task_view(self.form):
                    self._show_steps(adapted_mesh.steps_in(self.obj))
                return result

            return thread.call(run, progress)

        def work(progress):
            return adapted_mesh.adapt_analysis(self.obj, **values, progress=progress,
                                               in_document=lambda function: in_document(progress, function)).stopped

        return work, self._land

    def _land(self, stopped):
        self.ended_with = {
            "target": translate("MeshQuality", "The error is below the target."),
            "unknowns": translate("MeshQuality", "A finer mesh would have more unknowns than allowed."),
            "steps": translate("MeshQuality", "All steps are done; the error is above the target."),
            "no fall": translate("MeshQuality", "The error does not get lower any more."),
        }[stopped]

    @staticmethod
    def said_of_cancelling():
        return translate("MeshQuality", "Cancelled; the last good step stays.")

    def _tell(self):
        if self.job is not None and is_in_task_view(self.form):
            self.doing.setText(self.job.doing)

    def _ended(self):
        job = self.job
        super()._ended()
        if is_in_task_view(self.form):
            self.doing.setText("")
            if job.state == jobs.DONE:
                self.say(" ".join((self.ended_with, translate("MeshQuality", "Solve the analysis once more for its results."))))
