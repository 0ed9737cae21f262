# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Repaired Mesh": a mesh of the document without its faults."""

import re

from .. import fault_phrases, options, phrases
from ..core.certify import verdict
from ..core.repair import run_repair
from ..core.sources import convert
from ..errors import InvalidInput
from . import offset, transactions


class RepairedMesh(offset.SolidMesh):
    """Proxy of a Mesh::FeaturePython that holds the mesh of its source, repaired."""

    COMMAND, CALL = "MeshQuality_Repair", "add_repaired_mesh"
    SOURCE, NEEDS = "The object whose mesh is repaired", "a mesh"
    OPTIONS = options.repair.REPAIR_OBJECT

    @classmethod
    def compute(cls, given, values, progress):
        """The mesh and what belongs to it."""
        mesh = run_repair(given.operands, values, progress)
        return mesh, mesh.to_mesh(), verdict.of_boolean(mesh), given

    def told(self, obj):
        """A Text on the repairs, but for crossing triangles; None without any."""
        done = [part for text in obj.Repaired for part in _parts(text.removeprefix("operand A: "))]  # there is no other one
        return phrases.Text(fault_phrases.REPAIRS, list=done) if done else None


def _parts(text):
    """What the core says of repairs, such as "2 holes closed (4 triangles), 1 vertex welded", as phrases."""
    for part in text.split(", "):
        places = dict(zip(("count", "count2"), re.findall(r"\d+", part)))
        forms = {form.format_map({"count2": "", **places}): form for pair in fault_phrases.DONE for form in pair}
        forms[fault_phrases.ONE_HOLE] = fault_phrases.ONE_HOLE
        yield phrases.Text(forms.get(part, part), **places)


def add_repaired_mesh(source, tolerance=None):
    """Adds a document object that keeps the mesh of `source` repaired; one undo step.

    source     document object with a mesh
    tolerance  as for repair

    The property Repaired says what was put right. Returns the object. Raises what repair raises, and then adds nothing.
    """
    if not convert.is_mesh(source):
        raise InvalidInput(f"a document object with a mesh is needed, not {getattr(source, 'Label', type(source).__name__)}")
    return transactions.add_of_source(RepairedMesh, source, {"tolerance": tolerance}, "RepairedMesh", "Repair mesh",
                                      "repaired")
