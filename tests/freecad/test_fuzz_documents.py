# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random changes of what files hold that features and the command line read: properties of mesh objects, texts of
options, lines of a batch. Whatever they say, there is an error of ours or a result.

MESHQUALITY_FUZZ_ROUNDS says how many seeds each test takes, MESHQUALITY_FUZZ_FIRST which is the first:

    MESHQUALITY_FUZZ_ROUNDS=100000 MESHQUALITY_TESTS=test_fuzz_documents freecadcmd -P $PWD/Mod tests/freecad/run.py
"""

import contextlib
import io
import math
import os
import random
import unittest
from types import SimpleNamespace

import helpers

import MeshQuality as mq
from MeshQuality import element_names, options
from MeshQuality.batch.ledger import Ledger
from MeshQuality.cli import parser
from MeshQuality.compat import extension
from MeshQuality.core.sources import convert
from MeshQuality.gui.quality_data import QualityData

ROUNDS = int(os.environ.get("MESHQUALITY_FUZZ_ROUNDS", "0"))
FIRST = int(os.environ.get("MESHQUALITY_FUZZ_FIRST", "0"))
_LETTERS = "Face1Edge27Vertex=0.5, ;:-+e\t\n\0\\\"'{}[]()%.mm\u00e9\u2029\U0001f600"
_NUMBERS = (0.0, -1.0, 1e300, -1e300, 5e-324, 1e-300, float("nan"), float("inf"), -float("inf"), 2.0**31, 2.0**63, 0.5)
_INTEGERS = (0, 1, -1, 7, 2**31 - 1, -2**31, 2**31, 2**62, -2**62)


def seeds(usual):
    """The seeds of a test that takes so many of them unless it is told otherwise."""
    return range(FIRST, FIRST + (ROUNDS or usual))


def changed_text(text, chance):
    """The text with a few letters put in, taken out or replaced."""
    for _ in range(chance.randint(1, 4)):
        at = chance.randint(0, len(text))
        end = min(len(text), at + chance.randint(0, 2))
        text = text[:at] + "".join(chance.choices(_LETTERS, k=chance.randint(0, 3))) + text[end:]
    return text


def changed_list(values, others, chance):
    """The list with an entry changed, taken out or doubled, or cut short."""
    values = list(values)
    how = chance.randint(0, 4)
    if how == 0 or not values:
        return values + [chance.choice(others)]
    at = chance.randrange(len(values))
    if how == 1:
        return values[:at]
    if how == 2:
        return values[:at] + values[at + 1:]
    values[at] = chance.choice(values if how == 3 else others)
    return values


class Texts(unittest.TestCase):
    """What is typed, or written by another program."""

    def test_local_sizes(self):
        for seed in seeds(2000):
            chance = random.Random(seed)
            text = changed_text("Face3=0.5 mm, Edge7=0.2; Box.Vertex1=1e-3", chance)
            with self.subTest(seed=seed, text=text):
                try:
                    sizes = options.check(options.TRIANGULATE, {"local_sizes": text})["local_sizes"]
                except mq.InvalidInput:
                    continue
                again = options.check(options.TRIANGULATE, {"local_sizes": element_names.text_of_sizes(sizes)})
                self.assertEqual(again["local_sizes"], sizes)

    def test_command_lines(self):
        line = ["triangulate", "part.step", "-o", "x.stl", "--min-angle", "20", "--chord-height", "0.1",
                "--local-sizes", "Face1=2", "--json", "--max-triangles", "100", "--method", "refine"]
        for seed in seeds(60):
            chance = random.Random(seed)
            arguments = changed_list(line, ["--strict", "batch", "", "--", "-1", "none", "--order"], chance)
            at = chance.randrange(len(arguments) or 1)
            arguments[at:at + 1] = [changed_text(text, chance) for text in arguments[at:at + 1]]
            with self.subTest(seed=seed, arguments=arguments), contextlib.redirect_stderr(io.StringIO()), \
                    contextlib.redirect_stdout(io.StringIO()):
                try:
                    self.assertTrue(parser.parse(arguments).command)
                except SystemExit as end:
                    self.assertIn(end.code, (0, 2))

    def test_lines_of_a_batch(self):
        line = ('{"part": "a.step", "key": "k", "size": 12, "mtime_ns": 99, "state": "done", "output": "meshes/a.stl", '
                '"digest": "d", "seconds": 1.5, "report": {"triangles": 12, "closed": true}}')
        ledger = Ledger.__new__(Ledger)
        ledger._plan = SimpleNamespace(command="triangulate")
        for seed in seeds(1000):
            text = changed_text(line, random.Random(seed)).encode("utf-8", "surrogatepass")
            with self.subTest(seed=seed, text=text):
                entry = ledger._entry_of(text)
                self.assertTrue(entry is None or isinstance(entry["part"], str))


class Properties(helpers.DocumentTest):
    """Properties as a document may hold them that somebody else wrote."""

    def setUp(self):
        super().setUp()
        box, other = self.box(), self.box("Other", Length=4)
        self.objects = [mq.add_quality_mesh(box), mq.add_curved_mesh(box, order=2, volume=True),
                        mq.add_boolean(box, other, "union"), mq.add_quality_mesh(box, local_sizes={"Face1": 4.0})]
        self.objects.append(mq.add_improved_mesh(self.objects[0]))
        self.document.recompute()

    def changed(self, obj, chance):
        """(name, value before, value after) of a property that the workbench adds; None: of no use here."""
        own = [name for name in obj.PropertiesList if obj.getGroupOfProperty(name) not in ("Base", "", "View")
               and name not in ("Mesh", "Placement", "Source", "Sources")]
        name = chance.choice(own)
        before, kind = getattr(obj, name), obj.getTypeIdOfProperty(name)
        if kind == "App::PropertyString":
            return name, before, changed_text(before, chance)
        if kind == "App::PropertyStringList":
            return name, before, changed_list(before, ["", "triangle 99999999999: x", "Face0"], chance)
        if kind == "App::PropertyFloatList":
            return name, before, changed_list(before, _NUMBERS, chance)
        if kind == "App::PropertyIntegerList":
            return name, before, changed_list(before, _INTEGERS, chance)
        if kind in ("App::PropertyInteger", "App::PropertyIntegerConstraint"):
            return name, before, chance.choice(_INTEGERS[:6])
        if kind in ("App::PropertyFloat", "App::PropertyLength", "App::PropertyAngle"):
            return name, before, chance.choice(_NUMBERS)
        return None

    def use(self, obj, path):
        """All that reads the properties; lets errors of ours pass."""
        steps = [lambda: obj.Proxy.onDocumentRestored(obj), lambda: self.view(obj), lambda: mq.quality(obj),
                 lambda: self.recompute(obj)]
        if "ElementsOrder" in obj.PropertiesList:
            steps += [lambda: mq.CurvedMesh.of(obj).tetrahedron_distortion,
                      lambda: mq.export_curved_mesh(obj, path + ".msh"),
                      lambda: mq.export_curved_mesh(obj, path + ".vtu")]
        for step in steps:
            with contextlib.suppress(mq.Error):
                step()

    def view(self, obj):
        data = QualityData(obj)
        data.prepare()
        values = data.distortions()
        data.faces(values, data.measures[0])
        data.place(0), data.reason(0), data.lines

    def recompute(self, obj):
        obj.touch()
        self.document.recompute([obj])
        error = obj.Proxy.error if hasattr(obj.Proxy, "error") else None
        if error is not None:
            raise error

    def test_changed_properties(self):
        path = os.path.join(self.folder, "curved")
        for seed in seeds(80):
            chance = random.Random(seed)
            obj = chance.choice(self.objects)
            change = self.changed(obj, chance)
            if change is None:
                continue
            name, before, after = change
            with self.subTest(seed=seed, object=obj.Name, property=name, value=repr(after)[:200]):
                try:
                    setattr(obj, name, after)
                except (TypeError, ValueError, OverflowError):
                    continue  # FreeCAD holds no such value
                self.use(obj, path)
            setattr(obj, name, before)


class Found(helpers.DocumentTest):
    """What random changes found."""

    def test_elements_on_entities_that_there_are_not(self):
        curved = mq.add_curved_mesh(self.box(), order=2)
        path = os.path.join(self.folder, "curved.msh")
        entities = curved.NodeEntity
        for dimension in (100.0, -1.0, 2.0**31):
            curved.NodeEntity = [dimension, *entities[1:]]
            with self.assertRaisesRegex(mq.InvalidInput, "a node lies on entity .* of dimension"):
                mq.export_curved_mesh(curved, path)
        curved.NodeEntity = entities
        mq.export_curved_mesh(curved, path)

    def test_coordinates_that_are_cut_short(self):
        curved = mq.add_curved_mesh(self.box(), order=2)
        for name, said in (("Nodes", "as nodes, not 3 for each node"),
                           ("NodeEntity", "as node_entity, not 2 for each")):
            values = getattr(curved, name)
            setattr(curved, name, values[:-1])
            with self.assertRaisesRegex(mq.InvalidInput, said):
                mq.CurvedMesh.of(curved)
            setattr(curved, name, values)

    def test_nodes_that_are_no_numbers(self):
        curved = mq.add_curved_mesh(self.box(), order=2)
        curved.Nodes = [float("nan"), *curved.Nodes[1:]]
        with self.assertRaisesRegex(mq.InvalidInput, "node 0 has a coordinate that is not a finite number"):
            mq.CurvedMesh.of(curved)

    def test_runs_of_faces_that_do_not_fit_the_triangles(self):
        obj = mq.add_quality_mesh(self.box())
        runs, count = obj.FaceRuns, obj.Mesh.CountFacets
        for wrong in (runs[:-1], [0, 2**62], [0, -1, 1, count + 1], [-5, count], [], [0, count - 1]):
            obj.FaceRuns = wrong
            obj.Proxy.onDocumentRestored(obj)
            data = QualityData(obj)
            data.prepare()
            self.assertEqual(set(data.face), {-1}, wrong)
        obj.FaceRuns = runs
        data = QualityData(obj)
        data.prepare()
        self.assertEqual(sorted(set(data.face)), list(range(6)))

    def test_triangles_of_vertices_that_there_are_not(self):
        vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
        for wrong in (3, -1, 2**31 - 1, 2**62):
            with self.assertRaisesRegex(mq.InvalidInput, f"names vertex {wrong}, but the mesh has 3 vertices"):
                convert.surface_of_arrays(extension(), vertices, [[0, 1, wrong]], measured=False)

    def test_no_number_under_two_names(self):
        obj = mq.add_quality_mesh(self.box())
        obj.GrowthRate = float("nan")
        self.assertTrue(math.isnan(obj.Growth))
        obj.Growth = 2.0
        self.assertEqual(obj.GrowthRate, 2.0)
