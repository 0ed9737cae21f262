# SPDX-License-Identifier: LGPL-2.1-or-later
"""A folder with a surface mesh and what OpenFOAM's snappyHexMesh and cfMesh need to fill it, or the space around it."""

import numbers
import os
import re
from dataclasses import dataclass, replace

import numpy as np

from ... import phrases
from ...errors import InvalidInput, IoError
from ...phrases import Text
from ..patches.patches import patches_of
from . import writing

FLOWS = ("internal", "external")
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_.+\-]*")
_MOST_CELLS = 1000 # cells of the background along the part, at most
MOST_LEVELS = 6  # levels of refinement: then cells are 64 times as short as in the background
_CELLS = {"internal": 20, "external": 4}  # cells of the background along the part
_MARGIN = 0.05  # share of the size by which the background exceeds the part for flows inside
_FAR = (2.0, 4.0)  # sizes of the part between it and the sides of the background, before and behind it along x
_OPEN = ("inlet", "outlet", "opening", "farfield")  # patches called so are open, all others walls
_WALL, _PATCH = "wall", "patch"
_HEADER = """FoamFile
{{
    version 2.0;
    format ascii;
    class dictionary;
    object {};
}}
"""


@dataclass(frozen=True)
class Case:
    """The values in the files, in metres (or in the unit that `scale` makes of mm).

    name      of the surface
    cell      length of the cells of the background
    low, high corners of the background
    inside    a point of the space that is meshed
    levels    by patch the least and the greatest level of refinement
    types     by patch "wall" or "patch"
    flow      one of FLOWS
    regions   [(low, high, level), ...]: boxes with cells that are halved so often
    """

    name: str
    cell: float
    low: np.ndarray
    high: np.ndarray
    inside: np.ndarray
    levels: dict
    types: dict
    flow: str
    regions: list


def write_case(mesh, folder, name="surface", flow="internal", cell=None, scale=0.001, types=None, regions_of=None):
    """Writes the files; see mq.write_openfoam_case. Returns the Case.

    regions_of  function(low, high, cell, most level) -> [(low, high, level), ...] in mm; None: no regions
    """
    case = case_of(mesh, name, flow, cell, writing.checked_scale(scale), types)
    if regions_of is not None:
        boxes = regions_of(case.low / scale, case.high / scale, case.cell / scale, MOST_LEVELS)
        case = replace(case, regions=[(low * scale, high * scale, level) for low, high, level in boxes])
    for path in ("constant/triSurface", "system"):
        try:
            os.makedirs(os.path.join(folder, path), exist_ok=True)
        except OSError as error:
            raise IoError(f"{os.path.join(folder, path)} cannot be made: {error.strerror}") from error
    surface = os.path.join(folder, "constant", "triSurface", name)
    writing.write(mesh, f"{surface}.stl", scale=scale, ascii=True)
    for suffix in (".eMesh", ".fms"):
        writing.write(mesh, f"{surface}{suffix}", scale=scale)
    for path, text in _texts(case).items():
        writing.atomically(os.path.join(folder, path), "", lambda ready, text=text: save(ready, text))
    return case


def save(path, text):
    """Writes a text file."""
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def case_of(mesh, name, flow, cell, scale, types):
    """The Case of a SurfaceMesh."""
    types = {} if types is None else types
    if not isinstance(types, dict):
        raise InvalidInput(f"types = {types!r} is not possible: give a dict such as {{'top': 'patch'}}")
    if flow not in FLOWS:
        raise InvalidInput(f"flow = {flow!r} is not possible: give 'internal' for the space inside of the part, 'external' "
                           "for that around it")
    require_closed(mesh)
    require_apart(mesh)
    require_one_space(flow, len(set(mesh.triangle_solid.tolist())))
    corners = (mesh.vertices + mesh.origin)[mesh.triangles] * scale
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    size = float((high - low).max())
    least = size / _MOST_CELLS
    if cell is not None and (isinstance(cell, bool) or not isinstance(cell, numbers.Real)
                             or not least <= cell * scale < size):
        raise InvalidInput(Text(phrases.CASE_CELL, value=repr(cell), length=f"{least / scale:.3g} mm",
                                length2=f"{size / scale:.6g} mm"))
    cell = size / _CELLS[flow] if cell is None else float(cell) * scale
    patches = mesh._patches or patches_of(None, mesh.triangle_face, len(mesh.triangles))
    unknown = next((patch for patch in types if patch not in patches.names), None)
    if unknown is not None:
        raise InvalidInput(f"types name {unknown!r}, which is no patch: there are {', '.join(patches.names)}")
    wrong = next((patch for patch in patches.names if not _NAME.fullmatch(patch)), None)
    if wrong is not None:
        raise InvalidInput(Text(phrases.FOAM_PATCH, name=repr(wrong)))
    levels = {patch: _levels(corners[patches.of_triangle == i], cell) for i, patch in enumerate(patches.names)
              if (patches.of_triangle == i).any()}
    if flow == "internal":
        low, high, inside = low - _MARGIN * size, high + _MARGIN * size, point_inside(corners)
    else:
        before, behind = _FAR[0] * size, np.array([_FAR[1], _FAR[0], _FAR[0]]) * size
        # Off the planes of the cells, on which no such point may lie.
        low, high, inside = low - before, high + behind, low - before + np.array([0.37, 0.41, 0.43]) * cell
    kinds = {patch: types.get(patch, _PATCH if patch.lower().startswith(_OPEN) else _WALL) for patch in levels}
    return Case(name, cell, low, high, inside, levels, kinds, flow, [])


def require_closed(mesh):
    """Raises InvalidInput for a SurfaceMesh that is open."""
    if not mesh.report.closed:
        raise InvalidInput(Text(phrases.CASE_OPEN, count=str(mesh.report.border_edges)))


def require_apart(mesh):
    """Raises InvalidInput for a SurfaceMesh with bodies that overlap, unless it was made with overlap="allow"."""
    found = [] if mesh._overlap == "allow" else mesh.report.overlapping_bodies
    if found:
        raise InvalidInput(Text(phrases.CASE_OVERLAP, name=found[0][0], name2=found[0][1]))


def require_one_space(flow, solids):
    """Raises InvalidInput where there are several spaces inside."""
    if flow == "internal" and solids > 1:
        raise InvalidInput(Text(phrases.CASE_SOLIDS, count=str(solids)))


def _levels(corners, cell):
    """Levels at which cells are as large as triangles, which are small where the surface bends: as those on the larger
    half of the area, and as those on all but a tenth of it.
    """
    areas = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    order = np.argsort(areas)
    share = np.cumsum(areas[order]) / areas.sum()
    lengths = np.sqrt(areas[order])
    least, most = (int(np.clip(np.ceil(np.log2(cell / lengths[np.searchsorted(share, part)])), 0, MOST_LEVELS))
                   for part in (0.5, 0.1))
    return least, most


def point_inside(corners):
    """A point inside of a closed surface: halfway from its largest triangle to what lies opposite to that."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(normals, axis=1)
    for largest in np.argsort(-areas, kind="stable")[:100]:
        start, way = corners[largest].mean(axis=0), -normals[largest] / areas[largest]
        hits = _hits(corners, start, way)
        hits = np.sort(hits[hits > 1e-9 * np.ptp(corners)])
        if len(hits):
            return start + 0.5 * hits[0] * way
    raise InvalidInput(Text(phrases.CASE_NO_INSIDE))


def _hits(corners, start, way):
    """The distances at which a ray meets triangles (Moeller and Trumbore 1997)."""
    one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = np.cross(way, two)
    scale = np.einsum("ij,ij->i", one, across)
    scale[scale == 0.0] = np.nan  # parallel: what follows is false
    from_corner = start - corners[:, 0]
    u = np.einsum("ij,ij->i", from_corner, across) / scale
    turned = np.cross(from_corner, one)
    v = turned @ way / scale
    distance = np.einsum("ij,ij->i", two, turned) / scale
    return distance[(u >= 0.0) & (v >= 0.0) & (u + v <= 1.0)]


SCHEMES = """ddtSchemes { default steadyState; }
gradSchemes { default Gauss linear; }
divSchemes { default none; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""
# Where lines between centres miss the middles of faces, as between tetrahedra, linear interpolation errs by a share that no finer mesh
# makes smaller: docs/measurements/flow.md.
SKEW_SCHEMES = SCHEMES.replace("Gauss linear; }", "Gauss pointLinear; }").replace(
    "default none; }", "default none; div(phi,U) bounded Gauss pointLinear; div((nuEff*dev2(T(grad(U))))) Gauss linear; }")


def solver_texts(schemes=SCHEMES):
    """{path: text} of the dictionaries without which programs of OpenFOAM do not start; with these schemes."""
    return {
        "system/controlDict": _HEADER.format("controlDict") + _CONTROL,
        "system/fvSchemes": _HEADER.format("fvSchemes") + schemes,
        "system/fvSolution": _HEADER.format("fvSolution"),
    }


def _texts(case):
    """{path: text} of the dictionaries."""
    return {
        **solver_texts(),
        "system/blockMeshDict": _block(case),
        "system/snappyHexMeshDict": _snappy(case),
        "system/meshDict": _cfmesh(case),
    }


def _vector(point):
    return "(" + " ".join(repr(float(number)) for number in point) + ")"


def _block(case):
    cells = np.maximum(np.ceil((case.high - case.low) / case.cell), 1).astype(int)
    high = case.low + cells * case.cell
    corners = [np.where([i in (1, 2, 5, 6), i in (2, 3, 6, 7), i > 3], high, case.low) for i in range(8)]
    sides = {"xMin": "(0 4 7 3)", "xMax": "(1 2 6 5)", "yMin": "(0 1 5 4)", "yMax": "(3 7 6 2)", "zMin": "(0 3 2 1)",
             "zMax": "(4 5 6 7)"}
    walls = "\n".join(f"    {name} {{ type patch; faces ({face}); }}" for name, face in sides.items())
    return (f"{_HEADER.format('blockMeshDict')}scale 1;\nvertices\n(\n"
            + "\n".join(f"    {_vector(corner)}" for corner in corners)
            + f"\n);\nblocks\n(\n    hex (0 1 2 3 4 5 6 7) ({cells[0]} {cells[1]} {cells[2]}) simpleGrading (1 1 1)\n);\n"
            f"boundary\n(\n{walls}\n);\n")


def _snappy(case):
    regions = "\n".join(f'            "{patch}" {{ name {patch}; }}' for patch in case.levels)
    levels = "\n".join(
        f'                "{patch}" {{ level ({least} {most}); patchInfo {{ type {case.types[patch]}; }} }}'
        for patch, (least, most) in case.levels.items())
    lowest = min(least for least, _ in case.levels.values())
    highest = max(most for _, most in case.levels.values())
    boxes = "".join(f"    region{i}\n    {{\n        type searchableBox;\n        min {_vector(low)};\n        max {_vector(high)};\n    }}\n"
                    for i, (low, high, _) in enumerate(case.regions))
    inside_boxes = "".join(f"        region{i} {{ mode inside; levels ((1e15 {level})); }}\n" for i, (_, _, level) in enumerate(case.regions))
    return _HEADER.format("snappyHexMeshDict") + _SNAPPY.format(
        name=case.name, regions=regions, levels=levels, lowest=lowest, highest=highest, inside=_vector(case.inside), boxes=boxes,
        inside_boxes=inside_boxes)


def _cfmesh(case):
    refined = "\n".join(f'    "{patch}" {{ additionalRefinementLevels {most}; }}'
                        for patch, (_, most) in case.levels.items() if most)
    kinds = "\n".join(f'        "{patch}" {{ type {kind}; }}' for patch, kind in case.types.items())
    return (f'{_HEADER.format("meshDict")}surfaceFile "constant/triSurface/{case.name}.fms";\nmaxCellSize {case.cell!r};\n'
            f"localRefinement\n{{\n{refined}\n}}\nrenameBoundary\n{{\n    newPatchNames\n    {{\n{kinds}\n    }}\n}}\n")


_CONTROL = """application simpleFoam;
startFrom latestTime;
startTime 0;
stopAt endTime;
endTime 100;
deltaT 1;
writeControl timeStep;
writeInterval 100;
writeFormat ascii;
writePrecision 10;
"""
_SNAPPY = """castellatedMesh true;
snap true;
addLayers false;
geometry
{{
    {name}.stl
    {{
        type triSurfaceMesh;
        name {name};
        regions
        {{
{regions}
        }}
    }}
{boxes}}}
castellatedMeshControls
{{
    maxLocalCells 2000000;
    maxGlobalCells 10000000;
    minRefinementCells 0;
    nCellsBetweenLevels 3;
    resolveFeatureAngle 30;
    allowFreeStandingZoneFaces true;
    locationInMesh {inside};
    features ( {{ file "{name}.eMesh"; level {highest}; }} );
    refinementSurfaces
    {{
        {name}
        {{
            level ({lowest} {highest});
            regions
            {{
{levels}
            }}
        }}
    }}
    refinementRegions
    {{
{inside_boxes}    }}
}}
snapControls
{{
    nSmoothPatch 3;
    tolerance 2.0;
    nSolveIter 100;
    nRelaxIter 5;
    nFeatureSnapIter 10;
    implicitFeatureSnap false;
    explicitFeatureSnap true;
    multiRegionFeatureSnap true;
}}
addLayersControls
{{
    relativeSizes true;
    layers {{}}
    expansionRatio 1.2;
    finalLayerThickness 0.3;
    minThickness 0.1;
    nGrow 0;
    featureAngle 60;
    nRelaxIter 3;
    nSmoothSurfaceNormals 1;
    nSmoothNormals 3;
    nSmoothThickness 10;
    maxFaceThicknessRatio 0.5;
    maxThicknessToMedialRatio 0.3;
    minMedianAxisAngle 90;
    nBufferCellsNoExtrude 0;
    nLayerIter 50;
}}
meshQualityControls
{{
    maxNonOrtho 65;
    maxBoundarySkewness 20;
    maxInternalSkewness 4;
    maxConcave 80;
    minVol 1e-30;
    minTetQuality 1e-15;
    minArea -1;
    minTwist 0.02;
    minDeterminant 0.001;
    minFaceWeight 0.05;
    minVolRatio 0.01;
    minTriangleTwist -1;
    nSmoothScale 4;
    errorReduction 0.75;
    relaxed {{ maxNonOrtho 75; }}
}}
mergeTolerance 1e-6;
"""
