# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quality meshes of CAD shapes and of meshes, inside FreeCAD. Lengths are in mm, angles in degrees.

First steps
    import MeshQuality as mq
    mesh = mq.triangulate(shape, min_angle=25.0, chord_height_relative=0.001)
    mesh.write("part.ply")
    mq.add_quality_mesh(App.ActiveDocument.Body, min_angle=25.0)

Meshes for scripts
    triangulate   a triangle mesh of a shape with a bound on its angles and its distance -> SurfaceMesh
                  with metric= triangles that are stretched, fewer for the same distance -> StretchedMesh
    curve         curved triangles or tetrahedra on a shape, each proven valid           -> CurvedMesh
    volume_mesh   a solid, or the space around one, filled for flow solvers, with layers of prisms on the walls -> VolumeMesh
    first_height  how high the first layer must be for a y+                              -> FirstHeight
    boolean       joins, intersects or subtracts closed meshes and shapes                -> BooleanMesh
    Solid         the same by operators, in sequences that are rounded once: (a - b) | c
    offset        a solid grown or shrunk by a distance                                  -> OffsetMesh
    hollow        a solid of which a wall is left, with openings                         -> OffsetMesh
    cam           a mesh for machining, never inside a solid or never outside            -> CamMesh
    wrap          the outer surface of objects, however dirty, without narrow openings     -> WrapMesh
    to_solid      the CAD solid of a mesh that was made of CAD, with exact surfaces      -> MeshSolid
    repair        a closed mesh without faults from one that has some                    -> BooleanMesh
    improve       the same surface with better triangles                                 -> SurfaceMesh
    simplify      the same surface with fewer triangles, within a proven distance        -> SimplifiedMesh
    quality       measures any mesh                                                      -> MeshReport
    measures      Verdict's and OpenFOAM's measures of each element: skew, warpage, scaled Jacobian ... -> MeasureTable
    section       a mesh cut by a plane: polygons, areas, and the half behind it in whole elements     -> MeshSection
    read_mesh     elements of a file of Gmsh, Abaqus, Nastran, Salome and others         -> ElementMesh
                  curve takes such meshes, too: of prisms and hexahedra -> CurvedElementMesh
    certify       proves which elements of any mesh are valid                            -> MeshCertificate
    verify        checks a saved certificate again, by other means                       -> CertificateVerification
    thickness     the thickness of walls, or the width of gaps, by rays and spheres      -> ThicknessMap
    clearance     the distances between the bodies of an assembly                        -> ClearanceReport
    draft         draft and undercuts against the direction in which a mould opens       -> DraftMap
    voids         closed cavities, from which nothing comes out                          -> VoidReport
    deviation     signed distances of a mesh, scan or point cloud from CAD or another mesh, aligned before -> DeviationMap
    size_field    edge lengths by place, sampled: drawn or asked before meshing           -> SizeField
    flow_sizes    sizes by the second derivatives of a field that OpenFOAM has computed  -> FlowSizes
    adapt         tetrahedra that are refined where the error of a solution is         -> Adaptation
    follow        the same triangles on a part after an edit of its dimensions                  -> FollowedMesh
    sensitivity   by how much each point of a mesh moves with a dimension of the part
    MeshCache     by which faces that an edit left alone keep their triangles

Objects of the document, which follow what they are made of
    add_quality_mesh, add_curved_mesh, add_fem_mesh, add_boolean, add_repaired_mesh, add_improved_mesh
    add_simplified_mesh  a mesh with fewer triangles
    add_offset, add_hollow   solids grown, shrunk, and made walls of
    add_cam_mesh        a mesh of a solid on one side of it, for machining
    add_solid           the CAD solid of a mesh, with exact surfaces
    add_wrap            a closed surface around objects
    add_inspection      thickness, clearance, draft or voids of a solid, measured anew after each edit, against a limit
    add_deviation       a scan or mesh in the colours of its deviation from a part, measured anew after each edit
    add_flow_mesh       a volume mesh with layers for a flow in or around a part
    add_cured_mesh      valid elements of a FEM mesh that another program made
    add_size_region     how long edges are in a solid, near faces, or in a wake: size_field= of meshes takes it
    update              gives such an object other options, and computes it
    write_report        a page with pictures on an object, or on what a function returned
    set_patches         names groups of faces, for files
    suggested_patches   groups that the document knows: labels, colours, references of an analysis
    export_mesh         writes its mesh into a file, with its patches; export_curved_mesh: of a curved mesh
    write_openfoam_case writes a folder in which OpenFOAM meshes a flow inside or around
    add_cfd_surface     a shape of its patches, which CfdOF meshes

Results and reports
    A mesh has NumPy arrays (vertices, triangles, ...), to_mesh() for a Mesh.Mesh, write(path) by extension, and its
    report: a MeshReport, BooleanReport or CurveReport. print(mesh.report) tells what was measured and requested.

Callbacks
    progress(fraction, stage) of a long call is called by the thread that called. It may return False, which raises
    Cancelled; what it raises comes out as it is; it may call functions of MeshQuality, undo, close documents and delete
    objects. update() raises Error where its object is gone then or its source another one, and changes nothing.
    Work of daemon threads is cancelled when Python ends.

Errors
    Error and its subclasses InvalidInput, TopologyError, GeometryError, Cancelled, IoError, MissingBinary. Their text
    names the sub-element at fault and the remedy.

help(mq.triangulate) and so on has all options.
"""

import importlib
import warnings

from .errors import (Cancelled, Error, GeometryError, InvalidInput, IoError, MissingBinary,
                     TopologyError)
from .features import gui_hooks
from .listing import hide_modules
from .version import __version__

hide_modules(__path__)
gui_hooks.fill("MeshQuality.gui.hooks")

# Loaded on first use: FreeCAD starts no slower, and errors and options work without the core.
_LAZY = {
    "triangulate": "MeshQuality.core.triangulation",
    "MeshCache": "MeshQuality.core.triangulation",
    "quality": "MeshQuality.core.quality",
    "measures": "MeshQuality.core.measures",
    "MeasureTable": "MeshQuality.core.measures",
    "section": "MeshQuality.core.sectioning",
    "MeshSection": "MeshQuality.core.sectioning",
    "repair": "MeshQuality.core.repair",
    "add_repaired_mesh": "MeshQuality.features.repaired_mesh",
    "improve": "MeshQuality.core.improvement",
    "simplify": "MeshQuality.core.simplification",
    "SimplifiedMesh": "MeshQuality.core.simplification",
    "add_improved_mesh": "MeshQuality.features.improved_mesh",
    "add_simplified_mesh": "MeshQuality.features.simplified_mesh",
    "certify": "MeshQuality.core.certify.certification",
    "MeshCertificate": "MeshQuality.core.certify.certification",
    "verify": "MeshQuality.core.verify.verification",
    "CertificateVerification": "MeshQuality.core.verify.verification",
    "thickness": "MeshQuality.core.inspect.thickness",
    "ThicknessMap": "MeshQuality.core.inspect.thickness",
    "clearance": "MeshQuality.core.inspect.clearance",
    "ClearanceReport": "MeshQuality.core.inspect.clearance",
    "draft": "MeshQuality.core.inspect.draft",
    "DraftMap": "MeshQuality.core.inspect.draft",
    "deviation": "MeshQuality.core.inspect.deviation",
    "DeviationMap": "MeshQuality.core.inspect.deviation",
    "voids": "MeshQuality.core.inspect.voids",
    "VoidReport": "MeshQuality.core.inspect.voids",
    "curve": "MeshQuality.core.curving",
    "CurvedMesh": "MeshQuality.core.curving",
    "CurvedElementMesh": "MeshQuality.core.curved.curved_elements",
    "boolean": "MeshQuality.core.booleans",
    "BooleanMesh": "MeshQuality.core.booleans",
    "Solid": "MeshQuality.core.solid_expression",
    "offset": "MeshQuality.core.offsetting",
    "hollow": "MeshQuality.core.offsetting",
    "OffsetMesh": "MeshQuality.core.offsetting",
    "cam": "MeshQuality.core.machining",
    "CamMesh": "MeshQuality.core.machining",
    "add_cam_mesh": "MeshQuality.features.cam_mesh",
    "to_solid": "MeshQuality.core.mesh_to_solid",
    "MeshSolid": "MeshQuality.core.mesh_to_solid",
    "add_solid": "MeshQuality.features.mesh_solid",
    "wrap": "MeshQuality.core.wrapping",
    "WrapMesh": "MeshQuality.core.wrapping",
    "StretchedMesh": "MeshQuality.core.stretching.stretch",
    "follow": "MeshQuality.core.following.follow",
    "FollowedMesh": "MeshQuality.core.following.follow",
    "sensitivity": "MeshQuality.features.sensitivity",
    "adapt": "MeshQuality.features.adapted_mesh",
    "Adaptation": "MeshQuality.core.adapting",
    "volume_mesh": "MeshQuality.core.volumes.volume_mesh",
    "VolumeMesh": "MeshQuality.core.volumes.volume_mesh",
    "first_height": "MeshQuality.core.volumes.first_height",
    "FirstHeight": "MeshQuality.core.volumes.first_height",
    "size_field": "MeshQuality.core.sizes.size_field",
    "SizeField": "MeshQuality.core.sizes.size_field",
    "flow_sizes": "MeshQuality.core.sizes.flow_sizes",
    "FlowSizes": "MeshQuality.core.sizes.flow_sizes",
    "add_size_region": "MeshQuality.features.size_region",
    "add_quality_mesh": "MeshQuality.features.quality_mesh",
    "add_curved_mesh": "MeshQuality.features.curved_mesh",
    "add_fem_mesh": "MeshQuality.features.fem_mesh",
    "add_cured_mesh": "MeshQuality.features.cured_mesh",
    "add_flow_mesh": "MeshQuality.features.flow_mesh",
    "add_boolean": "MeshQuality.features.boolean",
    "add_offset": "MeshQuality.features.offset",
    "add_hollow": "MeshQuality.features.hollow",
    "add_wrap": "MeshQuality.features.wrap",
    "add_inspection": "MeshQuality.features.inspection",
    "add_deviation": "MeshQuality.features.deviation",
    "export_curved_mesh": "MeshQuality.features.export",
    "export_mesh": "MeshQuality.features.export",
    "write_openfoam_case": "MeshQuality.features.cfd",
    "add_cfd_surface": "MeshQuality.features.cfd_surface",
    "set_patches": "MeshQuality.features.transactions",
    "suggested_patches": "MeshQuality.core.patches.patch_names",
    "write_report": "MeshQuality.features.report",
    "update": "MeshQuality.features.transactions",
    "ElementMesh": "MeshQuality.core.meshes.element_mesh",
    "read_mesh": "MeshQuality.core.meshes.element_mesh",
    "SurfaceMesh": "MeshQuality.core.meshes.surface_mesh",
    "MeshReport": "MeshQuality._core",
    "BooleanReport": "MeshQuality._core",
    "CurveReport": "MeshQuality._core",
}

__all__ = sorted(["Cancelled", "Error", "GeometryError", "InvalidInput", "IoError", "MissingBinary",
                  "TopologyError", *_LAZY])


# {older name: present name}, until the next minor version.
_RENAMED = {"Memory": "MeshCache"}


def __getattr__(name):
    if name in _RENAMED:
        warnings.warn(f"MeshQuality.{name} is called MeshQuality.{_RENAMED[name]} now", DeprecationWarning, stacklevel=2)
        return getattr(importlib.import_module(__name__), _RENAMED[name])
    if name not in _LAZY:
        raise AttributeError(f"module 'MeshQuality' has no attribute {name!r}")
    if _LAZY[name] == "MeshQuality._core":
        from .compat import extension

        module = extension()
    else:
        module = importlib.import_module(_LAZY[name])
    value = getattr(module, name)
    if isinstance(value, type):
        value.__module__ = __name__  # help() names it as scripts do
    globals()[name] = value
    return value


def __dir__():
    """What scripts use, for tab completion and help()."""
    return ["__version__", *__all__]
