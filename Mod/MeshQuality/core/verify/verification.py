# SPDX-License-Identifier: LGPL-2.1-or-later
"""verify: whether what a saved certificate says of a mesh holds, checked again by other means."""

import os

import numpy as np

from ... import options
from ...errors import Cancelled, IoError
from ...listing import Public
from ..certify import saved_certificate
from ..certify.certification import is_between_solids, sides_of_surface
from ..certify.saved_certificate import CLAIMS
from ..elements import bodies, hanging, kinds
from ..elements.cut_surface import triangles_of_surface
from ..meshes.element_mesh import ElementMesh
from ..sources import convert
from . import crossing_verifier, distance_verifier, verifier

_NAMED = 5  # elements that are named of each fault
_AT_A_TIME = 5000  # elements between two calls of progress


class CertificateVerification(metaclass=Public):
    """Which claims of a saved certificate hold.

    holds     whether all of it does
    faults    sentences: what does not hold
    elements  how many elements were looked at again
    shown     how many of these are what the certificate says, valid, folded or inverted
    notes     sentences: what was not checked again
    """

    __slots__ = {"elements": "how many were looked at", "faults": "sentences: what does not hold",
                 "notes": "sentences: what was not checked again", "shown": "how many are what the certificate says"}

    def __init__(self):
        self.faults, self.notes, self.elements, self.shown = [], [], 0, 0

    @property
    def holds(self):
        """Whether all of it does."""
        return not self.faults

    def to_dict(self):
        """For JSON."""
        return {name: getattr(self, name) for name in ("holds", "elements", "shown", "faults", "notes")}

    def __str__(self):
        lines = [f"elements     {self.elements:,}, {self.shown:,} of them shown again to be what the certificate says"]
        return "\n".join([*lines, *(f"note         {note}" for note in self.notes)]) + "\n"

    def __repr__(self):
        return f"<CertificateVerification: {'all holds' if self.holds else f'{len(self.faults):,} faults'}>"


def verify(certificate, mesh=None, progress=None):
    """Checks a saved certificate again: a CertificateVerification.

    certificate  the path of a file of MeshCertificate.save or `meshquality certify --save`
    mesh         the path of the mesh, where it is not where the certificate says
    progress     as for curve

    The mesh must be the same bytes. A verifier that shares no code with the prover shows every element again to be what
    the certificate says, and that curved triangles of the surface are apart, see docs/method/given.md. Distances are measured
    again from the CAD file that the certificate names.
    Raises IoError where a file is not there, InvalidInput where it is no certificate; Cancelled.
    """
    options.require_callable(progress)
    content, found = saved_certificate.load(certificate), CertificateVerification()
    folder = os.path.dirname(os.path.realpath(os.fsdecode(convert.file_name(certificate))))
    path = os.path.join(folder, content["mesh"]["file"]) if mesh is None else os.fsdecode(convert.file_name(mesh))
    if saved_certificate.digest_of(path)["sha256"] != content["mesh"]["sha256"]:
        found.faults.append(f"the mesh '{path}' is not the file that was certified: its SHA-256 is another one")
    cad = None if content["cad"] is None else _check_cad(content["cad"], folder, found)
    mesh = ElementMesh.read(path, saved_certificate.scale_of(content))
    blocks = [(block, kinds.DIMENSION[block.kind] == mesh.dimension) for block in mesh.blocks]
    _check_blocks(blocks, mesh.nodes, content, found, progress)
    _check_sums(content, found)
    found.faults += [f"the certificate does not say {name}: certify the mesh again" for name in saved_certificate.missing(content)]
    _check_conformity(mesh, [block for block, checked in blocks if checked], content["proven"], found)
    _check_overlaps(mesh, content, found)
    _check_crossings(mesh.nodes, sides_of_surface(mesh), content, found, progress)
    _check_distances(mesh, cad, content, found, progress)
    return found


def _check_cad(said, folder, found):
    """The path of the CAD file; None if it is missing or has another content."""
    path = os.path.join(folder, said["file"])
    if not os.path.isfile(path):
        found.notes.append(f"the CAD file '{path}' is not there: it was not compared")
    elif saved_certificate.digest_of(path)["sha256"] != said["sha256"]:
        found.faults.append(f"the CAD file '{path}' is not the one that was measured against: its SHA-256 is another one")
    else:
        return path
    return None


def _check_overlaps(mesh, content, found):
    """Each point that is said to be inside of two elements is inside of both, and no body lies in another that is not listed."""
    said, listed = content["proven"]["overlapping_bodies"], content.get("overlaps", [])
    if mesh.dimension < 3:
        if said is not None or listed:
            found.faults.append(f"the certificate says overlapping_bodies = {said!r}, but there are no volumes")
        return
    whole = bodies.solids(mesh.blocks)
    body = bodies.of_elements(whole)
    pairs = set()
    for first, second, point in listed:
        elements = [_element(whole, number) for number in (first, second)]
        if None in elements or not all(bodies.holds(*element, mesh.nodes, point) for element in elements):
            found.faults.append(f"elements {first} and {second} are certified to have a point in common, which is not inside of both")
        else:
            pairs.add(frozenset((int(body[first]), int(body[second]))))
    if said != len(pairs):
        found.faults.append(f"the certificate says overlapping_bodies = {said!r}, but lists {len(pairs):,} such pairs that hold")
    others = {frozenset(pair[:2]) for pair in bodies.inside_others(mesh.blocks, mesh.nodes)} - pairs
    if others:
        found.faults.append(f"the certificate says overlapping_bodies = {said!r}, but {len(others):,} more pairs lie in one another")


def _element(whole, number):
    """(block, its element) of an element by its number from block to block; None: there is no such one."""
    for block in whole:
        if number < len(block.nodes):
            return block, number
        number -= len(block.nodes)
    return None


def _check_crossings(nodes, sides, content, found, progress):
    """The pairs that the certificate lists cross, or are left open; all others are apart."""
    proven, said = content["proven"], content.get("surface", {})
    word = "triangles" if all(kind == "triangle" for kind, *_ in sides) else "sides"
    crossing, open_ones, touching = (list(map(tuple, said.get(name, ()))) for name in saved_certificate.PAIRS)
    for name, pairs in (("curved_intersections", crossing), ("not_proven_apart", open_ones)):
        if proven.get(name) != len(set(pairs)):
            found.faults.append(f"the certificate says {name} = {proven.get(name)!r}, but lists {len(set(pairs)):,} such pairs")
    pairs, verdict = crossing_verifier.examine(nodes, sides, crossing, open_ones + touching, progress)
    listed = set(crossing)
    wrong, open_count = [], 0
    for pair, only in zip(touching, crossing_verifier.touch_only(nodes, sides, touching)):
        wrong += [] if only else [f"{word} {pair[0]} and {pair[1]} of the surface are certified to touch only, but that could not be "
                                  "shown"]
    for pair, what in zip(map(tuple, pairs.tolist()), verdict.tolist()):
        if pair in listed:
            wrong += [f"{word} {{}} and {{}} of the surface are certified to cross, but are apart"] * (what == crossing_verifier.APART)
            open_count += what == crossing_verifier.UNKNOWN
        else:
            why = "cross" if what == crossing_verifier.CROSSING else "could not be shown to be"
            wrong.append(f"{word} {{}} and {{}} of the surface are certified apart, but {why}")
        wrong = [text.format(*pair) if "{}" in text else text for text in wrong]
    found.faults += wrong[:_NAMED]
    if len(wrong) > _NAMED:
        found.faults.append(f"and {len(wrong) - _NAMED:,} more pairs of {word} likewise")
    if open_count:
        found.notes.append(f"{open_count:,} of the pairs of {word} that cross by the certificate were not shown again to do so")
    if open_ones:
        found.notes.append(f"{len(open_ones):,} pairs of {word} that the certificate leaves open were not looked at")


def _check_distances(mesh, cad, content, found, progress):
    order, nodes, surface = triangles_of_surface(mesh)
    proven, said = content["proven"], content.get("surface", {})
    claims = [name for name in ("max_deviation", "cad_deviation") if proven.get(name) is not None]
    if said.get("turning") and (cad is None or "max_deviation" not in claims or surface is None
                                or max(said["turning"]) >= len(surface) or mesh.dimension == 3):
        found.faults.append("the certificate says that triangles follow their CAD faces, which cannot be shown again: put the CAD "
                            "file where the certificate says, or certify the mesh again")
        return
    if content["cad"] is not None:
        found.faults += _faults_of_not_measured(mesh, surface, proven)
        if surface is not None and proven["cad_deviation"] is None:
            found.faults.append("the certificate does not say how far the shape is from the mesh: certify the mesh again")
    if not claims and proven["not_on_shape"] is None:
        return
    claims = claims or ["not_on_shape"]
    if cad is None and content["cad"] is not None:
        found.notes.append("the distance from the shape was not looked for again")
        return
    if cad is None or surface is None:
        found.faults.append(f"the certificate says {claims[0]} = {proven[claims[0]]!r}, which cannot be shown again without the CAD "
                            "file that was measured against: put it where the certificate says, or certify the mesh again")
        return
    if cad.lower().endswith(".fcstd"):
        found.notes.append(f"the distance from the shape was not looked for again: '{cad}' is a document; export the part as .step or "
                           ".brep, and certify with that file")
        return
    shape = _shape_in(cad)
    if "max_deviation" in claims:
        found.faults += distance_verifier.faults_of(shape, nodes, surface, said, proven, progress)
    if proven["not_on_shape"] is not None and proven["max_deviation"] is None:
        far, nothing = distance_verifier.largest(shape, nodes, surface, progress)
        if far <= nothing:
            found.faults.append(f"the certificate says not_on_shape = {proven['not_on_shape']!r}, which cannot be shown: no point of the "
                                f"surface was found more than {nothing:.3g} mm from the shape")
    if "cad_deviation" in claims:
        listed = [block.nodes for block in mesh.blocks if block.kind == "triangle" and block.order == order]
        rows = np.concatenate([surface, *listed]) if mesh.dimension == 3 else surface
        found.faults += distance_verifier.cad_faults(shape, nodes, rows, said, proven)


def _faults_of_not_measured(mesh, surface, proven):
    """Whether it says of all that can be measured either the figure or why there is none."""
    said = proven["not_on_shape"]
    if proven["max_deviation"] is not None:
        text = f"the certificate says not_on_shape = {said!r}, and yet max_deviation = {proven['max_deviation']!r}"
        return [] if said is None else [text]
    if said is None and surface is not None and not is_between_solids(mesh):
        return ["the certificate says neither how far the surface is from the shape nor why that was not measured: certify the mesh "
                "again"]
    return []


def _shape_in(path):
    import Part

    try:
        return Part.read(path)
    except Exception as error:  # whatever OpenCASCADE says of a file that it does not read
        raise IoError(f"cannot read '{path}': {error}; certificates are verified against .step, .iges and .brep") from error


def _check_blocks(blocks, nodes, content, found, progress):
    said, turning = content["blocks"], content.get("surface", {}).get("turning", [])
    present = [(block.kind, block.order, len(block.nodes) if checked else 0) for block, checked in blocks]
    claimed = [(block["kind"], block["order"], block["elements"]) for block in said]
    if present != claimed:
        found.faults.append(f"the mesh has other elements than the certificate: {_in_words(present)} instead of "
                            f"{_in_words(claimed)}")
        return
    total, done = max(sum(count for _, _, count in present), 1), 0
    for (block, checked), claims in zip(blocks, said):
        if not checked:
            continue
        verdict = np.zeros(len(block.nodes), dtype=int)
        for number, claim in enumerate(CLAIMS, 1):
            verdict[claims[claim]] = number
        examined = []
        for start in range(0, len(block.nodes), _AT_A_TIME):
            if progress is not None and progress(done / total, "elements") is False:
                raise Cancelled("the verification was cancelled")
            part = slice(start, start + _AT_A_TIME)
            examined.append(verifier.examine(block.kind, block.order, nodes, block.nodes[part], verdict[part] == 2))
            done += len(examined[-1][0])
        J, distortion = map(np.concatenate, zip(*examined))
        if block.kind == "triangle" and turning and max(turning) < len(J):
            J[turning], distortion[turning] = verifier.POSITIVE, np.inf  # those are compared with the CAD
        _compare(block.kind, verdict, np.array(claims["distortion"]), J, distortion, found)


def _in_words(blocks):
    return ", ".join(f"{count:,} {kinds.PLURALS.get(kind, kind)} of order {order}" for kind, order, count in blocks if count)


def _compare(kind, verdict, bound, J, distortion, found):
    """The claims of a block with what J was found to be; of inverted elements J has the other sign."""
    valid, folded, inverted = (verdict == number for number in range(3))
    kept = [(valid & (J < verifier.POSITIVE), "certified valid, but {}"),
            (folded & (J != verifier.NEGATIVE) & (J != verifier.TOUCHING), "certified folded, but no point with J <= 0 was found"),
            (inverted & (J < verifier.POSITIVE), "certified inverted, but J < 0 everywhere could not be shown"),
            (valid & (bound > distortion), "certified with a better bound of distortion than it can have"),
            (~valid & ~(bound <= 0.0), "certified not valid, but with a bound of distortion above 0")]
    for wrong, text in kept:
        for i in np.flatnonzero(wrong)[:_NAMED]:
            why = "there is a point with J <= 0" if J[i] in (verifier.NEGATIVE, verifier.TOUCHING) else "that could not be shown"
            found.faults.append(f"{kind} {i} is {text.format(why)}")
        if wrong.sum() > _NAMED:
            more = int(wrong.sum()) - _NAMED
            found.faults.append(f"and {more:,} more {kinds.PLURALS[kind] if more != 1 else kind} likewise")
    found.elements += len(verdict)
    found.shown += int((~(kept[0][0] | kept[1][0] | kept[2][0] | (verdict == 3))).sum())


def _check_sums(content, found):
    """Whether the figures at the head are those of the lists."""
    proven, blocks = content["proven"], content["blocks"]
    counted = {claim: sum(len(block[claim]) for block in blocks) for claim in CLAIMS}
    counted["invalid"] = sum(counted.values())
    for name, count in counted.items():
        if proven.get(name) != count:
            found.faults.append(f"the certificate says {name} = {proven.get(name)!r}, but lists {count:,} such elements")
    elements = {}
    for block in blocks:
        if block["elements"]:
            elements[block["kind"]] = elements.get(block["kind"], 0) + block["elements"]
    if proven.get("elements") != elements:
        found.faults.append(f"the certificate says elements = {proven.get('elements')!r}, but lists {elements!r}")
    lowest = min((min(block["distortion"]) for block in blocks if block["elements"]), default=None)
    said = proven.get("min_distortion")
    if isinstance(said, bool) or not isinstance(said, (int, float)) or lowest is None or not lowest <= said < lowest + 2e-4:
        found.faults.append(f"the certificate says min_distortion = {said!r}, but the smallest that it lists is {lowest!r}")


def _check_conformity(mesh, blocks, proven, found):
    """Counts the faces by their corners and orientations, again."""
    dimension, oriented = mesh.dimension, True
    conforming = not hanging.hangs(blocks, mesh.nodes)
    seen, whole = {}, set()
    for block in blocks:
        for corners in block.nodes[:, :kinds.CORNERS[block.kind]].tolist():
            first = corners.index(min(corners))
            corners = frozenset(corners) if dimension == 3 else (*corners[first:], *corners[:first])
            conforming = conforming and corners not in whole
            whole.add(corners)
        sides = kinds.FACES[block.kind] if dimension == 3 else kinds.EDGES[block.kind]
        for side in sides:
            for corners in block.nodes[:, list(side)].tolist():
                seen.setdefault(tuple(sorted(corners)), []).append(_way(corners))
    for ways in seen.values():
        if len(ways) > 2:
            conforming = conforming and dimension == 2
        elif len(ways) == 2 and ways[0] == ways[1]:
            oriented = False
    if dimension == 2 and any(len(ways) > 2 for ways in seen.values()):
        oriented = True  # sheets that meet have no common side
    for name, value in (("conforming", conforming), ("oriented", oriented)):
        if proven.get(name) != value:
            found.faults.append(f"the certificate says {name} = {proven.get(name)!r}, but it is {value}")


def _way(corners):
    """Whether a side, or an edge, is oriented one way or the other."""
    first = corners.index(min(corners))
    return corners[(first + 1) % len(corners)] < corners[first - 1] if len(corners) > 2 else corners[0] < corners[1]
