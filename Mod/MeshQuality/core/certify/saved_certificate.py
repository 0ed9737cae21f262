# SPDX-License-Identifier: LGPL-2.1-or-later
"""Certificates of meshes in files: JSON that says of which file what was proven, by which program."""

import hashlib
import json
import math
import os

import numpy as np

from ... import files
from ...errors import InvalidInput, IoError
from ...version import __version__
from ..meshes.writing import atomically
from ..sources import convert

FORMAT, VERSION = "MeshQuality mesh certificate", 1
CLAIMS = ("folded", "inverted", "not_proven")  # claims in the order of the core's verdicts 1, 2 and 3
PAIRS = ("crossing", "not_proven_apart", "touching")  # lists of pairs of triangles of the surface
GRIDS = {"face_grids": 7, "edge_grids": 4}  # grids of measured points of the CAD: how many numbers each grid has
OF_SHAPE = ("max_deviation", "folded_on_cad", "cad_deviation", "cad_spacing", "not_on_shape")  # claims on the shape
# Numbers that may be None: not searched, or not measured.
MEASURED = (*OF_SHAPE[:-1], "curved_intersections", "not_proven_apart", "overlapping_bodies")
_CLAIMS = ("elements", "invalid", *CLAIMS, "min_distortion", "conforming", "oriented", *MEASURED, "not_on_shape")
_MOST_STEPS = 10_000  # steps of a grid along one parameter
_LARGEST = 1e9  # largest number of faces, and largest measure in mm
_DIGITS = 4  # digits of the bounds; rounded down, so that they stay bounds
_PLACES = 9  # decimal places of distances in mm, rounded up


def digest_of(path):
    """{"file": absolute path, "sha256", "bytes"} of a file; raises IoError."""
    found, size = hashlib.sha256(), 0
    try:
        with files.open_regular(path) as stream:
            for block in iter(lambda: stream.read(2**20), b""):
                found.update(block)
                size += len(block)
    except OSError as error:
        raise IoError(f"cannot read '{path}': {error.strerror or error}") from error
    return {"file": os.path.realpath(path), "sha256": found.hexdigest(), "bytes": size}


def save(certificate, path, cad=None):
    """Writes a MeshCertificate; see its `save`."""
    if certificate._source is None:
        raise InvalidInput("the certificate is of a mesh that was in no file: give certify the path of one, then save it")
    name = os.fsdecode(convert.file_name(path))
    folder = os.path.dirname(os.path.realpath(name))
    content = {
        "format": FORMAT, "version": VERSION, "program": f"MeshQuality {__version__}",
        "mesh": _relative(certificate._source, folder),
        "cad": None if cad is None else _relative(digest_of(os.fsdecode(convert.file_name(cad))), folder),
        "options": {"scale": certificate._scale},
        "proven": {name: value for name, value in certificate.to_dict().items() if name != "invalid_elements"},
        "blocks": [_block(*block) for block in certificate._blocks],
        "surface": _surface(certificate, cad is not None),
        "overlaps": [[*map(int, pair[:2]), list(pair[2])] for pair in certificate._overlaps],
    }
    if cad is None:
        content["proven"].update(dict.fromkeys(OF_SHAPE))
    text = json.dumps(content, allow_nan=False) + "\n"

    def write(ready):
        with open(ready, "w", encoding="ascii") as stream:
            stream.write(text)

    atomically(name, ".json", write)


def _relative(digest, folder):
    try:
        return {**digest, "file": os.path.relpath(digest["file"], folder)}
    except ValueError:  # another drive
        return digest


def _block(kind, order, verdict, low):
    """A block's claims: which elements are not valid, and the bound of distortion of each."""
    rounded = np.floor(low * 10.0**_DIGITS) / 10.0**_DIGITS
    return {"kind": kind, "order": order, "elements": len(verdict),
            **{claim: np.flatnonzero(verdict == number).tolist() for number, claim in enumerate(CLAIMS, 1)},
            "distortion": [round(value, _DIGITS) for value in rounded.tolist()]}


def _surface(certificate, measured):
    """What is said of the triangles of the surface: pairs of them, by index, those that are valid as they follow the CAD face,
    and of each its CAD face and its distance.
    """
    content = {name: [list(pair) for pair in pairs] for name, pairs in zip(PAIRS, certificate._crossings)}
    content["turning"] = list(certificate._turning)
    if measured and certificate.triangle_face is not None:
        up = [math.ceil(value * 10.0**_PLACES) / 10.0**_PLACES for value in certificate.triangle_deviation.tolist()]
        content.update(face=certificate.triangle_face.tolist(), deviation=[round(value, _PLACES) for value in up],
                       folded_on_cad=list(certificate._folded_on_cad))
    if measured:
        content.update({name: [list(grid) for grid in grids] for name, grids in zip(GRIDS, certificate._grids)})
    return content


def _refuse(constant):
    raise ValueError(f"{constant} is no number")


def load(path):
    """The content of a saved certificate; raises IoError, InvalidInput naming what is wrong with it."""
    name = os.fsdecode(convert.file_name(path))
    try:
        with files.open_regular(name) as stream:
            content = json.loads(stream.read().decode(), parse_constant=_refuse)
    except OSError as error:
        raise IoError(f"cannot read '{name}': {error.strerror or error}") from error
    except (ValueError, RecursionError) as error:
        raise InvalidInput(f"'{name}' is no certificate of a mesh: it is not JSON, {error}") from error
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise InvalidInput(f"'{name}' is no certificate of a mesh: give a file that certificate.save or certify --save wrote")
    if content.get("version") != VERSION:
        raise InvalidInput(f"'{name}' is a certificate of version {content.get('version')!r}, this program knows version "
                           f"{VERSION}: take a newer MeshQuality")
    fault = _fault_of(content)
    if fault:
        raise InvalidInput(f"the certificate '{name}' is damaged: {fault}; certify the mesh again")
    return content


def _fault_of(content):
    """The first fault of the content: an entry that is missing or of another type; None without one."""
    for part in ("mesh", "cad"):
        said = content.get(part, "")
        if not (part == "cad" and said is None) and not _is_file(said):
            return f"'{part}' does not name a file with its SHA-256"
    if not _is_scale(content.get("options", {"scale": 1.0})):
        return "'options' has no scale of the mesh greater than 0"
    proven, blocks = content.get("proven"), content.get("blocks")
    if not isinstance(proven, dict) or not isinstance(blocks, list):
        return "'proven' or 'blocks' is missing"
    for name in MEASURED:
        if not _is_measure(proven.get(name)):
            return f"'{name}' is neither a number from 0 on nor left open"
    if not isinstance(proven.get("not_on_shape"), (str, type(None))):
        return "'not_on_shape' is no text"
    for number, block in enumerate(blocks):
        if not isinstance(block, dict) or not _is_block(block):
            return f"block {number} is not complete"
    if not _is_overlaps(content.get("overlaps", [])):
        return "'overlaps' does not list pairs of elements with a point"
    return None if _is_surface(content.get("surface", {})) else "'surface' is not complete"


def missing(content):
    """Names of claims that a loaded certificate lacks, as of an older version or after editing; sets these claims to None.
    """
    proven, surface = content["proven"], content.setdefault("surface", {})
    found = [name for name in _CLAIMS if name not in proven]
    found += [name for name in ("options", "overlaps") if name not in content]
    found += [f"surface.{name}" for name in (*PAIRS, "turning") if name not in surface]
    if content["cad"] is not None and all(proven.get(name) is None for name in OF_SHAPE):
        found.append("how far the mesh is from the CAD file that it names")
    if content["cad"] is None and any(proven.get(name) is not None for name in OF_SHAPE):
        found.append("from which CAD file its distances are")
    for name in _CLAIMS:
        proven.setdefault(name)
    return found


def _is_overlaps(said):
    return isinstance(said, list) and all(
        isinstance(pair, list) and len(pair) == 3 and all(map(_is_count, pair[:2])) and isinstance(pair[2], list)
        and len(pair[2]) == 3 and all(isinstance(x, (int, float)) and not isinstance(x, bool) and abs(x) < _LARGEST for x in pair[2])
        for pair in said)


def _is_surface(said):
    """Whether what is said of the surface is of the types that it must be of; certificates may say nothing of it."""
    if not isinstance(said, dict) or ("face" in said) != ("deviation" in said):
        return False
    pairs = [said.get(name, []) for name in PAIRS]
    if not all(isinstance(part, list) and all(isinstance(pair, list) and len(pair) == 2 and all(map(_is_count, pair))
                                              for pair in part) for part in pairs):
        return False
    faces, turning, deviations = (said.get(name, []) for name in ("face", "turning", "deviation"))
    if not all(_is_grids(said.get(name, []), width) for name, width in GRIDS.items()):
        return False
    if not isinstance(said.get("folded_on_cad", []), list) or not all(map(_is_count, said.get("folded_on_cad", []))):
        return False
    return all(isinstance(part, list) for part in (faces, turning, deviations)) and all(map(_is_count, [*faces, *turning])) \
        and all(isinstance(value, (int, float)) and not isinstance(value, bool) and 0 <= value < math.inf
                for value in deviations)


def _is_grids(said, width):
    """Whether each begins with the number of a face or an edge and ends with numbers of steps."""
    whole = 2 if width == max(GRIDS.values()) else 1
    return isinstance(said, list) and all(
        isinstance(grid, list) and len(grid) == width and _is_count(grid[0])
        and all(_is_count(steps) and 0 < steps <= _MOST_STEPS for steps in grid[-whole:])
        and all(isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value) for value in grid[1:-whole])
        for grid in said)


def _is_file(said):
    return isinstance(said, dict) and isinstance(said.get("file"), str) and isinstance(said.get("sha256"), str) \
        and said["file"].isprintable()


def _is_measure(value):
    return value is None or (isinstance(value, (int, float)) and not isinstance(value, bool) and 0 <= value < _LARGEST)


def _is_scale(options):
    scale = options.get("scale") if isinstance(options, dict) else None
    return isinstance(scale, (int, float)) and not isinstance(scale, bool) and 1.0 / _LARGEST < scale < _LARGEST


def scale_of(content):
    """The factor from the coordinates of the file to mm of a loaded certificate."""
    return content.get("options", {"scale": 1.0})["scale"]


def _is_block(block):
    count = block.get("elements")
    if not isinstance(block.get("kind"), str) or not _is_count(block.get("order")) or not _is_count(count):
        return False
    lists = [block.get(claim) for claim in CLAIMS]
    if not all(isinstance(said, list) and all(_is_count(i) and i < count for i in said) for said in lists):
        return False
    bounds = block.get("distortion")
    return isinstance(bounds, list) and len(bounds) == count and all(
        isinstance(value, (int, float)) and not isinstance(value, bool) and -1 <= value <= 1 for value in bounds)


def _is_count(value):
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < _LARGEST
