# SPDX-License-Identifier: LGPL-2.1-or-later
"""volume_mesh: layers of prisms on the walls of a solid, proven valid, conforming, and taken by OpenFOAM's checkMesh."""

import json
import math
import os
import re
import shutil
import subprocess
import time
import unittest
from unittest import mock

import helpers
import numpy as np
import Part
from FreeCAD import Vector
from test_cli import run
from test_curved_files import PYTHON, has
from test_exchange import READ_BY_GMSH, READ_BY_HDF5, READ_BY_MESHIO
from test_exchange import run as exchange_run
from test_measures import ENVIRONMENT
from test_patches import has_cgns

import MeshQuality as mq
from MeshQuality.core.elements import alike, kinds
from MeshQuality.core.volumes.volume_report import WallCoverage, bare_note


def pipe_bend():
    """A quarter of a torus: its face 1 is the wall, faces 2 and 3 are plane."""
    circle = Part.makeCircle(3, Vector(12, 0, 0), Vector(0, 1, 0))
    return Part.Face(Part.Wire(circle)).revolve(Vector(), Vector(0, 0, 1), 90)


def stepped_duct():
    """A duct that gets wider by a step on one side: its edge is concave, seen from the fluid."""
    return Part.makeBox(20, 8, 4).fuse(Part.makeBox(20, 8, 8, Vector(20, 0, -4))).removeSplitter().Solids[0]


def wedge(angle):
    """A prism with an acute edge of these degrees."""
    turned = Vector(10 * math.cos(math.radians(angle)), 10 * math.sin(math.radians(angle)), 0)
    corners = [Vector(), Vector(10, 0, 0), turned, Vector()]
    return Part.Face(Part.makePolygon(corners)).extrude(Vector(0, 0, 5))


def areas(corners):
    """mm^2, of triangles."""
    return np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2


class VolumeMeshes(helpers.DocumentTest):
    def assert_sound(self, mesh, area=None):
        """All elements are proven, conform, and have the listed faces as their boundary and no others."""
        certificate = mq.certify(mesh)
        self.assertEqual((certificate.invalid, certificate.conforming, certificate.oriented), (0, True, True))
        self.assertTrue(mq.ElementMesh.of(mesh) is mesh)
        counts = {}
        for kind, corners in mesh.solid_blocks:  # by other means than the product's own check
            for face in kinds.FACES[kind]:
                for key in np.sort(corners[:, list(face)], axis=1).tolist():
                    counts[tuple(key)] = counts.get(tuple(key), 0) + 1
        self.assertLessEqual(max(counts.values()), 2)
        outer = {key for key, count in counts.items() if count == 1}
        listed = [tuple(sorted(side)) for sides in (mesh.boundary_triangles, mesh.boundary_quadrilaterals) for side in sides.tolist()]
        self.assertEqual(len(listed), len(set(listed)))
        self.assertEqual(outer, set(listed))
        self.assertGreater(mesh.report.min_scaled_jacobian, 0.0)
        if area is not None:
            self.assertAlmostEqual(sum(wall.area for wall in mesh.report.walls) / area, 1.0, delta=0.02)

    def first_heights(self, mesh):
        """mm: the distances of the first layer's upper corners from the planes of the triangles below."""
        first = mesh.prisms[mesh.prism_layer == 0]
        a, b, c = mesh.nodes[first[:, :3]].transpose(1, 0, 2)
        normal = np.cross(b - a, c - a)
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        return np.einsum("pij,pj->pi", mesh.nodes[first[:, 3:]] - a[:, None], normal)

    def test_layers_on_all_faces_of_a_box(self):
        mesh = mq.volume_mesh(Part.makeBox(10, 8, 6), layers=4, first_height=0.05, growth_rate=1.3, max_edge=1.5)
        self.assert_sound(mesh, 376.0)
        self.assertEqual((mesh.report.covered, mesh.report.full_height), (1.0, 1.0))
        self.assertEqual(len(mesh.prisms), 4 * len(mesh.boundary_triangles))
        self.assertEqual(len(mesh.boundary_quadrilaterals), 0)
        self.assertAlmostEqual(mesh.report.volume, 480.0, places=6)
        np.testing.assert_allclose(self.first_heights(mesh), 0.05, rtol=1e-4)  # at corners, too
        np.testing.assert_allclose(mesh.report.heights, 0.05 * 1.3 ** np.arange(4))

    def test_layers_end_in_plane_faces(self):
        mesh = mq.volume_mesh(Part.makeCylinder(5, 20), layers=5, first_height=0.05, walls=["Face1"], max_edge=2.0)
        self.assert_sound(mesh, 2 * math.pi * 5 * 20)
        self.assertEqual([wall.face for wall in mesh.report.walls], ["Face1"])
        self.assertEqual(mesh.report.covered, 1.0)
        self.assertEqual(set(mesh.quadrilateral_face.tolist()), {1, 2})
        for face, height in ((1, 20.0), (2, 0.0)):
            for sides, faces in ((mesh.boundary_triangles, mesh.triangle_face), (mesh.boundary_quadrilaterals, mesh.quadrilateral_face)):
                np.testing.assert_allclose(mesh.nodes[sides[faces == face]][..., 2], height, atol=1e-5)
        self.assertAlmostEqual(np.median(self.first_heights(mesh)), 0.05, delta=0.002)

    def test_a_step_to_the_tetrahedra_is_told_with_what_removes_it(self):
        region, given = Part.makeBox(10, 8, 6), {"first_height": 0.02, "growth_rate": 1.4, "max_edge": 1.5}
        told = next(note for note in mq.volume_mesh(region, 2, **given).report.notes if note.startswith("the last layer is 0.028 mm high"))
        layers = int(re.search(r"(\d+) layers would end", told)[1])
        notes = mq.volume_mesh(region, layers, **given).report.notes
        self.assertFalse([note for note in notes if note.startswith("the last layer")])
        told = mq.volume_mesh(region, 2, **{**given, "growth_rate": 1.0}).report.notes
        self.assertTrue([note for note in told if note.endswith("give a larger growth_rate, or shorter edges")])

    def test_edges_inside_grow_as_asked(self):
        counts = [len(mq.volume_mesh(Part.makeBox(10, 8, 6), 1, 0.05, max_edge=1.0, growth_inside=growth).tetrahedra) for growth in (0.1, 0.3, 0.8)]
        self.assertGreater(counts[0], 1.5 * counts[1])
        self.assertGreater(counts[1], 1.5 * counts[2])
        with self.assertRaisesRegex(mq.InvalidInput, "growth_inside"):
            mq.volume_mesh(Part.makeBox(1, 1, 1), 1, 0.05, growth_inside=0.0)

    def test_a_pipe_bend(self):
        mesh = mq.volume_mesh(pipe_bend(), layers=5, first_height=0.03, growth_rate=1.3, walls=["Face1"], max_edge=1.5)
        self.assert_sound(mesh)
        self.assertEqual(mesh.report.covered, 1.0)
        self.assertLess(mesh.report.max_non_orthogonality, 70.0)

    def test_a_step_with_a_concave_edge(self):
        mesh = mq.volume_mesh(stepped_duct(), layers=4, first_height=0.05, growth_rate=1.3, max_edge=2.0)
        self.assert_sound(mesh)
        self.assertEqual((mesh.report.covered, mesh.report.full_height), (1.0, 1.0))
        self.assertAlmostEqual(mesh.report.volume, 1920.0, delta=1e-3)
        np.testing.assert_allclose(self.first_heights(mesh), 0.05, rtol=2e-3)

    def test_where_no_layers_fit_they_end_in_pyramids_and_the_report_says_so(self):
        mesh = mq.volume_mesh(wedge(20), layers=4, first_height=0.05, growth_rate=1.3, max_edge=1.5)
        self.assert_sound(mesh)
        self.assertGreater(len(mesh.pyramids), 0)
        self.assertTrue(0.6 < mesh.report.covered < 1.0, mesh.report)
        on_walls = mesh.prisms[mesh.prism_layer == 0][:, :3]
        whole = {tuple(sorted(side)) for side in on_walls.tolist()}
        bare = [tuple(sorted(side)) not in whole for side in mesh.boundary_triangles.tolist()]
        corners = mesh.nodes[mesh.boundary_triangles[bare]]
        left_off = sum(wall.area * (1 - wall.covered) for wall in mesh.report.walls)
        self.assertAlmostEqual(areas(corners).sum(), left_off)
        self.assertLess(mesh.report.max_non_orthogonality, 80.0)
        self.assertTrue(any("Face1" in note for note in mesh.report.notes))

    def test_walls_that_end_beside_bare_ones_leave_the_openings_whole(self):
        sides = ["Face1", "Face3"]  # of the acute edge; the ends are openings
        mesh = mq.volume_mesh(wedge(20), layers=4, first_height=0.05, growth_rate=1.3, max_edge=1.5, walls=sides)
        self.assert_sound(mesh)
        self.assertLess(mesh.report.covered, 1.0)
        self.assertAlmostEqual(mesh.report.volume / wedge(20).Volume, 1.0, places=6)

    def test_walls_that_go_on_in_an_opening_or_turn_away_from_it_step_down_before(self):
        ring = Part.makeCone(2, 4, 10).fuse(Part.makeCylinder(1, 6, Vector(0, 0, -5))).removeSplitter().Solids[0]
        floor = Part.makeBox(10, 10, 5).fuse(Part.makeBox(10, 10, 5, Vector(10, 0, 0))).Solids[0]  # of two coplanar faces on each side
        for shape, place in ((ring, Vector(0, 0, 0)), (floor, Vector(5, 5, 5))):
            opening = min(range(len(shape.Faces)), key=lambda i: (shape.Faces[i].CenterOfMass - place).Length)
            walls = [f"Face{i + 1}" for i in range(len(shape.Faces)) if i != opening]
            given = {"chord_height": 0.1, "max_edge": 1.5}
            mesh = mq.volume_mesh(shape, layers=3, first_height=0.05, growth_rate=1.3, walls=walls, **given)
            self.assert_sound(mesh)
            self.assertTrue(0.5 < mesh.report.covered < 1.0, mesh.report)
            surface = mq.triangulate(shape, **given)
            whole = areas(surface.vertices[surface.triangles[surface.triangle_face == opening]]).sum()
            found = areas(mesh.nodes[mesh.boundary_triangles[mesh.triangle_face == opening]]).sum()
            quads = mesh.nodes[mesh.boundary_quadrilaterals[mesh.quadrilateral_face == opening]]
            found += areas(quads[:, [0, 1, 2]]).sum() + areas(quads[:, [0, 2, 3]]).sum()
            self.assertAlmostEqual(found / whole, 1.0, places=5)

    def test_bad_input_is_refused_by_name(self):
        box = Part.makeBox(10, 10, 1)
        good = {"layers": 3, "first_height": 0.02}
        for shape, given, words in (
                (box, {"layers": 5, "first_height": 0.3}, "Face5.* layers are .* mm thick, but the gap there is 1 mm"),
                (box.Faces[0], good, "0 solids, not one"),
                (box, {**good, "walls": ["Face9"]}, "'Face9', which is no face .* Face1 to Face6"),
                (box, {**good, "walls": []}, "empty list"),
                (Part.makeCylinder(5, 20), {**good, "walls": ["Face2"]}, "Face1 is not plane"),
                (box, {"layers": 0, "first_height": 0.1}, "layers"), (box, {"layers": 3, "first_height": -1.0}, "first_height")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                mq.volume_mesh(shape, **given)

    def test_a_face_too_narrow_for_layers_is_named_in_the_report(self):
        corners = [Vector(), Vector(10, 0, 0), Vector(10, 3, 0), Vector(0, 0.02, 0), Vector()]
        region = Part.Face(Part.makePolygon(corners)).extrude(Vector(0, 0, 5))
        blunt = next(f"Face{i}" for i, face in enumerate(region.Faces, 1) if abs(face.Area - 0.1) < 1e-6)
        given = {"layers": 3, "first_height": 0.1, "max_edge": 1.0}
        mesh = mq.volume_mesh(region, **given)
        self.assert_sound(mesh)
        bare = {wall.face: wall for wall in mesh.report.walls}[blunt]
        self.assertEqual((bare.covered, bare.least_height), (0.0, None))
        self.assertTrue(any(note.startswith(f"{blunt} has layers on 0.0%") for note in mesh.report.notes))
        self.assertGreater(mesh.report.covered, 0.5)
        with self.assertRaisesRegex(mq.InvalidInput, f"{blunt}: nowhere on it do layers"):
            mq.volume_mesh(region, **given, walls=[f"Face{i}" for i in range(1, 7)])

    def test_a_face_in_a_gap_thinner_than_the_layers_is_named_and_the_others_get_theirs(self):
        region = Part.makeBox(20, 8, 6).cut(Part.makeBox(6, 8, 5.98, Vector(7, 0, 0)))
        narrow = next(f"Face{i}" for i, face in enumerate(region.Faces, 1) if abs(face.CenterOfMass.z - 5.98) < 1e-6)
        given = {"layers": 3, "first_height": 0.1, "max_edge": 2.0}
        for more in ({}, {"patches": {"slot": [narrow]}, "patch_rest": "others", "walls": ["slot", "others"]}):
            mesh = mq.volume_mesh(region, **given, **more)
            self.assert_sound(mesh)
            self.assertEqual({wall.face: wall for wall in mesh.report.walls}[narrow].covered, 0.0)
            self.assertTrue(any(note.startswith(f"{narrow} has no layers: the gap there is 0.02 mm at most") for note in mesh.report.notes))
            self.assertGreater(mesh.report.covered, 0.7)
        with self.assertRaisesRegex(mq.InvalidInput, f"{narrow}: the layers are .* mm thick, but the gap there is 0.02 mm"):
            mq.volume_mesh(region, **given, walls=[narrow])

    def test_a_bare_corner_of_a_face_is_no_whole_face(self):
        for covered, said in ((0.99996, "99.9%"), (0.9731, "97.3%"), (0.0, "0.0%")):
            wall = WallCoverage("Face4", 10.0, covered, covered, 0.1, 0.1)
            self.assertTrue(bare_note(wall, 5.0, 0.2).startswith(f"Face4 has layers on {said} of its area only: elsewhere"))
        self.assertEqual(bare_note(wall, 0.02, 0.2), "Face4 has no layers: the gap there is 0.02 mm at most, and the layers are 0.2 mm thick")

    def test_cancelling(self):
        with self.assertRaises(mq.Cancelled):
            mq.volume_mesh(Part.makeBox(10, 8, 6), 3, 0.05, progress=lambda fraction, stage: fraction < 0.42)
        asked = []

        def until_the_last(fraction, stage):
            asked.append(stage)
            return asked.count("checking elements") < 8

        with self.assertRaises(mq.Cancelled):
            mq.volume_mesh(Part.makeBox(10, 8, 6), 3, 0.05, progress=until_the_last)

    def test_cancelling_is_answered_in_all_stages(self):
        last, gaps = [time.process_time()], []

        def progress(_, stage):
            gaps.append((time.process_time() - last[0], stage))
            last[0] = time.process_time()

        mesh = mq.volume_mesh(Part.makeCylinder(5, 40), 4, 0.02, walls=["Face1"], max_edge=0.9, growth_inside=0.1, progress=progress)
        self.assertGreater(sum(mesh.report.elements.values()), 100_000)
        self.assertLess(max(gaps[1:])[0], 0.2, max(gaps[1:]))
        self.assertLess(time.process_time() - last[0], 0.2)

    def test_shares_do_not_change_the_mesh(self):
        region, given = stepped_duct(), {"layers": 3, "first_height": 0.1, "max_edge": 2.0}
        whole, stages = mq.volume_mesh(region, **given), []
        with mock.patch.object(alike, "AT_A_TIME", 300):
            mesh = mq.volume_mesh(region, **given, progress=lambda _, stage: stages.append(stage))
            table = mq.measures(mesh)
        self.assertGreater(stages.count("checking elements"), sum(mesh.report.elements.values()) / 100)
        self.assertEqual(mesh.report, whole.report)
        for name in table.names:
            np.testing.assert_array_equal(table[name], mq.measures(whole)[name])

    def test_rows_that_are_alike(self):
        rows = np.sort(np.random.default_rng(3).integers(0, 40, (5000, 4)).astype(np.int32), axis=1)
        rows[::3] += 2**22  # more than fits into one number
        for columns in (None, 3):
            with mock.patch.object(alike, "AT_A_TIME", 700):
                parts = list(alike.groups(rows, columns=columns))
            self.assertGreater(len(parts), 5)
            chosen, begins = (np.concatenate(side) for side in zip(*parts))
            keys = rows[:, :columns]
            np.testing.assert_array_equal(chosen, np.lexsort(keys.T[::-1]))
            np.testing.assert_array_equal(np.diff(np.append(np.flatnonzero(begins), len(rows))), np.unique(keys, axis=0, return_counts=True)[1])


class VolumeFiles(helpers.DocumentTest):
    PATCHES = {"inlet": ["Face2"], "outlet": ["Face3"]}

    def bend(self):
        return mq.volume_mesh(pipe_bend(), layers=4, first_height=0.05, growth_rate=1.3, walls=["pipe"], max_edge=1.5,
                              patches=self.PATCHES, patch_rest="pipe")

    def test_files_hold_all_of_it(self):
        mesh = self.bend()
        for suffix in ("msh", "vtu", "su2", "cgns"):
            path = os.path.join(self.folder, f"bend.{suffix}")
            mesh.write(path)
            back = mq.read_mesh(path)
            self.assertEqual([block.kind for block in back.blocks if kinds.DIMENSION[block.kind] == 3], ["tetrahedron", "prism"])
            certificate = mq.certify(path)
            self.assertEqual(certificate.invalid, 0)
            certificate.save(f"{path}.json")
            self.assertTrue(mq.verify(f"{path}.json").holds, suffix)
            if suffix == "vtu":  # which has numbers for names
                self.assertEqual(len(back.groups), 4)
            else:
                self.assertTrue({"inlet", "outlet", "pipe"} <= set(back.groups), (suffix, back.groups))

    def with_pyramids(self):
        """A wedge in whose acute edge layers end."""
        return mq.volume_mesh(wedge(20), layers=3, first_height=0.05, max_edge=1.5, patches={"side": ["Face1"]}, patch_rest="others")

    @unittest.skipUnless(has("gmsh"), "Gmsh (python3-gmsh) is not installed")
    def test_gmsh_reads_prisms_and_pyramids(self):
        mesh = self.with_pyramids()
        self.assertGreater(len(mesh.pyramids), 0)
        path = os.path.join(self.folder, "wedge.msh")
        mesh.write(path)
        found = json.loads(exchange_run(PYTHON, "-c", READ_BY_GMSH, path))
        self.assertEqual(found["nodes"], len(mesh.nodes))
        self.assertEqual(found["elements"]["3"], len(mesh.tetrahedra) + len(mesh.pyramids) + len(mesh.prisms))
        self.assertEqual(found["elements"]["2"], len(mesh.boundary_triangles) + len(mesh.boundary_quadrilaterals))

    @unittest.skipUnless(has("meshio"), "meshio (python3-meshio) is not installed")
    def test_meshio_reads_prisms_and_pyramids(self):
        mesh = self.with_pyramids()
        solid = {"tetra": len(mesh.tetrahedra), "pyramid": len(mesh.pyramids), "wedge": len(mesh.prisms)}
        for suffix, form in (("msh", "gmsh"), ("vtu", "vtu"), ("su2", "su2")):
            path = os.path.join(self.folder, f"wedge.{suffix}")
            mesh.write(path)
            found = json.loads(exchange_run(PYTHON, "-c", READ_BY_MESHIO, path, form))
            self.assertEqual({name: found["cells"][name] for name in solid}, solid, suffix)
            self.assertEqual(found["points"], len(mesh.nodes), suffix)

    @unittest.skipUnless(has_cgns() and has("h5py"), "the CGNS library or h5py is not installed")
    def test_cgns_has_mixed_sections_families_and_conditions(self):
        for mesh in (self.with_pyramids(), self.bend()):
            path = os.path.join(self.folder, "mesh.cgns")
            mesh.write(path, scale=0.001)
            found = json.loads(exchange_run(PYTHON, "-c", READ_BY_HDF5, path))
            sizes = {name: sum(len(rows) for _, rows in parts) for name, parts in mesh.group_members.items()}
            self.assertEqual((found["sections"]["fluid"], sum(found["sections"].values()), found["points"]),
                             (sizes["fluid"], sum(sizes.values()), len(mesh.nodes)))
            self.assertEqual(found["families"], {name: name for name in mesh.patch_names})
            if shutil.which("cgnscheck"):
                said = exchange_run("cgnscheck", path)
                self.assertNotRegex(said, r"ERROR|WARNING")
            back = mq.read_mesh(path, scale=1000.0)
            self.assertEqual([(block.kind, len(block.nodes)) for block in back.blocks], [(block.kind, len(block.nodes)) for block in mesh.blocks])
            self.assertEqual({name: sum(len(rows) for _, rows in parts) for name, parts in back.group_members.items()}, sizes)
            np.testing.assert_allclose(back.nodes, mesh.nodes, atol=1e-9)

    def test_binary_cases_are_those_of_text(self):
        mesh, said = self.with_pyramids(), {}
        for binary in (False, True):
            folder = os.path.join(self.folder, f"case{binary:d}")
            mesh.write(folder, binary=binary)
            if shutil.which("checkMesh"):
                text = subprocess.run(["checkMesh"], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=300).stdout
                said[binary] = text[text.index("Mesh stats"):]
                self.assertIn("Mesh OK.", text)
        points = (open(os.path.join(self.folder, "case1", "constant", "polyMesh", "points"), "rb").read().split(b"(", 1)[1])[:24 * len(mesh.nodes)]
        np.testing.assert_array_equal(np.frombuffer(points).reshape(-1, 3), mesh.nodes * 0.001)
        self.assertEqual(said.get(False), said.get(True))
        with self.assertRaisesRegex(mq.InvalidInput, "binary"):
            mesh.write(os.path.join(self.folder, "wedge.msh"), binary=True)

    def test_openfoam_takes_the_case(self):
        folder = os.path.join(self.folder, "case")
        mesh = self.bend()
        mesh.write(folder)
        read = {name: open(os.path.join(folder, "constant", "polyMesh", name), encoding="utf-8").read()
                for name in ("owner", "neighbour", "boundary")}
        owner, neighbour = (np.array(re.findall(r"^\d+$", read[name], re.M)[1:], dtype=int) for name in ("owner", "neighbour"))
        inner = owner[:len(neighbour)]
        self.assertTrue((inner < neighbour).all())
        self.assertTrue((np.diff(inner * (neighbour.max() + 1) + neighbour) > 0).all())  # upper-triangular order
        self.assertEqual(re.findall(r"type (\w+)", read["boundary"]), ["patch", "patch", "wall"])
        with open(os.path.join(folder, "system", "fvSchemes"), encoding="utf-8") as stream:
            self.assertIn("gradSchemes { default Gauss pointLinear; }", stream.read())
        if not shutil.which("checkMesh"):
            self.skipTest("checkMesh is missing: Debian's package openfoam has it")
        said = subprocess.run(["checkMesh"], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=300).stdout
        self.assertIn("Mesh OK.", said)
        self.assertRegex(said, rf"prisms:\s+{len(mesh.prisms)}\n")
        self.assertRegex(said, rf"tetrahedra:\s+{len(mesh.tetrahedra)}\n")
        found = float(re.search(r"non-orthogonality Max: ([\d.]+)", said)[1])
        self.assertAlmostEqual(mesh.report.max_non_orthogonality, found, delta=1e-3 * found)

    def test_the_command_line(self):
        part, patches = (os.path.join(self.folder, name) for name in ("bend.brep", "bc.json"))
        pipe_bend().exportBrep(part)
        with open(patches, "w", encoding="utf-8") as stream:
            json.dump(self.PATCHES, stream)
        given = ["volume", part, "--layers", "3", "--first-height", "0.05", "--growth-rate", "1.3", "--max-edge", "2"]
        case = os.path.join(self.folder, "case")
        status, out, said = run(*given, "-o", case, "--wall", "Face1", "--patches", patches, "--json", "--strict")
        self.assertEqual(status, 0, said)
        self.assertEqual(json.loads(out)["covered"], 1.0)
        self.assertEqual(sorted(os.listdir(os.path.join(case, "constant", "polyMesh"))),
                         ["boundary", "faces", "neighbour", "owner", "points"])
        path = os.path.join(self.folder, "bend.vtu")
        status, _, said = run(*given, "-o", path)
        self.assertEqual(status, 0, said)
        self.assertEqual(mq.certify(path).invalid, 0)
        status, _, said = run(*given, "-o", path, "--wall", "Face7")
        self.assertEqual(status, 2)
        self.assertIn("Face7", "".join(said))
