# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a finished mesh meets what was requested: one rule for document objects, the command line and
batches. Imports nothing of documents.

It is about the mesh as it was measured after rounding to single precision, not about the algorithm.
Its sentences are made of the phrases of one table, by which panels translate them.
"""

import re
from dataclasses import asdict, dataclass

import numpy as np

from . import convert, phrases
from .compat import core
from .phrases import MET, NOT_MET

# Elements whose shape is distorted more than this are a finding. The inverse of the distortion is the shape metric of
# Knupp 2001, so that 10 is a metric of 0.1. The map from the regular tetrahedron then stretches at least 13 times more one
# way than another (needles; flat ones 58 times), and with that grow the errors of gradients and the condition of stiffness
# matrices. A triangle of 10 has a corner of 3.3 degrees.
SHAPE_DISTORTION_LIMIT = 10.0

_OLD_MET, _OLD_NOT_MET = "kept", "missed: "  # in documents of older versions
_NAMED = 3  # elements or faces that a sentence names
_COUNTED = 1000  # contacts that the core counts at most, where nobody has counted them before


@dataclass(frozen=True)
class Finding:
    """Something requested that the mesh does not meet, or a fault that no mesh should have.

    text    one or more sentences
    faces   the CAD faces ("Face7", ...) where that is
    place   the corners of the triangle where it is worst, in the document's frame: three points;
            none where that is not known
    forced  whether the shape itself rules out what was requested, as a corner smaller than the
            smallest angle does
    """

    text: str
    faces: tuple = ()
    place: tuple = ()
    forced: bool = False


def word(findings):
    """"met" or "not met"."""
    return NOT_MET if findings else MET


def sentence(findings):
    """What the property Certificate says."""
    return f"{NOT_MET}: {_joined(findings)}" if findings else MET


def _joined(findings):
    """The sentences of all, to stand after a colon."""
    return phrases.lower_first(" ".join(finding.text for finding in findings))


def is_met(certificate):
    """Whether a Certificate, also of an older version, says that all limits are met."""
    return certificate in (MET, _OLD_MET)


def is_missed(certificate):
    """Whether it says that some are not."""
    return certificate.startswith((NOT_MET, _OLD_NOT_MET))


def said(certificate):
    """What a Certificate says is not met, without the words before it."""
    for start in (f"{NOT_MET}: ", _OLD_NOT_MET):
        if certificate.startswith(start):
            return certificate[len(start):]
    return ""


def faces(findings):
    """The CAD faces of all findings, each once."""
    return list(dict.fromkeys(face for finding in findings for face in finding.faces))


def place(findings):
    """The place of the first finding that has one, as three points."""
    return next((finding.place for finding in findings if finding.place), ())


def plain(findings):
    """The verdict and the findings as plain values for JSON."""
    return {"verdict": word(findings), "findings": [
        {name: list(value) if isinstance(value, tuple) else value
         for name, value in asdict(finding).items()} for finding in findings]}


def line(label, report, findings, translate=lambda text: text):
    """One line for people about a finished mesh: its figures, and whether all requested limits are met.

    translate   translate(text of `phrases`) -> text in the user's language
    """
    shown = ", ".join(phrases.translated(figure, translate) for figure in _figures(report))
    said = phrases.TARGET_NOT_MET.format(text=_joined(findings)) if findings else phrases.ALL_MET
    return f"{label}: {shown}; {phrases.translated(said, translate)}"


def _figures(report):
    """What the line says of a MeshReport, BooleanReport or CurveReport."""
    if hasattr(report, "elements"):
        yield _counted(phrases.ELEMENTS, report.elements)
        yield phrases.MAX_DISTORTION.format(number=_number(report.max_shape_distortion))
        yield phrases.MAX_DEVIATION.format(number=_rounded(report.max_deviation))
        return
    yield _counted(phrases.TRIANGLES, report.triangles)
    if report.triangles:
        yield phrases.SMALLEST_ANGLE.format(number=_rounded(report.min_angle))
    if hasattr(report, "error_bound"):
        yield phrases.ERROR_BOUND.format(number=_rounded(report.error_bound))
    elif report.max_chord_height >= 0:
        yield phrases.MAX_DEVIATION.format(number=_rounded(report.max_chord_height))


def must_be_closed(shape):
    """Whether all faces of the shape belong to solids."""
    return bool(shape.Solids) and sum(len(solid.Faces) for solid in shape.Solids) >= len(shape.Faces)


def of_triangulation(mesh, closed, values=None):
    """Findings of a SurfaceMesh that triangulate made with these options."""
    return [*angles(mesh), *deviation(mesh), *edges(mesh, values or {}), *_incomplete(mesh.report), *_missing_faces(mesh.report),
            *topology(mesh.report, closed, mesh), *_crossings(mesh.report)]


def of_improvement(mesh, closed, progress=None):
    """Findings of a SurfaceMesh that improve made; `closed`: whether the mesh before it was; progress as for
    improve.
    """
    return [*angles(mesh), *topology(mesh.report, closed, mesh), *_crossing_pairs(mesh, progress)]


def of_boolean(mesh):
    """Findings of a BooleanMesh. An empty one has none."""
    report = mesh.report
    found = _too_far(report.error_bound, report.tolerance_asked, phrases.RESULT_DISTANCE)
    if report.self_intersections > 0:  # counted of method uniform only
        found.append(Finding(f"{_counted(phrases.CROSSING, report.self_intersections)} "
                             f"{_sentence(phrases.UNIFORM_CROSSES)}"))
    elif report.faults_left:
        found.append(Finding(_counted(phrases.FAULTS_LEFT, report.faults_left)))
    return found + (topology(report, True, mesh) if report.triangles else [])


def of_curved(curved, closed, corners=None):
    """Findings of a CurvedMesh; `corners`: what `topology_of_corners` gives, where that is known."""
    return [*elements(curved), *distortion(curved),
            *topology(corners or topology_of_corners(curved), closed), *_crossings(curved.report)]


def topology_of_corners(curved):
    """The MeshReport of the triangles between the corners of a CurvedMesh's triangles."""
    corners = curved.triangles[:, :3]
    last = corners.max(initial=-1) + 1
    return convert.surface_of_arrays(core(), curved.nodes[:last], corners).report


def of_measured(mesh, report, closed):
    """Findings of a mesh of unknown origin with its MeshReport: faults that no mesh should have."""
    return [*topology(report, closed, mesh), *_crossing_pairs(mesh)]


def topology(report, closed, mesh=None):
    """Findings where a mesh is not manifold, or not closed where it must be; a SurfaceMesh also tells where."""
    found = []
    if closed and not report.closed:
        found.append(_at_edges(_counted(phrases.NOT_CLOSED, report.border_edges), mesh,
                               lambda uses: uses == 1))
    for phrase, count in ((phrases.NONMANIFOLD, report.nonmanifold_edges),
                          (phrases.PINCHED, report.pinched_vertices),
                          (phrases.DEGENERATE, report.degenerate_triangles),
                          (phrases.NOT_ORIENTED,
                           report.misoriented_edges - report.nonmanifold_edges)):
        if count:
            found.append(_at_edges(_counted(phrase, count), mesh, lambda uses: uses > 2))
    return found


def angles(mesh):
    """The finding of triangles of a SurfaceMesh below the requested smallest angle."""
    report = mesh.report
    asked = report.min_angle_asked
    if not report.triangles or report.min_angle >= asked:
        return []
    measured = core().triangle_shapes(mesh._surface)[0]
    worst, below = int(np.argmin(measured)), np.flatnonzero(measured < asked)
    reasons = dict(report.exempt)
    forced = all(phrases.is_forced(reasons.get(int(triangle), "")) for triangle in below)
    text = _sentence(phrases.ANGLE, number=_told_apart(report.min_angle, asked), number2=f"{asked:g}",
                     phrase=_triangle(mesh, worst))
    if worst in reasons:
        text += f" {phrases.sentence(_without_face(mesh, worst, reasons[worst]))}"
    if len(below) > 1:
        more = phrases.MORE_FORCED if forced else phrases.MORE_BELOW
        text += " " + _counted(more, len(below) - 1, number=f"{asked:g}")
    return [Finding(text, _names(mesh, below), _corners(mesh, worst), forced)]


def _without_face(mesh, triangle, reason):
    """A reason without the face at its end, which the sentence before it names."""
    for name in _names(mesh, [triangle]):
        reason = reason.removesuffix(phrases.ON_FACE.format(phrase="", face=name))
    return reason


def deviation(mesh):
    """The finding that a SurfaceMesh is too far from the shape, and where it is farthest."""
    report = mesh.report
    worst = report.max_chord_triangle
    if worst < 0:
        return _too_far(report.max_chord_height, report.chord_height_asked, phrases.SHAPE_DISTANCE)
    found = _too_far(report.max_chord_height, report.chord_height_asked,
                     phrases.SHAPE_DISTANCE_AT, phrase=_triangle(mesh, worst))
    return [Finding(finding.text, _names(mesh, [worst]), _corners(mesh, worst)) for finding in found]


def edges(mesh, values):
    """The finding that edges of a SurfaceMesh are longer than max_edge or the local sizes of faces allow."""
    faces = {int(name[4:]) - 1: size for name, size in (values.get("local_sizes") or {}).items()
             if name.startswith("Face")}
    if not (faces or values.get("max_edge")) or not len(mesh.triangles):
        return []
    corners = mesh.vertices[mesh.triangles]
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    allowed = np.full(len(longest), values.get("max_edge") or np.inf)
    for face, size in faces.items():
        on_face = np.asarray(mesh.triangle_face) == face
        allowed[on_face] = np.minimum(allowed[on_face], size)
    worst = int(np.argmax(longest / allowed))
    # Rounding to single precision may lengthen an edge by a millionth.
    if longest[worst] <= allowed[worst] * (1.0 + 1e-5):
        return []
    beyond = np.flatnonzero(longest > allowed * (1.0 + 1e-5))
    return [Finding(finding.text, _names(mesh, beyond), _corners(mesh, worst)) for finding in _too_far(
        longest[worst], allowed[worst], phrases.LONGEST_EDGE, phrase=_triangle(mesh, worst))]


def _too_far(measured, asked, phrase, /, **places):
    """The finding that a measured length in mm exceeds the requested one; asked 0: none was."""
    if not asked or measured <= asked:
        return []
    return [Finding(_sentence(phrase, number=_told_apart(measured, asked), number2=f"{asked:.3g}", **places))]


def elements(curved):
    """The finding of elements of a CurvedMesh that are not proven to be free of folds."""
    report = curved.report
    if not report.invalid:
        return []
    named = report.invalid_elements
    text = ", ".join(named[:_NAMED])
    if len(named) > _NAMED:
        text = phrases.AND_MORE.format(list=text, count=len(named) - _NAMED)
    found = re.findall(r"on (Face\d+)", "; ".join(named))
    return [Finding(_counted(phrases.FOLDED, report.invalid, count2=report.elements, list=text),
                    tuple(dict.fromkeys(found)), _first_folded(curved))]


def _first_folded(curved):
    """Corners of the first element that is not proven valid."""
    for quality, nodes in ((curved.triangle_quality, curved.triangles),
                           (curved.tetrahedron_quality, curved.tetrahedra)):
        folded = np.flatnonzero(~(quality > 0.0))
        if len(folded):
            return tuple(map(tuple, curved.nodes[nodes[folded[0], :3]].tolist()))
    return ()


def distortion(curved):
    """The finding of elements of a CurvedMesh, inside the volume too, far from the regular shape. Those
    that fold are not counted: `elements` has them.
    """
    if not curved.report.max_shape_distortion > SHAPE_DISTORTION_LIMIT:
        return []
    filled = len(curved.tetrahedra) > 0
    values = curved.tetrahedron_distortion if filled else curved.triangle_distortion
    values = np.where(np.isfinite(values), values, 0.0)
    count = int((values > SHAPE_DISTORTION_LIMIT).sum())
    if not count:
        return []
    worst = int(np.argmax(values))
    faces = () if filled else tuple(dict.fromkeys(
        f"Face{face + 1}" for face in curved.triangle_face[values > SHAPE_DISTORTION_LIMIT].tolist()))
    where = phrases.TETRAHEDRON.format(count=worst, solid=f"Solid{curved.tetrahedron_solid[worst] + 1}") if filled \
        else phrases.ON_FACE.format(phrase=phrases.TRIANGLE.format(count=worst),
                                    face=f"Face{curved.triangle_face[worst] + 1}")
    text = _sentence(phrases.DISTORTED, number=_told_apart(values[worst], SHAPE_DISTORTION_LIMIT),
                     number2=f"{SHAPE_DISTORTION_LIMIT:g}", phrase=where)
    if count > 1:
        text += " " + _counted(phrases.MORE_DISTORTED, count - 1, number=f"{SHAPE_DISTORTION_LIMIT:g}")
    corners = (curved.tetrahedra if filled else curved.triangles)[worst, :3]
    return [Finding(text, faces, tuple(map(tuple, curved.nodes[corners].tolist())))]


def _crossing_pairs(mesh, progress=None):
    """The finding of crossing triangles of a SurfaceMesh whose report does not count them."""
    check = None if progress is None else lambda fraction, stage: progress(1.0, "checking")
    count = core().verify(mesh._surface, check)["crossing pair of triangles"]
    if count >= _COUNTED:
        return [Finding(_sentence(phrases.CROSSING_MANY, count=f"{_COUNTED:,}"))]
    return [Finding(_counted(phrases.CROSSING, count))] if count else []


def _crossings(report):
    """The finding of a MeshReport or CurveReport that says which CAD faces cross."""
    if report.self_intersections <= 0:
        return []
    pairs = [tuple(f"Face{face + 1}" for face in crossing[:2]) for crossing in report.crossing_faces]
    text = _counted(phrases.CROSSING, report.self_intersections)
    for first, second in pairs[:_NAMED]:
        text += " " + (phrases.CROSSES_ITSELF.format(face=first) if first == second
                       else phrases.FACES_CROSS.format(face=first, face2=second))
    return [Finding(text, tuple(dict.fromkeys(face for pair in pairs for face in pair)))]


def _missing_faces(report):
    """The finding of CAD faces that were left out as they could not be meshed."""
    names = tuple(dict.fromkeys(f"Face{face + 1}" for face, _ in report.missing_faces))
    if not names:
        return []
    listed = ", ".join(names[:_NAMED])
    if len(names) > _NAMED:
        listed = phrases.AND_MORE.format(list=listed, count=len(names) - _NAMED)
    return [Finding(_counted(phrases.MISSING, len(names), list=listed), names)]


def _incomplete(report):
    return [] if report.complete else [Finding(phrases.sentence(phrases.LIMIT))]


def _counted(phrase, count, /, **places):
    """The phrase for one or for many, as a sentence."""
    return _sentence(phrase[count != 1], count=f"{count:,}", **places)


def _sentence(phrase, /, **places):
    return phrases.upper_first(phrase.format(**places))


_ROUNDING = 1e-6


def _number(value, digits=3):
    """Three digits; of small angles too, but not in powers of ten."""
    return np.format_float_positional(value, precision=digits, fractional=False, trim="-")


def _told_apart(value, limit):
    """A value with as many digits as tell it from its limit, three at least."""
    if value < _ROUNDING <= limit:
        return "0"
    return next(text for text in (_number(value, digits) for digits in range(3, 18))
                if float(text) != limit and (float(text) < limit) == (value < limit))


def _rounded(value):
    """Likewise of mm and degrees; less than a millionth is rounding."""
    return _number(value) if value >= _ROUNDING else "0"


def _triangle(mesh, triangle):
    """"triangle 7 on Face3"; without the face where that is not known."""
    text = phrases.TRIANGLE.format(count=triangle)
    names = _names(mesh, [triangle])
    return phrases.ON_FACE.format(phrase=text, face=names[0]) if names else text


def _at_edges(text, mesh, bad):
    """A Finding at the triangles with an edge whose number of triangles is bad."""
    if mesh is None:
        return Finding(text)
    triangles = np.asarray(mesh.triangles)
    sides = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, edge, uses = np.unique(sides, axis=0, return_inverse=True, return_counts=True)
    where = np.flatnonzero(bad(uses[edge.ravel()]).reshape(-1, 3).any(axis=1))
    return Finding(text, _names(mesh, where), _corners(mesh, where[0]) if len(where) else ())


def _names(mesh, triangles):
    """The faces of triangles, each once; none of a mesh that comes from no shape."""
    known = len(getattr(mesh, "triangle_face", ())) > 0
    return tuple(f"Face{face + 1}" for face in dict.fromkeys(mesh.triangle_face[triangles].tolist())) \
        if known else ()


def _corners(mesh, triangle):
    """The corners of a triangle in the document's frame."""
    return tuple(map(tuple, (mesh.vertices[mesh.triangles[triangle]] + mesh.origin).tolist()))
