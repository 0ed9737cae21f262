# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a finished mesh meets what was requested: one rule for document objects, the command line and
batches. Imports nothing of documents.

It is about the mesh as it was measured after rounding to single precision, not about the algorithm.
Its sentences are made of the phrases of one table, by which panels translate them.
"""

from dataclasses import asdict, dataclass, replace

import numpy as np

from ... import phrases
from ...compat import extension
from ...phrases import MET, NOT_DECIDED, NOT_MET, Text, counted_list, counted_sentence, first_of
from ..patches.sides_on_edges import edges_of_shape
from ..sizes import RATIO
from ..sources import convert

# Elements whose shape is distorted more than this are a finding. The inverse of the distortion is the shape metric of
# Knupp 2001, so that 10 is a metric of 0.1. The map from the regular tetrahedron then stretches at least 13 times more one
# way than another (needles; flat ones 58 times), and with that grow the errors of gradients and the condition of stiffness
# matrices. A triangle of 10 has a corner of 3.3 degrees.
SHAPE_DISTORTION_LIMIT = 10.0

UNKNOWN = "unknown: the mesh was made by an older version; update it"
NOT_COMPUTED = "unknown: the mesh could not be computed with these options and sources"
_OLD_MET, _OLD_NOT_MET = "kept", "missed: "  # words in documents of older versions
_TARGETS = {NOT_MET: phrases.TARGET_NOT_MET, NOT_DECIDED: phrases.TARGET_NOT_DECIDED}
_NAMED = 3  # elements or faces that a sentence names
_NO_VOLUME = 1e-9  # share of the area to the power 3/2 that a sheet with two sides encloses by rounding
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
    decided whether it is not met; else the measurement is too coarse to tell
    """

    text: str
    faces: tuple = ()
    place: tuple = ()
    forced: bool = False
    decided: bool = True


def word(findings):
    """"met", "not met", or "not decided" where the measurement is too coarse to tell."""
    if any(finding.decided for finding in findings):
        return NOT_MET
    return NOT_DECIDED if findings else MET


def sentence(findings):
    """The text of the property Certificate."""
    phrase = phrases.NOT_MET_TEXT if word(findings) == NOT_MET else phrases.NOT_DECIDED_TEXT
    return Text(phrase, text=_joined(findings)) if findings else MET


def _joined(findings):
    """The sentences of all findings, to stand after a colon."""
    return phrases.lower_first(phrases.joined(*(finding.text for finding in findings)))


def is_met(certificate):
    """Whether a Certificate, also of an older version, says that all limits are met."""
    return certificate in (MET, _OLD_MET)


def is_missed(certificate):
    """Whether a Certificate says that some limits are not met."""
    return certificate.startswith((NOT_MET, _OLD_NOT_MET))


def is_open(certificate):
    """Whether a Certificate says that the measurement is too coarse to decide."""
    return certificate.startswith(NOT_DECIDED)


def said(certificate):
    """The limits that a Certificate names as not met or not decided."""
    if isinstance(certificate, Text):
        return certificate.places["text"]
    for start in (f"{NOT_MET}: ", f"{NOT_DECIDED}: ", _OLD_NOT_MET):
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


def line(label, report, findings, say=str):
    """One line for people about a finished mesh: its figures, and whether all requested limits are met.

    say   say(text that a phrase of `phrases` fits) -> text in the user's language and units
    """
    verdict = Text(_TARGETS[word(findings)], text=_joined(findings)) if findings else Text(phrases.ALL_MET)
    hint = f" {say(phrases.sentence(Text(phrases.OVERLAPS_HINT)))}" if getattr(report, "overlaps", 0) > 0 else ""
    figures = map(say, getattr(report, "figures", lambda: _figures(report))())
    return f"{label}: {', '.join(figures)}; {say(verdict)}{hint}"


def _figures(report):
    """The figures of a MeshReport, BooleanReport or CurveReport in that line."""
    if curved := hasattr(report, "elements"):
        yield counted_sentence(phrases.ELEMENTS, report.elements)
        yield Text(phrases.MAX_DISTORTION, number=_number(report.max_shape_distortion))
        yield Text(phrases.MAX_DEVIATION, length=_length(_rounded(report.max_deviation)))
    else:
        yield counted_sentence(phrases.TRIANGLES, report.triangles)
        if report.triangles:
            yield Text(phrases.SMALLEST_ANGLE, number=_rounded(report.min_angle))
        if hasattr(report, "error_bound"):
            yield Text(phrases.MAX_DEVIATION, length=_length(_rounded(report.error_bound)))
        elif report.max_chord_height >= 0:
            yield Text(phrases.MAX_DEVIATION, length=_length(_rounded(report.max_chord_height)))
    if report.overlaps > 0 and not (curved and all(pair[2] == "near" for pair in report.overlapping_bodies)):
        yield counted_sentence(phrases.OVERLAPS, report.overlaps)
    if getattr(report, "not_proven_apart", 0) > 0:
        yield counted_sentence(phrases.NOT_PROVEN_APART, report.not_proven_apart)


def must_be_closed(shape):
    """Whether all faces of the shape belong to solids."""
    return bool(shape.Solids) and sum(len(solid.Faces) for solid in shape.Solids) >= len(shape.Faces)


def of_triangulation(mesh, closed, values=None, shape=None):
    """Findings of a SurfaceMesh that triangulate made of the shape with these options."""
    return [*angles(mesh), *deviation(mesh), *edges(mesh, values or {}, shape), *_sizes(mesh.report), *_incomplete(mesh.report),
            *_missing_faces(mesh.report), *topology(mesh.report, closed, mesh), *_crossings(mesh.report),
            *_overlapping_bodies(mesh.report, values)]


def of_improvement(mesh, closed, progress=None):
    """Findings of a SurfaceMesh that improve or simplify made; `closed`: whether the mesh before it was; progress as for improve."""
    return [*angles(mesh), *topology(mesh.report, closed, mesh), *_crossing_pairs(mesh, progress)]


def of_boolean(mesh):
    """Findings of a BooleanMesh. An empty one has none."""
    report = mesh.report
    found = _too_far(report.error_bound, report.tolerance_asked, phrases.SHAPE_DISTANCE)
    if report.guessed_share > 0.0:
        found.append(Finding(_sentence(phrases.GUESSED, number=f"{100.0 * report.guessed_share:.2g}")))
    if report.faults_left:
        found.append(Finding(counted_sentence(phrases.FAULTS_LEFT, report.faults_left)))
    return found + (topology(report, True, mesh) if report.triangles else [])


def of_curved(curved, closed, values=None, corners=None, shape=None):
    """Findings of a CurvedMesh that was made of this Part.Shape so; `corners`: those of `topology_of_corners`, if known."""
    return [*elements(curved), *distortion(curved), *_before_curving(curved, values or {}, shape), *_sizes(curved.report),
            *_too_far(curved.report.max_deviation, curved.report.chord_height_asked, phrases.SHAPE_DISTANCE),
            *topology(corners or topology_of_corners(curved), closed), *_crossings(curved.report),
            *_overlapping_bodies(curved.report, values, ("overlapping", "inside", "equal")), *_curved_crossings(curved.report, values)]


def _before_curving(curved, values, shape):
    """Findings of the straight mesh of a CurvedMesh, for which angles and lengths of edges are requested."""
    straight = curved.straight
    if straight is None:
        return []
    return [replace(found, text=_sentence(phrases.BEFORE_CURVING, phrase=phrases.lower_first(found.text)))
            for found in (*angles(straight), *edges(straight, values, shape))]


def topology_of_corners(curved):
    """The MeshReport of the triangles between the corners of a CurvedMesh's triangles. Solids that share triangles each
    count with their own.
    """
    corners = curved.triangles[:, :3]
    last = corners.max(initial=-1) + 1
    points = curved.nodes[:last]
    if curved.straight is not None:
        points, corners = _by_solids(points, corners, curved)
    return convert.surface_of_arrays(extension(), points, corners).report


def _by_solids(points, corners, curved):
    """The points and triangles, once for each solid that they bound."""
    straight, count = curved.straight, len(points)
    first, second = {}, {}
    for face, solid in dict.fromkeys(zip(straight.triangle_face.tolist(), straight.triangle_solid.tolist())):
        (second if face in first else first)[face] = solid
    faces = curved.triangle_face
    behind = curved.triangle_face_behind if len(curved.triangle_face_behind) else np.full(len(faces), -1)
    own = np.array([first.get(face, -1) for face in faces.tolist()])
    other = np.array([first.get(there, -1) if there >= 0 else second.get(face, -1)
                      for face, there in zip(faces.tolist(), behind.tolist())])
    shared = np.flatnonzero(other >= 0)
    if not len(shared):
        return points, corners
    # A triangle between two solids is seen from the one that comes first.
    own[shared], other[shared] = np.minimum(own[shared], other[shared]), np.maximum(own[shared], other[shared])
    keys = np.concatenate((corners + (own[:, None] + 1) * count,
                           corners[shared][:, ::-1] + (other[shared, None] + 1) * count)).astype(np.int64)
    used, numbers = np.unique(keys, return_inverse=True)
    return points[used % count], numbers.reshape(-1, 3).astype(np.int32)


def of_measured(mesh, report, closed):
    """Findings of a mesh of unknown origin with its MeshReport: faults that no mesh should have."""
    return [*topology(report, closed, mesh), *_crossing_pairs(mesh)]


def topology(report, closed, mesh=None):
    """Findings where a mesh is not manifold, inside out, or not closed where it must be; a SurfaceMesh also tells where."""
    found = []
    if closed and not report.closed:
        found.append(_at_edges(counted_sentence(phrases.NOT_CLOSED, report.border_edges), mesh, lambda uses: uses == 1))
    for phrase, count in ((phrases.NONMANIFOLD, report.nonmanifold_edges), (phrases.PINCHED, report.pinched_vertices),
                          (phrases.DEGENERATE, report.degenerate_triangles),
                          (phrases.NOT_ORIENTED, report.misoriented_edges - report.nonmanifold_edges)):
        if count:
            found.append(_at_edges(counted_sentence(phrase, count), mesh, lambda uses: uses > 2))
    if report.closed and report.volume < -_NO_VOLUME * report.area**1.5:
        found.append(Finding(_sentence(phrases.INSIDE_OUT)))
    return found


def angles(mesh):
    """The finding of triangles of a SurfaceMesh below the requested smallest angle."""
    report = mesh.report
    asked = report.min_angle_asked
    if not report.triangles or report.min_angle >= asked:
        return []
    measured = extension().triangle_shapes(mesh._surface)[0]
    worst, below = int(np.argmin(measured)), np.flatnonzero(measured < asked)
    reasons = dict(report.exempt_reasons)
    forced = all(int(triangle) in reasons and reasons[int(triangle)].forced for triangle in below)
    least, limit = _told_apart(report.min_angle, asked)
    said = [_sentence(phrases.ANGLE, number=least, number2=limit, phrase=_triangle(mesh, worst))]
    if worst in reasons:
        said.append(phrases.exempt_sentence(_without_face(reasons[worst]), reasons[worst].forced))
    if len(below) > 1:
        more = phrases.MORE_FORCED if forced else phrases.MORE_BELOW
        said.append(counted_sentence(more, len(below) - 1, number=limit))
    return [Finding(phrases.joined(*said), _names(mesh, below), _corners(mesh, worst), forced)]


def _without_face(reason):
    """The Text of a reason without the face at its end, which the sentence before it names."""
    text = reason.message
    return text.places["phrase"] if text.phrase == phrases.ON_FACE else text


def deviation(mesh):
    """The finding that a SurfaceMesh is too far from the shape, and where it is farthest."""
    report = mesh.report
    worst = report.max_chord_triangle
    if worst < 0:
        return _too_far(report.max_chord_height, report.chord_height_asked, phrases.SHAPE_DISTANCE)
    found = _too_far(report.max_chord_height, report.chord_height_asked, phrases.SHAPE_DISTANCE_AT, phrase=_triangle(mesh, worst))
    return [Finding(finding.text, _names(mesh, [worst]), _corners(mesh, worst)) for finding in found]


def edges(mesh, values, shape=None):
    """The finding that edges of a SurfaceMesh are longer than max_edge or the local sizes allow. `shape`: the
    Part.Shape that was meshed, needed for the sizes of its edges.
    """
    sizes = {"Face": {}, "Edge": {}, "Vertex": {}}
    for name, size in (values.get("local_sizes") or {}).items():
        kind = name.rstrip("0123456789")
        sizes[kind][int(name[len(kind):]) - 1] = size
    if not (any(sizes.values()) or values.get("max_edge")) or not len(mesh.triangles):
        return []
    corners = mesh.vertices[mesh.triangles]
    lengths = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)
    allowed = np.full(lengths.shape, values.get("max_edge") or np.inf)
    for face, size in sizes["Face"].items():
        on_face = np.asarray(mesh.triangle_face) == face
        allowed[on_face] = np.minimum(allowed[on_face], size)
    ends = np.stack((mesh.triangles, np.roll(mesh.triangles, -1, axis=1)), axis=2)
    for vertex, size in sizes["Vertex"].items():
        there = (np.asarray(mesh.vertex_entity)[ends] == (0, vertex)).all(axis=3).any(axis=2)
        allowed[there] = np.minimum(allowed[there], size)
    along = edges_of_shape(mesh, ends, sizes["Edge"], shape) if sizes["Edge"] else np.full(lengths.shape, -1)
    for edge, size in sizes["Edge"].items():
        allowed[along == edge] = np.minimum(allowed[along == edge], size)
    # Rounding to single precision may lengthen an edge by a millionth.
    beyond = np.flatnonzero((lengths > allowed * (1.0 + 1e-5)).any(axis=1))
    if not len(beyond):
        return []
    worst, side = np.unravel_index(np.argmax(lengths / allowed), lengths.shape)
    where = _triangle(mesh, worst)
    if along[worst, side] >= 0:
        where = Text(phrases.ON_EDGE, phrase=where, edge=f"Edge{along[worst, side] + 1}")
    return [Finding(finding.text, _names(mesh, beyond), _corners(mesh, worst)) for finding in _too_far(
        lengths[worst, side], allowed[worst, side], phrases.LONGEST_EDGE, phrase=where)]


def _sizes(report):
    """The finding that edges are longer than a size field allows, and where."""
    ratio, place = getattr(report, "size_ratio", -1.0), getattr(report, "size_ratio_point", ())
    return [] if ratio <= RATIO else [Finding(_sentence(phrases.SIZE_RATIO, number=f"{ratio:.3f}", number2=f"{RATIO:g}",
                                                        phrase=", ".join(f"{c:.6g}" for c in place)))]


def _too_far(measured, asked, phrase, /, **places):
    """The finding that a measured length in mm exceeds the requested one; asked 0: none was."""
    if not asked or measured <= asked:
        return []
    length, limit = map(_length, _told_apart(measured, asked))
    return [Finding(_sentence(phrase, length=length, length2=limit, **places))]


def elements(curved):
    """The finding of elements of a CurvedMesh that are not proven to be free of folds."""
    report = curved.report
    if not report.invalid:
        return []
    filled = len(curved.tetrahedra) > 0
    folded = np.flatnonzero(_folded(curved.tetrahedron_quality if filled else curved.triangle_quality)).tolist()
    named = [_element(curved, element, filled) for element in folded]
    return [Finding(counted_sentence(phrases.FOLDED, report.invalid, count2=str(report.elements), list=first_of(named)),
                    _names(curved, np.flatnonzero(_folded(curved.triangle_quality))), _first_folded(curved))]


def of_curved_elements(mesh):
    """Findings of a CurvedElementMesh."""
    report, found = mesh.report, []
    if report.invalid:
        found.append(Finding(counted_sentence(phrases.FOLDED, report.invalid, count2=str(report.elements),
                                      list=first_of(report.invalid_elements))))
    if not mesh.conforming:
        found.append(Finding(_sentence(phrases.NOT_CONFORMING)))
    return found


def of_thickness(found):
    """Findings of a ThicknessMap: its thinnest wall, where that is below its limit or may be."""
    limit, decided = found.min_thickness, found.decided
    if limit is None or (decided and found.minimum >= found.least_allowed):
        return []
    if decided:
        length, length2 = map(_length, _told_apart(found.minimum, limit))
        places, phrase = {"length": length, "length2": length2}, phrases.NARROW_GAP if found.gap else phrases.THIN_WALL
    else:
        digits = max(_DIGITS, 2 + int(np.log10(max(limit / found.chord_height, 1.0))))  # bounds to a tenth of the deviation
        numbers = (_number(limit, _LIMIT_DIGITS), *(_number(bound, digits) for bound in found.bounds),
                   _rounded(found.chord_height), _rounded(found.deciding_deviation))
        places = {f"length{i}": _length(number) for i, number in zip(("", 2, 3, 4, 5), numbers)}
        phrase = phrases.GAP_NOT_DECIDED if found.gap else phrases.WALL_NOT_DECIDED
    mesh = found.mesh
    corners = (mesh.vertices + mesh.origin)[mesh.triangles[found.minimum_triangle]]
    return [Finding(_sentence(phrase, **places), found.minimum_faces,
                    tuple(tuple(corner) for corner in corners.tolist()), decided=decided)]


def of_clearance(found):
    """Findings of a ClearanceReport: bodies with a volume in common, and the smallest distance where that is below its limit."""
    overlapping = sum(pair.relation in ("overlapping", "inside", "equal") for pair in found.pairs)
    findings = [Finding(counted_sentence(phrases.BODIES_OVERLAP, overlapping))] if overlapping else []
    if found.min_clearance is not None and found.minimum < found.min_clearance:
        length, limit = map(_length, _told_apart(found.minimum, found.min_clearance))
        findings.append(Finding(_sentence(phrases.NARROW_GAP, length=length, length2=limit)))
    return findings


def of_draft(found):
    """Findings of a DraftMap: faces with undercuts, and those with less draft than its bound; a mesh is one face."""
    undercut = [face.face for face in found.faces if face.undercut_area > 0.0]
    low = [face.face for face in found.faces if face.low_area > 0.0]
    findings = []
    if found.undercut_area > 0.0:
        findings.append(Finding(counted_sentence(phrases.UNDERCUTS, len(undercut) or 1), tuple(undercut)))
    if found.low_area > 0.0:
        findings.append(Finding(counted_sentence(phrases.LOW_DRAFT, len(low) or 1, number=f"{found.min_draft:g}"), tuple(low)))
    return findings


def of_voids(found):
    """Findings of a VoidReport: that there are some."""
    faces = tuple(face for void in found.voids for face in void.faces)
    return [Finding(counted_sentence(phrases.HAS_VOIDS, len(found.voids)), faces)] if found.voids else []


def of_deviation(found):
    """Findings of a DeviationMap: its largest deviation, where that is beyond its tolerance, and the faces that have such points."""
    if found.tolerance is None or found.max_deviation <= found.tolerance:
        return []
    beyond = tuple(face.face for face in found.by_face if face.within < 1.0)
    largest, limit = _told_apart(found.max_deviation, found.tolerance)
    return [Finding(_sentence(phrases.BEYOND_TOLERANCE, length=f"{largest} mm", length2=f"{limit} mm",
                              number=_number(100.0 * (1.0 - found.within()))), beyond)]


def of_certificate(certificate):
    """Findings of a MeshCertificate."""
    found = []
    if certificate.invalid:
        found.append(Finding(counted_sentence(phrases.FOLDED, certificate.invalid, count2=str(sum(certificate.elements.values())),
                                      list=first_of(certificate.invalid_elements))))
    if not certificate.conforming:
        found.append(Finding(_sentence(phrases.NOT_CONFORMING)))
    if not certificate.oriented:
        found.append(Finding(_sentence(phrases.ELEMENTS_TURNED)))
    if certificate.overlapping_bodies:
        found.append(Finding(counted_sentence(phrases.OVERLAPPING_BODIES, certificate.overlapping_bodies)))
    if certificate.curved_intersections:
        found.append(Finding(counted_sentence(phrases.CROSSING, certificate.curved_intersections)))
    if certificate.not_on_shape:
        found.append(Finding(_sentence(phrases.NOT_ON_SHAPE, text=certificate.not_on_shape)))
    return found


def _folded(quality):
    """Which elements are not proven valid, by their measured quality; NaN is no proof."""
    return ~(quality > 0.0)


def _first_folded(curved):
    """Corners of the first element that is not proven valid."""
    for quality, nodes in ((curved.triangle_quality, curved.triangles),
                           (curved.tetrahedron_quality, curved.tetrahedra)):
        folded = np.flatnonzero(_folded(quality))
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
    most, limit = _told_apart(values[worst], SHAPE_DISTORTION_LIMIT)
    said = [_sentence(phrases.DISTORTED, number=most, number2=limit, phrase=_element(curved, worst, filled))]
    if count > 1:
        said.append(counted_sentence(phrases.MORE_DISTORTED, count - 1, number=limit))
    corners = (curved.tetrahedra if filled else curved.triangles)[worst, :3]
    return [Finding(phrases.joined(*said), faces, tuple(map(tuple, curved.nodes[corners].tolist())))]


def _element(curved, element, filled):
    """"tetrahedron 7 of Solid1" of a volume mesh, else "triangle 7 on Face3"."""
    if filled:
        return Text(phrases.TETRAHEDRON, count=str(element), solid=f"Solid{curved.tetrahedron_solid[element] + 1}")
    return Text(phrases.ON_FACE, phrase=Text(phrases.TRIANGLE, count=str(element)),
                face=f"Face{curved.triangle_face[element] + 1}")


def _crossing_pairs(mesh, progress=None):
    """The finding of crossing triangles of a SurfaceMesh whose report does not count them."""
    check = None if progress is None else lambda fraction, stage: progress(1.0, "checking")
    count = extension().verify(mesh._surface, check)["crossing pair of triangles"]
    return [Finding(_pairs(count, _COUNTED))] if count else []


def _pairs(count, most):
    """How many pairs of triangles cross; counting ended at the most."""
    if count >= most:
        return _sentence(phrases.CROSSING_MANY, count=f"{most:,}")
    return counted_sentence(phrases.CROSSING, count)


def _crossings(report):
    """The finding of a MeshReport or CurveReport that says which CAD faces cross."""
    if report.self_intersections <= 0:
        return []
    pairs = [tuple(f"Face{face + 1}" for face in crossing[:2]) for crossing in report.crossing_faces]
    said = [_pairs(report.self_intersections, extension().MOST_CROSSINGS)]
    for first, second in pairs[:_NAMED]:
        said.append(Text(phrases.CROSSES_ITSELF, face=first) if first == second
                    else Text(phrases.FACES_CROSS, face=first, face2=second))
    return [Finding(phrases.joined(*said), tuple(dict.fromkeys(face for pair in pairs for face in pair)))]


_SAID_OF_BODIES = {"overlapping": phrases.BODY_OVERLAPS, "inside": phrases.BODY_INSIDE, "equal": phrases.BODY_TWICE,
                   "near": phrases.BODY_NEAR}


def _overlapping_bodies(report, values, kinds=tuple(_SAID_OF_BODIES)):
    """Findings of bodies of the shape that are not apart in the mesh, of these kinds, unless the options allow that.

    Curved elements may be apart where the straight mesh crosses: their own crossings are counted.
    """
    pairs = [pair for pair in report.overlapping_bodies if pair[2] in kinds]
    near = [pair for pair in pairs if pair[2] == "near"]
    deep = [pair for pair in pairs if pair[2] != "near"]
    if (values or {}).get("overlap") == "allow":
        return []
    return [Finding(phrases.joined(counted_sentence(phrase, len(some)), *(
        Text(_SAID_OF_BODIES[how], name=first, name2=second) for first, second, how in some[:_NAMED])))
            for phrase, some in ((phrases.BODIES_OVERLAP, deep), (phrases.BODIES_NEAR, near)) if some]


def _curved_crossings(report, values):
    """The finding of curved elements that are proven to cross; those of different bodies may where the options allow it."""
    count = report.curved_intersections
    if (values or {}).get("overlap") == "allow":
        count -= report.curved_overlaps
    return [Finding(counted_sentence(phrases.CROSSING, count))] if count > 0 else []


def _missing_faces(report):
    """The finding of CAD faces that were left out as they could not be meshed."""
    names = tuple(dict.fromkeys(f"Face{face + 1}" for face, _ in report.missing_faces))
    if not names:
        return []
    return [Finding(counted_list(phrases.MISSING, names), names)]


def _incomplete(report):
    return [] if report.complete else [Finding(phrases.sentence(Text(phrases.LIMIT)))]


def _sentence(phrase, /, **places):
    return phrases.upper_first(Text(phrase, **places))


_ROUNDING = 1e-6
_DIGITS = 3
_LIMIT_DIGITS = 4  # digits of a limit in mm, so that three digits are right in inches, too


def _number(value, digits=_DIGITS):
    """Three digits; of small angles too, but not in powers of ten."""
    return np.format_float_positional(value, precision=digits, fractional=False, trim="-")


def _told_apart(value, limit):
    """The texts of a value and of its limit, with as many digits as tell them apart."""
    if value < _ROUNDING <= limit:
        return "0", _number(limit, _LIMIT_DIGITS)
    pairs = ((_number(value, digits), _number(limit, max(digits, _LIMIT_DIGITS))) for digits in range(_DIGITS, 18))
    return next((shown, bound) for shown, bound in pairs
                if float(shown) != float(bound) and (float(shown) < float(bound)) == (value < limit))


def _rounded(value):
    """The text of a value in mm or degrees; less than a millionth is rounding."""
    return _number(value) if value >= _ROUNDING else "0"


def _length(number):
    return f"{number} mm"


def _triangle(mesh, triangle):
    """"triangle 7 on Face3"; without the face where that is not known."""
    text = Text(phrases.TRIANGLE, count=str(triangle))
    names = _names(mesh, [triangle])
    return Text(phrases.ON_FACE, phrase=text, face=names[0]) if names else text


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
    return tuple(map(tuple, (mesh.vertices[mesh.triangles[triangle]] + mesh.origin).tolist()))
