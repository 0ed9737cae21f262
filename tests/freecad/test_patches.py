# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches: how they are given, checked and kept, and that files are written in whole or not at all."""

import importlib.util
import json
import os
import stat
import threading
import unittest
from pathlib import Path

import FreeCAD
import helpers
import numpy as np
import Part
import test_cli

import MeshQuality as mq
from MeshQuality import formats
from MeshQuality.core.meshes import writing


def box():
    return Part.makeBox(10, 20, 30)


class Given(helpers.DocumentTest):
    def test_each_triangle_is_in_the_patch_of_its_face(self):
        mesh = mq.triangulate(box(), patches={"inlet": ["Face1", "Face3"], "outlet": ("Face2",)})
        self.assertEqual(mesh.patches, ("inlet", "outlet", "Face4", "Face5", "Face6"))
        self.assertEqual(mesh.triangle_patch.dtype, np.int32)
        expected = np.array([0, 1, 0, 2, 3, 4])[mesh.triangle_face]
        np.testing.assert_array_equal(mesh.triangle_patch, expected)
        with self.assertRaises(ValueError):
            mesh.triangle_patch[0] = 3

    def test_the_rest_is_one_patch(self):
        mesh = mq.triangulate(box(), patches={"inlet": ["Face1"]}, patch_rest="walls")
        self.assertEqual(mesh.patches, ("inlet", "walls"))
        self.assertEqual(mq.triangulate(box(), patch_rest="walls").patches, ("walls",))
        joined = mq.triangulate(box(), patches={"inlet": ["Face1"], "walls": ["Face2"]}, patch_rest="walls")
        self.assertEqual(joined.patches, ("inlet", "walls"))

    def test_without_there_are_none(self):
        for mesh in (mq.triangulate(box()), mq.curve(box())):
            self.assertEqual((mesh.patches, len(mesh.triangle_patch)), ((), 0))

    def test_of_curved_meshes(self):
        patches = {"inlet": ["Face1"]}
        mesh = mq.triangulate(box(), patches=patches, patch_rest="walls")
        for curved in (mq.curve(box(), patches=patches, patch_rest="walls"), mq.curve(mesh, shape=box()),
                       mq.curve(mesh, shape=box(), patches=patches, patch_rest="walls")):
            self.assertEqual(curved.patches, ("inlet", "walls"))
            np.testing.assert_array_equal(curved.triangle_patch, np.where(curved.triangle_face == 0, 0, 1))

    def test_names_through_containers(self):
        part = self.document.addObject("App::Part", "Part")
        for name in ("Left", "Right"):
            part.addObject(self.document.addObject("Part::Box", name))
        self.document.Right.Placement.Base.x = 20
        self.document.recompute()
        mesh = mq.triangulate(part, patches={"inlet": ["Right.Face1"]}, patch_rest="walls")
        inside = mesh.vertices[mesh.triangles[mesh.triangle_patch == 0]]
        self.assertGreater(len(inside), 0)
        self.assertEqual(set(inside[:, :, 0].ravel().tolist()), {20.0})
        with self.assertRaisesRegex(mq.InvalidInput, "names Up.Face1, but 'Part' does not hold that"):
            mq.triangulate(part, patches={"inlet": ["Up.Face1"]})

    def test_what_makes_no_sense_is_named_with_the_remedy(self):
        for patches, said in (
                ({"a": ["Face1"], "b": ["Face1"]}, "Face1 is in patch 'a' and in patch 'b'.*name it once"),
                ({"a": ["Face1", "Face1"]}, "twice in patch 'a'"), ({"": ["Face1"]}, "'' is not possible"),
                ({" a": ["Face1"]}, "' a' is not possible"), ({7: ["Face1"]}, "7 is not possible"),
                ({"a": ["Face7"]}, "patch 'a' names Face7, but the shape has faces Face1 to Face6"),
                ({"a": ["Edge1"]}, "names 'Edge1', which is no face"), ({"a": ["Face0"]}, "no face"),
                ({"a": [1]}, "no face"), ({"a": "Face1"}, "give a list"), ({"a": None}, "give a list"), ("a", "give a dict"),
                ({"Face3": ["Face1"]}, "'Face3' has the name of a face"), ({"a": {"colour": "#ff0000"}}, "needs 'faces'"),
                ({"a": {"faces": ["Face1"], "colour": "red"}}, "#rrggbb"),
                ({"a": {"faces": ["Face1"], "color": "#ff0000"}}, "not 'color'")):
            with self.subTest(patches):
                for call in (mq.triangulate, mq.curve):
                    with self.assertRaisesRegex(mq.InvalidInput, said):
                        call(box(), patches=patches)
        for rest in ("", 3, "a\nb"):
            with self.assertRaisesRegex(mq.InvalidInput, "patch_rest"):
                mq.triangulate(box(), patch_rest=rest)

    def test_meshes_that_know_no_faces(self):
        mesh = mq.improve(mq.triangulate(box()))
        with self.assertRaisesRegex(mq.InvalidInput, "does not know those of a shape"):
            mesh.write(os.path.join(self.folder, "a.obj"), patches={"a": ["Face1"]})
        for suffix in formats.SUFFIXES:
            path = os.path.join(self.folder, "a" + suffix)
            if suffix == ".cgns" and not has_cgns() or suffix == ".exo" and not has_netcdf():
                continue
            mesh.write(path)
            self.assertGreater(os.path.getsize(path), 100, suffix)


def has_cgns():
    import ctypes.util
    return ctypes.util.find_library("cgns") is not None


def has_netcdf():
    import importlib.util
    return importlib.util.find_spec("netCDF4") is not None


class Written(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.mesh = mq.triangulate(box(), patches={"in": ["Face1"]}, patch_rest="walls")
        self.path = os.path.join(self.folder, "a.obj")

    def groups(self):
        with open(self.path, encoding="utf-8") as stream:
            return [line[2:].strip() for line in stream if line.startswith("g ")]

    def test_those_of_the_mesh_are_the_default(self):
        self.mesh.write(self.path)
        self.assertEqual(self.groups(), ["in", "walls"])
        self.mesh.write(self.path, patches={"out": ["Face2"]}, patch_rest="rest")
        self.assertEqual(self.groups(), ["out", "rest"])
        with self.assertRaisesRegex(mq.InvalidInput, "patch 'a' names Face9, but the mesh has faces Face1 to Face6"):
            self.mesh.write(self.path, patches={"a": ["Face9"]})

    def test_names_that_a_format_cannot_hold(self):
        solid = mq.curve(box(), volume=True)
        for mesh, suffix, name, said in (
                (self.mesh, ".obj", "in let", "no blanks.*'in_let'"), (self.mesh, ".fms", "a;b", "a_b"),
                (self.mesh, ".su2", "in let", "in_let"), (self.mesh, ".msh", 'in "let"', "no double quotes"),
                (self.mesh, ".inp", "1st", "'patch_1st'"), (self.mesh, ".inp", "ä", "letter"),
                (self.mesh, ".inp", "x" * 73, "at most 72"), (self.mesh, ".cgns", "x" * 33, "at most 32"),
                (self.mesh, ".cgns", "a/b", "no slashes"), (self.mesh, ".unv", "x" * 41, "at most 40"),
                (self.mesh, ".exo", "x" * 33, "at most 32"), (solid, ".inp", "SOLID1", "solid Solid1")):
            with self.subTest(suffix=suffix, name=name), self.assertRaisesRegex(mq.InvalidInput, said):
                mesh.write(self.path, patches={name: ["Face1"]}, format=suffix[1:])
        with self.assertRaisesRegex(mq.InvalidInput, "'INLET' from patch inlet"):
            self.mesh.write(self.path, patches={"inlet": ["Face1"], "INLET": ["Face2"]}, format="inp")
        with self.assertRaisesRegex(mq.InvalidInput, "surface of patch inlet"):
            self.mesh.write(self.path, patches={"inlet": ["Face1"], "Inlet_Surface": ["Face2"]}, format="inp")
        with self.assertRaisesRegex(mq.InvalidInput, ".stl files cannot hold"):
            self.mesh.write(os.path.join(self.folder, "a.stl"), patches={"in let": ["Face1"]}, ascii=True)
        self.assertEqual(os.listdir(self.folder), [])

    def test_options_that_are_not_possible(self):
        for how, said in (({"scale": 0}, "scale = 0 "), ({"scale": float("nan")}, "scale"), ({"scale": "1"}, "scale"),
                          ({"format": "step"}, "format = 'step' is not known"), ({"ascii": True}, "no other form as text")):
            with self.subTest(how), self.assertRaisesRegex(mq.InvalidInput, said):
                self.mesh.write(self.path, **how)
        curved = mq.curve(box(), order=3)
        for mesh, suffix in ((curved, "inp"), (curved, "su2"), (curved.with_order(5), "cgns")):
            with self.assertRaisesRegex(mq.InvalidInput, f"not elements of order {mesh.order}"):
                mesh.write(self.path, format=suffix)
        with self.assertRaisesRegex(mq.IoError, "tessellate"):
            curved.write(os.path.join(self.folder, "a.stl"))

    def test_scale(self):
        self.mesh.write(self.path, scale=0.001)
        with open(self.path, encoding="utf-8") as stream:
            points = np.array([line.split()[1:] for line in stream if line.startswith("v ")], dtype=float)
        np.testing.assert_allclose(points, self.mesh.vertices * 0.001, rtol=1e-15)

    def test_a_file_that_is_there_survives_a_failure(self):
        self.mesh.write(self.path)
        with open(self.path, "rb") as stream:
            before = stream.read()

        def fail(ready):
            with open(ready, "wb") as stream:
                stream.write(b"half")
            raise OSError(28, "No space left on device", ready)

        with self.assertRaises(mq.IoError) as caught:
            writing.atomically(self.path, ".obj", fail)
        self.assertIn(self.path, str(caught.exception))
        with open(self.path, "rb") as stream:
            self.assertEqual(stream.read(), before)
        self.assertEqual(os.listdir(self.folder), ["a.obj"])

    def test_pipes_get_every_format_and_stay(self):
        """Libraries of formats remove what is there before they write: as administrator that was /dev/null."""
        pipe = os.path.join(self.folder, "pipe")
        os.mkfifo(pipe)
        for suffix in formats.SUFFIXES:
            if suffix == ".cgns" and not has_cgns() or suffix == ".exo" and not has_netcdf():
                continue
            with self.subTest(suffix):
                found = []
                reader = threading.Thread(target=lambda: found.append(Path(pipe).read_bytes()))
                reader.start()
                self.mesh.write(pipe, format=suffix[1:])
                reader.join(60)
                self.assertTrue(stat.S_ISFIFO(os.stat(pipe).st_mode))
                self.mesh.write(self.path, format=suffix[1:])
                self.assertEqual(len(found[0]), os.path.getsize(self.path))
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.obj", "pipe"])

    def test_where_nothing_can_be_written_the_path_is_named(self):
        for suffix in formats.SUFFIXES:
            if suffix == ".cgns" and not has_cgns() or suffix == ".exo" and not has_netcdf():
                continue
            path = "/proc/meshquality" + suffix
            with self.subTest(suffix), self.assertRaises(mq.IoError) as caught:
                self.mesh.write(path)
            self.assertIn(path, str(caught.exception))
            self.assertNotIn(".part", str(caught.exception))

    @unittest.skipUnless(has_cgns(), "the CGNS library is not installed")
    def test_names_that_cgns_gives_to_something_else(self):
        for name in ("GridCoordinates", "ZoneBC", "ZoneType", "DataClass", "DimensionalUnits", "Zone1", "."):
            with self.subTest(name), self.assertRaises(mq.InvalidInput) as caught:
                self.mesh.write(os.path.join(self.folder, "a.cgns"), patches={name: ["Face1"]})
            self.assertIn(repr(name), str(caught.exception))
            self.assertIn("for example", str(caught.exception))
        self.assertEqual(os.listdir(self.folder), [])

    def test_links_and_modes_stay(self):
        link = os.path.join(self.folder, "link.obj")
        self.mesh.write(self.path)
        os.chmod(self.path, 0o640)
        os.symlink("a.obj", link)
        self.mesh.write(link, patches={"out": ["Face2"]})
        self.assertTrue(os.path.islink(link))
        self.assertEqual(os.stat(self.path).st_mode & 0o777, 0o640)
        self.assertIn("out", self.groups())


class CommandLine(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.part = os.path.join(self.folder, "part.brep")
        box().exportBrep(self.part)
        self.patches = self.write({"inlet": ["Face1", "Face2"], "outlet": {"faces": ["Face3"], "colour": "#00ff00"}})

    def write(self, said):
        path = os.path.join(self.folder, f"patches{len(os.listdir(self.folder))}.json")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(said if isinstance(said, str) else json.dumps(said))
        return path

    def expect(self, expected, said, *arguments):
        status, _, err = test_cli.run(*arguments)
        self.assertEqual(status, expected, err)
        self.assertRegex(err[-1], said)

    def test_stl_with_names_in_metres(self):
        path = os.path.join(self.folder, "a.stl")
        self.expect(0, "triangles", "triangulate", self.part, "--patches", self.patches, "--patch-rest", "walls",
                    "--scale", "0.001", "--ascii", "-o", path)
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        self.assertEqual([line.split()[1] for line in text.splitlines() if line.startswith("solid")],
                         ["inlet", "outlet", "walls"])
        self.assertIn("0.03", text)
        self.assertNotIn(" 30", text)

    def test_every_format_of_curve(self):
        for name in ("msh2", "inp", "fms"):
            path = os.path.join(self.folder, "a." + ("msh" if name == "msh2" else name))
            self.expect(0, "order 2", "curve", self.part, "--volume", "--patches", self.patches, "--format", name, "-o", path)
            with open(path, encoding="utf-8") as stream:
                text = stream.read()
            self.assertTrue("inlet" in text and "Face4" in text)
            self.assertTrue(name != "msh2" or text.startswith("$MeshFormat\n2.2 0 8"))

    def test_faults_are_found_before_the_work(self):
        path = os.path.join(self.folder, "a.inp")
        for arguments, said in (
                (("--patches", os.path.join(self.folder, "none.json"), "-o", path), "there is no file"),
                (("--patches", self.write("{"), "-o", path), "cannot be read"),
                (("--patches", self.write('{"a": ["Face1"], "a": ["Face2"]}'), "-o", path), "'a' stands twice"),
                (("--patches", self.write("[1]"), "-o", path), "must hold an object"),
                (("--scale", "0", "-o", path), "--scale 0 is not allowed"), (("--ascii", "-o", path), "no other form as text"),
                (("--scale", "2"), "--scale is for the mesh in a file")):
            self.expect(2, said, "triangulate", self.part, *arguments)
        for patches, said in (({"in let": ["Face1"]}, "'in_let'"), ({"a": ["Face9"]}, "patch 'a' names Face9"),
                              ({"a": ["Box.Face1"]}, "patch 'a' names Box.Face1, but .* has no objects")):
            self.expect(2, said, "triangulate", self.part, "--patches", self.write(patches), "-o", path)
        self.assertFalse(os.path.exists(path))

    def test_names_of_objects_in_documents(self):
        self.document.addObject("Part::Box", "Left")
        self.document.addObject("Part::Box", "Right").Placement.Base = FreeCAD.Vector(20, 0, 0)
        self.document.recompute()
        document, path = os.path.join(self.folder, "two.FCStd"), os.path.join(self.folder, "a.obj")
        self.document.saveAs(document)
        patches = self.write({"inlet": {"faces": ["Right.Face1"]}})
        self.expect(0, "triangles", "triangulate", document, "--patches", patches, "--patch-rest", "walls", "-o", path)
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        points = [line.split()[1] for line in text.splitlines() if line.startswith("v ")]
        inlet = text[text.index("g inlet"):text.index("g walls")].split()
        self.assertEqual({float(points[int(word) - 1]) for word in inlet if word.isdigit()}, {20.0})

    @unittest.skipUnless(importlib.util.find_spec("distributed"), "python3-distributed is not installed")
    def test_batches(self):
        parts, out = os.path.join(self.folder, "parts"), os.path.join(self.folder, "out")
        os.mkdir(parts)
        box().exportBrep(os.path.join(parts, "a.brep"))
        arguments = ("batch", parts, "-o", out, "--jobs", "1", "--format", "stl", "--ascii", "--patch-rest", "walls")
        status, said, err = test_cli.run(*arguments, "--scale", "0.001")
        self.assertEqual(status, 0, said + "\n".join(err))
        with open(os.path.join(out, "meshes", "a.brep.stl"), encoding="utf-8") as stream:
            text = stream.read()
        self.assertTrue(text.startswith("solid walls\n"))
        self.assertIn("0.03", text)


class Folders(helpers.DocumentTest):
    def test_a_folder_that_is_not_there_is_named(self):
        mesh = mq.triangulate(box())
        for suffix in formats.SUFFIXES:
            path = os.path.join(self.folder, "none", f"part{suffix}")
            with self.assertRaisesRegex(mq.IoError, f"{path}.*there is no folder"):
                mesh.write(path)
