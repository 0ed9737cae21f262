# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Boolean": a mesh that follows a Boolean of objects of the document."""

import json
from functools import partial

import FreeCAD

from .. import options, phrases
from ..core.booleans import run, tolerance_for
from ..core.certify import verdict
from ..core.operands.operands import Operands
from ..core.sources import frames
from ..errors import Error, InvalidInput
from . import mesh_object, properties, transactions
from .recompute_work import Work


class MeshBoolean(mesh_object.MeshObject):
    """Proxy of a Mesh::FeaturePython that holds a Boolean of its sources."""

    COMMAND, CALL = "MeshQuality_Boolean", "add_boolean"
    OPTIONS = options.BOOLEAN
    MEASURED = (
        *properties.TOPOLOGY,
        properties.VOLUME,
        ("Retained", "App::PropertyInteger", "Triangles taken unchanged from an operand", "retained"),
        ("Reconstructed", "App::PropertyInteger", "Triangles that were created or changed", "reconstructed"),
        ("Repaired", "App::PropertyStringList", "Repairs of the operands", "repaired"),
        properties.BRIDGE,
        properties.NOTES,
    )
    PROMISES = (
        ("AskedTolerance", "App::PropertyLength", "Requested max. deviation from the exact Boolean", "tolerance_asked"),
        ("ErrorBound", "App::PropertyLength", "Max. deviation from the exact Boolean of the meshes", "error_bound"),
        properties.FAULTS_LEFT,
        properties.DEVIATION,
    )
    GROUP, LEAST = "Boolean", 2  # of properties; number of sources
    SOURCES = "The operands: objects with a mesh or a shape, in their order"
    TAKES_MESHES = True
    LINKS = ("Sources", "SourcePaths")

    def sources(self, obj):
        """The Sources, with their paths."""
        paths = [*obj.SourcePaths, *[""] * len(obj.Sources)]
        return [frames.source_of(source, path) for source, path in zip(obj.Sources, paths)]

    def lacks_source(self, obj):
        """FreeCAD takes an operand that is deleted out of the list."""
        return len(obj.Sources) < self.LEAST

    def holds_mesh(self, obj):
        """A Boolean may be empty."""
        return obj.Mesh.CountFacets == obj.Triangles

    def add_properties(self, obj):
        """Adds those properties that the object has not got yet."""
        # Global: operands may lie inside a container that the mesh does not belong to itself.
        properties.add_property(obj, "App::PropertyLinkListGlobal", "Sources", self.GROUP, self.SOURCES)
        properties.add_property(obj, "App::PropertyStringList", "SourcePaths", self.GROUP,
                                 "The path from each source to its operand, where only a link leads there: "
                                 "Part.Box.")
        properties.add_options(obj, self.OPTIONS)
        properties.add_measured(obj, self.MEASURED)
        self.add_common_properties(obj)

    @classmethod
    def work_on(cls, sources, values, obj=None):
        """The Boolean of these sources."""
        if len(sources) < cls.LEAST:
            raise InvalidInput(cls.few(len(sources)))
        values = options.check(cls.OPTIONS, values)
        operands = cls.read(sources)
        return Work(sources, values,
                    lambda: operands.digest() + json.dumps(values, sort_keys=True),
                    partial(cls.compute, operands, values))

    @classmethod
    def size_of(cls, sources):
        """That of all sources together."""
        try:
            return Operands(sources).size()
        except Error:
            return 0.0

    @classmethod
    def kept_length(cls, sources):
        """The tolerance, or that of the resolution."""
        try:
            return tolerance_for(Operands(sources))
        except Error:
            return None

    @classmethod
    def few(cls, count):
        """What is said of too few sources, a Text."""
        one, several = phrases.FEW_SOURCES
        return phrases.Text(one) if count == 1 else phrases.Text(several, count=str(count))

    @classmethod
    def read(cls, sources):
        """What compute takes, read from the document."""
        return Operands(sources)

    @classmethod
    def compute(cls, operands, values, progress):
        """The BooleanMesh of operands that were read, the Mesh.Mesh made of it, and the findings of its
        certificate.
        """
        mesh = run(operands, values, progress)
        return mesh, mesh.to_mesh(), verdict.of_boolean(mesh)

    def take(self, obj, result):
        """Shows the mesh and its report."""
        mesh, shown, findings = result
        self.follow_label(obj)
        return self.show(obj, mesh, shown, True, findings)

    def follow_label(self, obj):
        """Has a label that add_boolean gave follow the first operand and the operation."""
        sources = self.sources(obj)
        given = {transactions.labelled(source, name.replace("_", " ")) for source in sources for name in options.OPERATIONS}
        wanted = transactions.labelled(sources[0], obj.Operation.replace("_", " "))
        bare = obj.Label.rstrip("0123456789")
        if bare in given and bare != wanted:
            obj.Label = wanted


def add_boolean(a, b=None, operation="union", **values):
    """Adds a document object that keeps a Boolean of document objects up to date; one undo step.

    a, b       document objects with a mesh or a shape, of one document; or `a` is a list of them
    operation  as for boolean
    values     the other options of boolean, except progress

    Returns the object. Raises what boolean raises, and then adds nothing.
    """
    if isinstance(b, str):
        raise InvalidInput(f"b = {b!r} is no operand: with a list of operands give operation={b!r}")
    sources = list(a) if b is None and isinstance(a, (list, tuple)) else [a, b]
    if len(sources) < 2:
        raise InvalidInput("two operands or more are needed: give a and b, or a list")
    checked = options.check(options.BOOLEAN, {"operation": operation, **values})
    return add_of_sources(MeshBoolean, sources, checked, checked["operation"].replace("_", " "), "Boolean")


def add_of_sources(kind, sources, values, told, name):
    """Adds a document object of a kind with these sources and checked options; its label is that of the first source, and
    what is told.

    Raises InvalidInput for sources that are no objects of one document.
    """
    objects = [frames.object_of(source) for source in sources]
    for obj in objects:
        if not isinstance(obj, FreeCAD.DocumentObject):
            raise InvalidInput("document objects with a mesh or a shape are needed, not "
                               f"{type(obj).__name__}")
    document = objects[0].Document
    if any(obj.Document != document for obj in objects):
        raise InvalidInput("the operands are objects of different documents: link them into one")

    def make(obj):
        proxy = kind(obj)
        obj.Label = transactions.labelled(sources[0], told)
        obj.Sources, obj.SourcePaths = objects, [frames.path_of(source) for source in sources]
        properties.set_options(obj, kind.OPTIONS, values)
        return proxy

    return transactions.add(document, kind, name, name, make)
