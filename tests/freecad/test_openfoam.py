# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases for OpenFOAM: files, levels, the point inside, and what OpenFOAM itself makes of them, where it is installed."""

import os
import re
import shutil
import subprocess

import helpers
import Part
from FreeCAD import Vector

import MeshQuality as mq
from MeshQuality.core.meshes.openfoam_case import case_of

ENVIRONMENT = {**os.environ, "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}


def tee():
    """A pipe with a branch, and its patches: one inlet and two outlets."""
    pipe = Part.makeCylinder(10, 60).fuse(Part.makeCylinder(6, 40, Vector(0, 0, 30), Vector(1, 0, 0))).removeSplitter()
    ends = {(0, 0, 0): "inlet", (0, 0, 60): "outlet_1", (40, 0, 30): "outlet_2"}
    patches = {}
    for number, face in enumerate(pipe.Faces, 1):
        for place, name in ends.items():
            if (face.CenterOfMass - Vector(*place)).Length < 1e-6:
                patches[name] = [f"Face{number}"]
    return pipe, patches


class Cases(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        pipe, patches = tee()
        self.mesh = mq.triangulate(pipe, chord_height=0.2, patches=patches, patch_rest="walls")
        self.case = os.path.join(self.folder, "case")

    def run_openfoam(self, *programs):
        """The output of the last program; skips where OpenFOAM is missing."""
        for program in programs:
            if not shutil.which(program):
                self.skipTest(f"{program} is missing: Debian's package openfoam has it")
            done = subprocess.run([program, *(["-overwrite"] if program == "snappyHexMesh" else [])], cwd=self.case,
                                  env=ENVIRONMENT, capture_output=True, text=True, timeout=300, check=False)
            self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr[-2000:])
        return done.stdout

    def test_files_and_levels(self):
        levels = mq.write_openfoam_case(self.mesh, self.case, name="pipe")
        self.assertEqual(set(levels), {"inlet", "outlet_1", "outlet_2", "walls"})
        for least, most in levels.values():
            self.assertTrue(0 <= least <= most <= 6)
        found = sorted(os.path.join(os.path.relpath(folder, self.case), name)
                       for folder, _, names in os.walk(self.case) for name in names)
        self.assertEqual(found, sorted(
            [f"constant/triSurface/pipe{suffix}" for suffix in (".eMesh", ".fms", ".stl")]
            + [f"system/{name}" for name in ("blockMeshDict", "controlDict", "fvSchemes", "fvSolution", "meshDict",
                                             "snappyHexMeshDict")]))
        with open(os.path.join(self.case, "system", "snappyHexMeshDict"), encoding="utf-8") as stream:
            text = stream.read()
        self.assertEqual(text.count("{"), text.count("}"))
        self.assertIn('"inlet" { level', text)

    def test_the_point_is_inside_of_the_part(self):
        pipe, _ = tee()
        for flow, inside in (("internal", True), ("external", False)):
            case = case_of(self.mesh, "pipe", flow, None, 0.001, {})
            self.assertEqual(pipe.isInside(Vector(*(1000 * case.inside)), 1e-6, False), inside)
            self.assertTrue(((case.low < case.inside) & (case.inside < case.high)).all())
        hollow = Part.makeBox(10, 10, 10).cut(Part.makeBox(8, 8, 8, Vector(1, 1, 1)))
        case = case_of(mq.triangulate(hollow, chord_height=1), "hollow", "internal", None, 0.001, {})
        self.assertTrue(hollow.isInside(Vector(*(1000 * case.inside)), 1e-6, False))

    def test_what_is_not_possible_is_refused(self):
        opened = mq.triangulate(Part.makePlane(1, 1))
        for call, words in ((lambda: mq.write_openfoam_case(opened, self.case), "open edges"),
                            (lambda: mq.write_openfoam_case(self.mesh, self.case, flow="sideways"), "flow = 'sideways'"),
                            (lambda: mq.write_openfoam_case(self.mesh, self.case, cell=1000), "cell = 1000"),
                            (lambda: mq.write_openfoam_case(self.mesh, self.case, name="a b"), "name = 'a b'"),
                            (lambda: mq.write_openfoam_case(self.mesh, self.case, types={"no": "wall"}), "'no'"),
                            (lambda: mq.write_openfoam_case(self.mesh, self.case, types={"walls": "x"}), "'x'")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                call()
        pipe, _ = tee()
        umlaut = mq.triangulate(pipe, chord_height=1, patch_rest="w\u00e4nde")
        bodies = mq.triangulate(Part.makeCompound([pipe, Part.makeBox(1, 1, 1, Vector(100, 0, 0))]), chord_height=1)
        for call, words in ((lambda: mq.write_openfoam_case(umlaut, self.case), "w\u00e4nde"),
                            (lambda: mq.write_openfoam_case(bodies, self.case), "2 solids"),
                            (lambda: mq.write_openfoam_case(self.mesh, self.case, types=["wall"]), "types = "),
                            (lambda: mq.write_openfoam_case(self.mesh, self.case, cell="1"), "cell = '1'"),
                            (lambda: mq.write_openfoam_case(self.mesh, self.case, scale=0), "scale = 0")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                call()
        with self.assertRaisesRegex(mq.IoError, "no folder"):
            mq.write_openfoam_case(self.mesh, "")
        self.assertFalse(os.path.exists(self.case))

    def test_a_patch_without_faces_is_left_out(self):
        mesh = mq.triangulate(Part.makeBox(1, 1, 1), patches={"inlet": []}, patch_rest="walls")
        self.assertEqual(set(mq.write_openfoam_case(mesh, self.case)), {"walls"})

    def test_objects_have_their_patches(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        obj = mq.add_quality_mesh(box, chord_height=0.1)
        mq.set_patches(obj, {"inlet": ["Face1"]}, patch_rest="walls")
        self.assertEqual(set(mq.write_openfoam_case(obj, self.case)), {"inlet", "walls"})

    def test_openfoam_meshes_the_inside(self):
        mq.write_openfoam_case(self.mesh, self.case, name="pipe")
        said = self.run_openfoam("blockMesh", "snappyHexMesh", "checkMesh")
        self.assertIn("Mesh OK.", said)
        with open(os.path.join(self.case, "constant", "polyMesh", "boundary"), encoding="utf-8") as stream:
            text = stream.read()
        found = dict(re.findall(r"^    (\w+)\s*\{\s*type\s+(\w+);", text, re.MULTILINE))
        self.assertEqual(found, {"inlet": "patch", "outlet_1": "patch", "outlet_2": "patch", "walls": "wall"})

    def test_openfoam_meshes_the_outside(self):
        mesh = mq.triangulate(Part.makeSphere(5), chord_height=0.2, patch_rest="body")
        mq.write_openfoam_case(mesh, self.case, flow="external", cell=4)
        said = self.run_openfoam("blockMesh", "snappyHexMesh", "checkMesh")
        self.assertIn("Mesh OK.", said)
        self.assertRegex(said, r"body\s+\d+\s+\d+\s+ok \(closed singly connected\)")

    def test_openfoam_takes_surfaces_of_parts_for_closed(self):
        if not shutil.which("surfaceCheck"):
            self.skipTest("surfaceCheck is missing: Debian's package openfoam has it")
        for name, part in helpers.simple_parts().items():
            path = os.path.join(self.folder, f"{name}.stl")
            mq.triangulate(part, chord_height=0.1).write(path, ascii=True, scale=0.001)
            said = subprocess.run(["surfaceCheck", path], cwd=self.folder, env=ENVIRONMENT, capture_output=True, text=True,
                                  timeout=60, check=False).stdout
            self.assertIn("Surface is closed", said, name)
            self.assertEqual(set(re.findall(r"^(Face\d+)\s", said, re.MULTILINE)),
                             {f"Face{i}" for i in range(1, len(part.Faces) + 1)}, name)
