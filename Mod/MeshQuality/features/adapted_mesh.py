# SPDX-License-Identifier: LGPL-2.1-or-later
"""adapt for functions and for analyses of the document, which CalculiX solves."""

import numpy as np

from ..core import adapting
from ..core.sources import convert
from ..errors import Error, InvalidInput
from .fem_groups import is_analysis
from .fem_mesh import FemMeshObject
from .properties import options_of
from .transactions import undo_step, update


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
    fewest elements for the target, changed by a factor of 2 at most. Returns an Adaptation. The mesh of an analysis gets the sizes of
    the best step as its SizeField, as one undo step. Raises InvalidInput naming the argument; what curve and the solver raise.
    """
    if not is_analysis(problem):
        if shape is None:
            raise InvalidInput("shape= is needed: what the function solves on is a mesh of it")
        return adapting.adapt(problem, shape, target_error, max_unknowns, steps, 2 if order is None else order, size_field, progress,
                              strains, **values)
    if shape is not None or values:
        raise InvalidInput("the shape and the options of an analysis are those of its mesh: leave shape= and others out")
    return _adapt_analysis(problem, target_error, max_unknowns, steps, order, size_field, progress)


def _adapt_analysis(analysis, target_error, max_unknowns, steps, order, size_field, progress):
    obj = next((member for member in analysis.Group if isinstance(getattr(member, "Proxy", None), FemMeshObject)), None)
    if obj is None:
        raise InvalidInput(f"{analysis.Label} has no mesh of add_fem_mesh: add one, adapt changes its sizes")
    given = options_of(obj, obj.Proxy.OPTIONS)
    order = given["order"] if order is None else order
    taken = {name: given[name] for name in ("min_angle", "chord_height", "chord_height_relative", "max_edge", "imprint", "overlap")}
    source, = obj.Proxy.sources(obj)
    held = obj.FemMesh
    found = None
    try:
        found = adapting.adapt(lambda mesh: _solved(analysis, obj, mesh), convert.own_shape_of(source), target_error, max_unknowns,
                               steps, order, size_field, progress, True, **taken)
    finally:
        obj.FemMesh = held
    if found.sizes is not None:
        with undo_step(obj.Document, f"Adapt {obj.Label}"):
            update(obj, progress, order=order, size_field=found.sizes)
    return found


def _solved(analysis, obj, mesh):
    """The displacements (N, 3) that CalculiX finds on a CurvedMesh."""
    from femtools.ccxtools import FemToolsCcx

    obj.FemMesh = mesh.to_fem_mesh(groups=True)
    solver = next((member for member in analysis.Group if member.isDerivedFrom("Fem::FemSolverObjectPython")), None)
    if solver is None:
        raise InvalidInput(f"{analysis.Label} has no solver: add CalculiX to it")
    tools = FemToolsCcx(analysis, solver)
    tools.purge_results()
    tools.update_objects()
    tools.setup_working_dir()
    tools.setup_ccx()
    said = tools.check_prerequisites()
    if said:
        raise InvalidInput(f"{analysis.Label} cannot be solved: {' '.join(said.split())}")
    tools.write_inp_file()
    if tools.ccx_run() not in (0, None):
        raise Error(f"CalculiX could not solve {analysis.Label}: see its output in {tools.working_dir}")
    tools.load_results()
    result = next((member for member in analysis.Group if member.isDerivedFrom("Fem::FemResultObject")), None)
    if result is None:
        raise Error(f"CalculiX left no results of {analysis.Label}: see its output in {tools.working_dir}")
    values = np.full((len(mesh.nodes), 3), np.nan)
    values[np.array(result.NodeNumbers) - 1] = np.array([tuple(v) for v in result.DisplacementVectors])
    return values
