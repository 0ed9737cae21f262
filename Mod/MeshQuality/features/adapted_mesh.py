# SPDX-License-Identifier: LGPL-2.1-or-later
"""adapt for functions and for analyses of the document, which CalculiX solves."""

import os
import subprocess

import FreeCAD
import numpy as np

from .. import label_phrases, options
from ..core import adapting
from ..core.sizes.mesh_values import of_frd
from ..core.sources import convert, frames
from ..errors import Cancelled, Error, InvalidInput
from ..phrases import Text
from . import fem_groups, size_fields
from .fem_groups import is_analysis
from .fem_mesh import FemMeshObject
from .gui_hooks import window
from .mesh_object import with_precomputed
from .properties import options_of
from .transactions import undo_step, update

TABLE = "Adaptation"  # name of the spreadsheet
COLUMNS = "Step", "Unknowns", "Elements", "Error", "Least size"
_POLL = 0.1  # seconds between two looks at CalculiX


def adapt(problem, shape=None, target_error=0.05, max_unknowns=200_000, steps=8, order=None, size_field=None, progress=None,
          strains=False, **values):
    """A mesh of tetrahedra that is refined where the error of a solution is, until that is small enough.

    problem       function(mesh) that solves on a CurvedMesh and returns values at mesh.nodes: (N,), or (N, k) of k components;
                  or a Fem::FemAnalysis whose mesh add_fem_mesh made, which CalculiX solves: the error of the strains counts
    shape         of a function: Part.Shape with solids, or a document object that has one
    target_error  relative error in the norm of the gradient, as estimated: 0.05 is 5 %
    max_unknowns  nodes times components: no mesh is made that is expected to have more
    steps         most meshes that are made
    order         of the elements, 1 or 2; None: that of the analysis, else 2
    size_field    bounds sizes in all steps, as for triangulate; values: further options of curve
    strains       of a function that returns displacements (N, 3): the error of the strains counts, as for an analysis
    progress      callable(fraction 0..1, stage); returning False cancels

    The error is estimated by superconvergent patch recovery (Zienkiewicz and Zhu 1992); new sizes are those of the mesh with the
    fewest elements for the target, changed by a factor of 2 at most. Returns an Adaptation. The mesh of an analysis gets each mesh whose
    error is the least until then, with its sizes as SizeField, as one undo step each; where the work is cancelled it keeps the last.
    A spreadsheet "Adaptation" has the steps. Raises InvalidInput naming the argument; what curve and the solver raise.
    """
    if not is_analysis(problem):
        if shape is None:
            raise InvalidInput("shape= is needed: what the function solves on is a mesh of it")
        return adapting.adapt(problem, shape, target_error, max_unknowns, steps, 2 if order is None else order, size_field, progress,
                              strains, **values)
    if shape is not None or values:
        raise InvalidInput("the shape and the options of an analysis are those of its mesh: leave shape= and others out")
    return adapt_analysis(problem, target_error, max_unknowns, steps, order, size_field, progress)


def mesh_of_analysis(analysis):
    """The mesh of add_fem_mesh in an analysis; None without one."""
    return next((member for member in analysis.Group if isinstance(getattr(member, "Proxy", None), FemMeshObject)), None)


def adapt_analysis(analysis, target_error, max_unknowns, steps, order=None, size_field=None, progress=None,
                   in_document=lambda function: function()):
    """As adapt; in_document(function) calls it where documents may be changed, and returns what it returns."""
    adapted = in_document(lambda: AnalysisOnMeshes(analysis, order, progress, in_document, size_field))
    found = adapting.adapt(adapted.solve, adapted.shape, target_error, max_unknowns, steps, adapted.values["order"], adapted.bounds,
                           progress, True, adapted.keep, **adapted.options)
    in_document(lambda: adapted.show_table(found))
    return found


class AnalysisOnMeshes:
    """An analysis that is solved on one mesh after the other while it is adapted.

    values   its options; options: those of curve, but for the order and the sizes
    bounds   size_field in the frame of its mesh
    """

    def __init__(self, analysis, order, progress, in_document, size_field=None):
        self._analysis, self._obj, self._progress, self._in_document = analysis, mesh_of_analysis(analysis), progress, in_document
        if self._obj is None:
            raise InvalidInput(f"{analysis.Label} has no mesh of add_fem_mesh: add one, adapt changes its sizes")
        if not any(member.isDerivedFrom("Fem::FemSolverObjectPython") for member in analysis.Group):
            raise InvalidInput(f"{analysis.Label} has no solver: add CalculiX to it")
        self._source, = self._obj.Proxy.sources(self._obj)
        leaves = self._obj.Proxy.LEAVES_CONTAINERS
        self.shape = convert.taken(convert.own_shape_of(self._source) if leaves else convert.shape_of(self._source))
        self._frame, self._given = frames.frame_of(self._source) if leaves else FreeCAD.Placement(), size_field
        self.bounds = None if size_field is None else size_fields.moved(size_field, self._frame)
        self.values = options_of(self._obj, self._obj.Proxy.OPTIONS)
        self.values["order"] = self.values["order"] if order is None else order
        found = FemMeshObject.curve_values(self.shape, convert.with_resolved_sizes(self._source, self.values))[0]
        self.options = {name: value for name, value in found.items() if name not in ("order", "volume", "size_field")}

    def solve(self, mesh):
        """The displacements (N, 3) that CalculiX finds on a CurvedMesh."""
        arrays = self.results(mesh)
        return np.column_stack([arrays[name] for name in ("D1", "D2", "D3")])

    def results(self, mesh):
        """{name: float64 (N,)} of what CalculiX finds at the nodes of a CurvedMesh, by its names: D1, SXX ..."""
        program, path = self._in_document(lambda: self._write(mesh))
        _run(program, path, self._analysis.Label, self._progress)
        points, _, arrays = of_frd(f"{os.path.splitext(path)[0]}.frd")
        if len(points) != len(mesh.nodes) or "D1" not in arrays:
            raise Error(f"CalculiX left no displacements of {self._analysis.Label}: see its output in {os.path.dirname(path)}")
        return arrays

    def _write(self, mesh):
        """(program, path of its input): CalculiX's for the analysis on another mesh."""
        from femtools.ccxtools import FemToolsCcx

        held, made, place = self._obj.FemMesh, mesh.to_fem_mesh(groups=True), self._obj.Placement
        fem_groups.complete(self._obj, made)  # nodes of constraints, for which FreeCAD would search
        self._obj.Placement, self._obj.FemMesh = FreeCAD.Placement(), made
        try:
            solver = next(member for member in self._analysis.Group if member.isDerivedFrom("Fem::FemSolverObjectPython"))
            tools = FemToolsCcx(self._analysis, solver)
            tools.update_objects()
            tools.setup_working_dir()
            tools.setup_ccx()
            said = tools.check_prerequisites()
            if said:
                raise InvalidInput(f"{self._analysis.Label} cannot be solved: {' '.join(said.split())}")
            tools.write_inp_file()
        finally:
            self._obj.FemMesh, self._obj.Placement = held, place
        return tools.ccx_binary, tools.inp_file_name

    def keep(self, found):
        """Gives the object the mesh of an Adaptation with its sizes, as one undo step."""
        values = {**self.options, "volume": True}
        result = FemMeshObject.result_of(found.mesh, self.shape, values)
        self._in_document(lambda: self._put(found, result))

    def _put(self, found, result):
        obj, document = self._obj, self._obj.Document
        with undo_step(document, f"Adapt {obj.Label}: step {len(found.steps)}"):
            before = obj.SizeField
            names = size_fields.names_of(self._in_frame_of_document(found.sizes), self._source)[0]
            values = options.check(obj.Proxy.OPTIONS, {**self.values, "size_field": names})
            with with_precomputed(obj.Proxy, obj.Proxy.work_on([self._source], values, obj), result):
                update(obj, order=self.values["order"], size_field=names)
            for field in before:
                if document.getObject(field.Name) is not None and isinstance(field.Proxy, size_fields.SizeData) and not field.InList:
                    document.removeObject(field.Name)
            self.show_table(found)

    def _in_frame_of_document(self, sizes):
        """Sizes of an Adaptation, as objects of the document have them."""
        if sizes is self.bounds:
            return self._given
        given = [] if self._given is None else self._given if isinstance(self._given, list) else [self._given]
        return [size_fields.moved(sizes[0], self._frame.inverse()), *given]

    def show_table(self, found):
        """Writes the steps into the spreadsheet of the analysis, as one undo step or a part of one."""
        document = self._obj.Document
        rows, there = [(i, *step) for i, step in enumerate(found.steps, 1)], steps_in(self._analysis)
        if [row[:3] for row in rows] == [row[:3] for row in there]:
            return  # the spreadsheet rounds the others
        with undo_step(document, f"Adapt {self._obj.Label}"):
            sheet = table_of(self._analysis)
            if sheet is None:
                sheet = document.addObject("Spreadsheet::Sheet", TABLE)
                sheet.Label = window().translated(Text(label_phrases.LABELS["adaptation"], name=self._analysis.Label))
                self._analysis.addObject(sheet)
            # Undo does not bring back what clearAll() takes away.
            for row, cells in enumerate((COLUMNS, *rows, *[("",) * len(COLUMNS)] * (len(there) - len(rows))), 1):
                for column, cell in zip("ABCDE", cells):
                    sheet.set(f"{column}{row}", cell if isinstance(cell, str) else repr(cell))
            sheet.recompute()
            sheet.purgeTouched()


def table_of(analysis):
    """The spreadsheet with the steps in which an analysis was adapted; None without one."""
    return next((member for member in analysis.Group if member.Name.startswith(TABLE) and member.isDerivedFrom("Spreadsheet::Sheet")), None)


def steps_in(analysis):
    """[(step, unknowns, elements, error, least size in mm), ...] of that spreadsheet; none without one."""
    sheet, found = table_of(analysis), []
    while sheet is not None and sheet.getContents(f"A{len(found) + 2}"):
        found.append(tuple(kind(sheet.getContents(f"{column}{len(found) + 2}").lstrip("=")) for column, kind in zip("ABCDE", (int, int, int, float, float))))
    return found


def _run(program, path, label, progress):
    """Runs CalculiX on an input file. Raises Error; Cancelled when progress says so."""
    folder, name = os.path.split(os.path.splitext(path)[0])
    environment = {**os.environ, "OMP_NUM_THREADS": str(os.cpu_count() or 1)}
    said = os.path.join(folder, f"{name}.log")
    with open(said, "w", encoding="utf-8") as log, \
            subprocess.Popen([program, "-i", name], cwd=folder, env=environment, stdout=log, stderr=subprocess.STDOUT) as process:
        while True:
            try:
                status = process.wait(_POLL)
                break
            except subprocess.TimeoutExpired:
                try:
                    going_on = progress is None or progress(0.5, "solving") is not False
                except BaseException:
                    process.kill()
                    raise
                if not going_on:
                    process.kill()
                    raise Cancelled("cancelled while CalculiX solved") from None
    if status:
        raise Error(f"CalculiX could not solve {label}: see its output in {said}")
