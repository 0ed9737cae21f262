# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects whose properties, sources, links, transactions and files are edited by hand."""

import os
import random
import tempfile
import threading
import zipfile

import Mesh
import Part
from attack import Attack, Planted, check, survive

import FreeCAD
import MeshQuality as mq

V = FreeCAD.Vector
# What FreeCAD itself raises where a property does not take a value, or an object may not be touched.
REFUSED = (TypeError, ValueError, AttributeError, RuntimeError, OverflowError, ReferenceError, NameError,
           ArithmeticError, OSError, FreeCAD.Base.FreeCADError, Part.OCCError, Planted)


class Scene:
    """A document with a source, a second one, and one object of a kind."""

    def __init__(self, kind):
        self.document = FreeCAD.newDocument("Attacked")
        self.document.UndoMode = 1
        self.document.openTransaction("sources")
        self.source = self.document.addObject("Part::Box", "Box")
        self.other = self.document.addObject("Part::Cylinder", "Cylinder")
        self.rough = self.document.addObject("Mesh::Feature", "Rough")
        self.rough.Mesh = Mesh.createSphere(5.0, 10)
        self.document.recompute()
        self.document.commitTransaction()
        self.mesh = KINDS[kind](self)


KINDS = {
    "quality": lambda scene: mq.add_quality_mesh(scene.source),
    "curved": lambda scene: mq.add_curved_mesh(scene.source),
    "Boolean": lambda scene: mq.add_boolean(scene.source, scene.other, resolution=64),
    "improved": lambda scene: mq.add_improved_mesh(scene.rough),
    "simplified": lambda scene: mq.add_simplified_mesh(scene.rough),
}
ODD = {
    "NaN": float("nan"), "-1": -1, "infinity": float("inf"), "1e300": 1e300, "2**70": 2**70, "a text": "x",
    "None": None,
    "a list": [1, 2], "a quantity of time": FreeCAD.Units.Quantity("1 s"), "an object": object(), "a denormal": 5e-324,
    "a function": FreeCAD.newDocument,
}


def refused(function):
    """Whether FreeCAD refused what the function does."""
    try:
        function()
    except (mq.Error, *REFUSED):
        return True
    return False


def settled(scene):
    """Everything that users do next ends well: recompute, save, open, undo, redo; and the objects say how they are."""
    document = FreeCAD.listDocuments().get("Attacked")
    if document is None:
        return
    refused(document.recompute)
    _say_how_they_are(document)
    for _ in range(3):
        document.undo()
    for _ in range(3):
        document.redo()
    refused(document.recompute)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "attacked.FCStd")
        document.saveAs(path)
        FreeCAD.closeDocument(document.Name)
        document = FreeCAD.openDocument(path)
        refused(document.recompute)
        _say_how_they_are(document)
        FreeCAD.closeDocument(document.Name)


def _say_how_they_are(document):
    for obj in document.Objects:
        status = getattr(obj, "Status", None)
        if status is None or not hasattr(getattr(obj, "Proxy", None), "sources"):
            continue
        check(isinstance(status, str) and status, f"{obj.Name} does not say how it is: {status!r}")
        mesh = obj.Mesh
        if mesh.CountFacets and status == "up to date":
            survive(lambda m=mesh: mq.quality(m))


def edited(kind, edit):
    """An attack that edits a scene by edit(scene) and then goes on as users do."""
    def attack():
        scene = Scene(kind)
        refused(lambda: edit(scene))
        settled(scene)

    return attack


# ---- edits of any kind of object ----

def _set(name, value):
    return lambda scene: setattr(scene.mesh, name, value)


def _itself(scene):
    scene.mesh.Source = scene.mesh


def _cycle(scene):
    second = mq.add_improved_mesh(scene.mesh)
    if "Source" in scene.mesh.PropertiesList:
        scene.mesh.Source = second
    else:
        scene.mesh.Sources = [second, scene.source]


def _source_of_another_document(scene):
    second = FreeCAD.newDocument("Second")
    box = second.addObject("Part::Box", "Box")
    second.recompute()
    try:
        scene.mesh.Source = box
        scene.document.recompute()
    finally:
        FreeCAD.closeDocument("Second")


def _in_its_own_group(scene):
    group = scene.document.addObject("App::Part", "Part")
    group.addObject(scene.mesh)
    scene.mesh.Source = group


def _link_to_itself(scene):
    link = scene.document.addObject("App::Link", "Link")
    link.LinkedObject = scene.mesh
    scene.mesh.Source = link


def _empty_array(scene):
    link = scene.document.addObject("App::Link", "Link")
    link.LinkedObject = scene.source
    link.ElementCount = 0
    scene.mesh.Source = link


def _large_array(scene):
    link = scene.document.addObject("App::Link", "Link")
    link.LinkedObject = scene.source
    link.ElementCount = 20
    scene.mesh.Source = link
    scene.document.recompute()
    link.ElementCount = 1


def _placement(scene, numbers):
    scene.source.Placement = FreeCAD.Placement(FreeCAD.Matrix(*numbers))


def _copied_with_dependencies(scene):
    scene.document.copyObject(scene.mesh, True)


def _copied_to_another(scene):
    second = FreeCAD.newDocument("Second")
    try:
        copy = second.copyObject(scene.mesh, True)
        second.recompute()
        check(copy is not None, "nothing was copied")
        second.removeObject(second.Objects[0].Name)
        second.recompute()
    finally:
        FreeCAD.closeDocument("Second")


def _moved_to_another(scene):
    second = FreeCAD.newDocument("Second")
    try:
        second.moveObject(scene.mesh, True)
        second.recompute()
    finally:
        FreeCAD.closeDocument("Second")


def _edited_property(scene, name):
    scene.mesh.removeProperty(name)


def _read_only(scene, status):
    for name in scene.mesh.PropertiesList:
        refused(lambda n=name: scene.mesh.setPropertyStatus(n, status))
    scene.source.touch()
    scene.document.recompute()


def _aborted(scene):
    scene.document.openTransaction("change")
    if hasattr(scene.source, "Length"):
        scene.source.Length = 25
    scene.document.recompute()
    scene.document.abortTransaction()
    scene.document.recompute()


def _undone_in_the_middle(scene):
    refused(lambda: mq.update(scene.mesh, lambda *_: scene.document.undo(), min_angle=21.0))


def _transaction_within(scene):
    def callback(*_):
        scene.document.openTransaction("within")
        scene.source.Label = "other"

    mq.update(scene.mesh, callback)
    scene.document.abortTransaction()


def _saved_within(scene):
    with tempfile.TemporaryDirectory() as folder:
        mq.update(scene.mesh, lambda *_: scene.document.saveAs(os.path.join(folder, "x.FCStd")) and None)


def _renamed_within(scene):
    def callback(*_):
        scene.document.Label = "Renamed"
        scene.mesh.Label = scene.source.Label = "same"

    mq.update(scene.mesh, callback)


def _added_within(scene):
    mq.update(scene.mesh, lambda *_: scene.document.addObject("Part::Box", "New") and None)


def _removed_source_within(scene):
    mq.update(scene.mesh, lambda *_: scene.document.removeObject("Box") if scene.document.getObject("Box") else None)


def _cleared_within(scene):
    def callback(*_):
        for obj in scene.document.Objects:
            scene.document.removeObject(obj.Name)

    mq.update(scene.mesh, callback)


def _closed_within(scene):
    mq.update(scene.mesh,
              lambda *_: FreeCAD.closeDocument("Attacked") if "Attacked" in FreeCAD.listDocuments() else None)


def _recomputed_within(scene):
    scene.source.touch()
    mq.update(scene.mesh, lambda *_: scene.document.recompute() and None)


def _without_undo(scene):
    scene.document.UndoMode = 0
    mq.update(scene.mesh)
    scene.document.UndoMode = 1


def _other_proxy(scene, proxy):
    scene.mesh.Proxy = proxy
    scene.mesh.touch()
    scene.document.recompute()


def _mesh_by_hand(scene, mesh):
    scene.mesh.Mesh = mesh
    scene.document.recompute()
    mq.update(scene.mesh)


def _from_a_thread(scene):
    thread = threading.Thread(target=lambda: refused(lambda: mq.update(scene.mesh)))
    thread.start()
    thread.join()


def _update_with(scene, **values):
    mq.update(scene.mesh, **values)


def _shape(scene, shape):
    feature = scene.document.addObject("Part::Feature", "Odd")
    feature.Shape = shape
    scene.mesh.Source = feature


def _many_objects(scene):
    for _ in range(15):
        copy = scene.document.copyObject(scene.mesh)
        copy.Label = scene.mesh.Label


def _touch_storm(scene):
    for _ in range(5):
        scene.mesh.touch()
        scene.document.recompute(None, True)
        scene.mesh.purgeTouched()


def _expression(scene, name, text):
    scene.mesh.setExpression(name, text)


LABELS = {"a line": "two\nlines", "quotes": "\"'`$(x)", "emoji": "\U0001f600", "10^5 characters": "x" * 10**5,
          "none": "",
          "a NUL": "a\0b", "markup": "<b>&amp;</b>", "a format": "%s {0} %n", "from right to left": "\u202eabc"}
EXPRESSIONS = {"a wrong unit": "1 mm + 1 s", "a length for an angle": "Box.Length", "itself": "Attacked.MinAngle",
               "no syntax": "1 +* 2",
               "nothing there": "Nowhere.Length", "a division by zero": "1/0", "a text": "<<text>>", "NaN": "0/0",
               "a huge power": "10^400",
               "another document": "Other#Box.Length", "a Python call": "_self.Document"}
MATRICES = {"NaN": [float("nan")] * 16, "NaN in x": [1, 0, 0, float("nan"), 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
            "zero": [0.0] * 16, "shear": [1, 5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
            "mirror": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
            "far": [1, 0, 0, 1e12, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
            "infinite": [1, 0, 0, float("inf"), 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}
EDITS = {
    "its source is itself": _itself, "a cycle of two meshes": _cycle,
    "its source in another document": _source_of_another_document,
    "in the group that it meshes": _in_its_own_group, "a link to itself": _link_to_itself,
    "an array of none": _empty_array, "an array that shrinks": _large_array,
    "copied with what it is made of": _copied_with_dependencies,
    "copied to another document": _copied_to_another, "moved to another document": _moved_to_another,
    "properties read-only": lambda s: _read_only(s, "ReadOnly"),
    "properties immutable": lambda s: _read_only(s, "Immutable"),
    "properties transient": lambda s: _read_only(s, "Transient"),
    "properties hidden": lambda s: _read_only(s, "Hidden"),
    "a transaction aborted": _aborted, "undo while it is computed": _undone_in_the_middle,
    "a transaction within": _transaction_within,
    "saved within": _saved_within, "renamed within": _renamed_within, "objects added within": _added_within,
    "its source removed within": _removed_source_within, "all removed within": _cleared_within,
    "closed within": _closed_within,
    "recomputed within": _recomputed_within, "no undo": _without_undo, "no proxy": lambda s: _other_proxy(s, None),
    "a number as proxy": lambda s: _other_proxy(s, 7), "a plain object as proxy": lambda s: _other_proxy(s, object()),
    "the proxy of a source": lambda s: _other_proxy(s.source, s.mesh.Proxy),
    "an empty mesh by hand": lambda s: _mesh_by_hand(s, Mesh.Mesh()),
    "another mesh by hand": lambda s: _mesh_by_hand(s, Mesh.createSphere(3.0, 20)),
    "updated by a thread": _from_a_thread,
    "no such option": lambda s: _update_with(s, nonsense=1),
    "an option of another kind": lambda s: _update_with(s, operation="union", order=3),
    "a source as option": lambda s: _update_with(s, Source=s.other), "a null shape": lambda s: _shape(s, Part.Shape()),
    "an edge": lambda s: _shape(s, Part.makeLine(V(), V(1, 0, 0))),
    "an infinite plane": lambda s: _shape(s, Part.Plane().toShape()),
    "16 of one label": _many_objects, "touched again and again": _touch_storm,
    "the source removed": lambda s: s.document.removeObject("Box"),
    "no source": _set("Source", None),
    "sources of one kind twice": lambda s: setattr(s.mesh, "Sources", [s.source, s.source]),
    "no sources": _set("Sources", []), "a path to nothing": _set("SourcePath", "Nowhere.Box."),
    "a path with NUL": _set("SourcePath", "a\0b"),
    "a path of 10^5": _set("SourcePath", "A." * 50000),
    "manual, then removed": lambda s: (setattr(s.mesh, "Recompute", "Manual"), s.document.removeObject("Box")),
    "an odd choice": _set("Recompute", "Sometimes"),
    "a status by hand": _set("Status", "being computed in the background"),
    "a fingerprint by hand": _set("Fingerprint", "x" * 10**5), "a certificate by hand": _set("Certificate", "met"),
    "the source's type changes": lambda s: setattr(s.mesh, "Source", s.rough),
    "removed and undone": lambda s: (s.document.removeObject(s.mesh.Name), s.document.undo()),
    "a source of no size": lambda s: [setattr(s.source, name, 1e-9) for name in ("Length", "Width", "Height")],
    "a source of 1e7": lambda s: [setattr(s.source, name, 1e7) for name in ("Length", "Width", "Height")],
    "a source that fails": lambda s: setattr(s.other, "Radius", 0.0),
    **{f"a label of {name}": (lambda s, t=text: setattr(s.mesh, "Label", t)) for name, text in LABELS.items()},
    **{f"a source's label of {name}": (lambda s, t=text: setattr(s.source, "Label", t)) for name,
       text in LABELS.items()},
    **{f"an expression: {name}": (lambda s, t=text: _expression(s, "MinAngle", t)) for name,
       text in EXPRESSIONS.items()},
    **{f"a placement of {name}": (lambda s, m=matrix: _placement(s, m)) for name, matrix in MATRICES.items()},
}
# Of properties that the objects keep for themselves.
KEPT = {
    "FaceRuns": ([0], [-1, 5], [0, 10**9], [2**40, 1], [0, -3], list(range(9999))),
    "MeshOrigin": (V(float("nan"), 0, 0), V(1e300, 0, 0)),
    "SourceFrame": (FreeCAD.Placement(V(float("inf"), 0, 0), FreeCAD.Rotation()),),
    "SourceArrangement": ("garbage", "\u202e" * 1000),
    "CertificatePlace": ([V()], [V(float("nan"), 0, 0)] * 5),
    "CertificateFaces": (["Face99"], ["\n"]),
    "Nodes": ([], [0.0], [float("nan")] * 30, [1e300] * 300),
    "TriangleNodes": ([], [-1] * 6, [2**31 - 1] * 6, [0, 1]),
    "EdgeNodes": ([1], [-5, 2, 7]), "NodeEntity": ([9, 9], []), "TriangleFace": ([99], []),
    "TriangleQuality": ([], [float("nan")]), "TetrahedronNodes": ([0] * 10, [1, 2]), "ElementsOrder": (0, 9, -1, 10**6),
}
def _cut_between_entries(data):
    """The first half of a file, cut between two entries of the archive: where half of an entry of a mesh is left,
    FreeCAD's own reader may work for minutes on a count that it finds there.
    """
    return data[:max(0, data.rfind(b"PK\x03\x04", 0, len(data) // 2))]


# What may happen to a file between saving and opening.
FILES = {
    **{f"cut to {share:g}": (lambda data, s=share: data[:int(s * len(data))]) for share in (0.0, 0.01, 0.9, 0.99)},
    "cut between entries": _cut_between_entries,
    "a byte more": lambda data: data + b"x", "bytes before it": lambda data: b"#!/bin/sh\n" + data,
    "all zeros": lambda data: bytes(len(data)),
}
MEMBERS = {"gone": None, "empty": b"", "garbage": random.Random(1).randbytes(300), "huge line": b"x" * 10**6}
# FreeCAD may do so with any mesh: numbers of triangles that are not there, or chance, in the place of their count.
READS_FOR_EVER = ((".bms", "garbage"), (".bms", "empty"))


def _kept(name, value):
    def edit(scene):
        setattr(scene.mesh, name, value)
        refused(lambda: mq.CurvedMesh.of(scene.mesh).tessellate())
        with tempfile.TemporaryDirectory() as folder:
            refused(lambda: mq.export_curved_mesh(scene.mesh, os.path.join(folder, "x.msh")))

    return edit


def _opened(kind, change):
    """A document whose file was changed by change(bytes) -> bytes."""
    def attack():
        scene = Scene(kind)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "file.FCStd")
            scene.document.saveAs(path)
            FreeCAD.closeDocument("Attacked")
            with open(path, "rb") as stream:
                data = change(stream.read())
            with open(path, "wb") as stream:
                stream.write(data)
            opened = []
            if not refused(lambda: opened.append(FreeCAD.openDocument(path))):
                refused(opened[0].recompute)
                _say_how_they_are(opened[0])

    return attack


def _with_member(suffix, content):
    """Of a zip file's members with the suffix another content, or none."""
    def change(data):
        with tempfile.TemporaryFile() as old, tempfile.TemporaryFile() as new:
            old.write(data)
            with zipfile.ZipFile(old) as source, zipfile.ZipFile(new, "w") as target:
                for name in source.namelist():
                    if not name.endswith(suffix):
                        target.writestr(name, source.read(name))
                    elif content is not None:
                        target.writestr(name, content)
            new.seek(0)
            return new.read()

    return change


def _names(kind):
    """Properties that MeshQuality gives such an object."""
    scene = Scene(kind)
    found = [name for name in scene.mesh.PropertiesList if scene.mesh.getGroupOfProperty(name) not in ("Base", "")]
    FreeCAD.closeDocument("Attacked")
    return found


def rows():
    found = []
    for k, kind in enumerate(KINDS):
        found += [Attack(f"{kind}: {name}", edited(kind, edit)) for name, edit in EDITS.items()]
        names = _names(kind)
        found += [Attack(f"{kind}: without {name}",
                         edited(kind, lambda s, n=name: _edited_property(s, n))) for name in names]
        for i, name in enumerate(names):  # each with some of the values
            for said in list(ODD)[(i + k) % 3::3]:
                found.append(Attack(f"{kind}: {name} = {said}", edited(kind, _set(name, ODD[said]))))
        found += [Attack(f"{kind}: {name} kept as {str(value)[:20]}", edited(kind, _kept(name, value)))
                  for name, values in KEPT.items() if name in names for value in values]
        found += [Attack(f"{kind}: a file {name}", _opened(kind, change)) for name, change in FILES.items()]
        found += [Attack(f"{kind}: a file with {suffix} {name}", _opened(kind, _with_member(suffix, content)))
                  for suffix in (".bms", ".brp", "Document.xml") for name, content in MEMBERS.items()
                  if (suffix, name) not in READS_FOR_EVER]
    return found


def combined(dice):
    """Several edits of one object, one after the other."""
    kind, chosen = dice.choice(list(KINDS)), dice.sample(list(EDITS), 3)

    def edit(scene):
        for name in chosen:
            refused(lambda n=name: EDITS[n](scene))
            refused(scene.document.recompute)

    return Attack(f"{kind}: {', '.join(chosen)}", edited(kind, edit))
