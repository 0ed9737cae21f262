# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of OpenFOAM, read as text and binary, their derivatives, sizes and regions of refinement by them."""

import gzip
import os
import re
import shutil
import subprocess

import helpers
import numpy as np
import Part
from test_openfoam import ENVIRONMENT

import MeshQuality as mq
from MeshQuality.core.formats.openfoam import read_field, read_poly_mesh
from MeshQuality.core.sizes.refinement_regions import refinement_boxes

_KINDS = {1: ("volScalarField", "scalar"), 3: ("volVectorField", "vector")}


def write_field(case, name, values, patches, time="0"):
    """A field of cells as text."""
    kind, entry = _KINDS[1 if values.ndim == 1 else 3]
    rows = "\n".join(repr(row) if values.ndim == 1 else "(" + " ".join(map(repr, row)) + ")" for row in values.tolist())
    os.makedirs(os.path.join(case, time), exist_ok=True)
    sides = "".join(f"    {patch} {{ type zeroGradient; }}\n" for patch in patches)
    with open(os.path.join(case, time, name), "w", encoding="utf-8") as stream:
        stream.write(f"FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {kind};\n    object {name};\n}}\n// a comment (1 2)\n"
                     f"dimensions [0 0 0 0 0 0 0];\ninternalField nonuniform List<{entry}>\n{len(values)}\n(\n{rows}\n)\n;\n"
                     f"boundaryField\n{{\n{sides}}}\n")


class FlowSizes(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.case = os.path.join(self.folder, "case")
        mesh = mq.volume_mesh(Part.makeCylinder(10, 40), layers=3, first_height=0.3, max_edge=3, walls=["Face1"])
        mesh.write(self.case)
        self.patches = mesh.patch_names
        self.mesh = read_poly_mesh(self.case)
        self.centres, self.volumes = self.mesh.centres_and_volumes()

    def run_openfoam(self, *command):
        if not shutil.which(command[0]):
            self.skipTest(f"{command[0]} is missing: Debian's package openfoam has it")
        done = subprocess.run(command, cwd=self.case, env=ENVIRONMENT, capture_output=True, text=True, timeout=300, check=False)
        if 'error in IOstream "sha1"' in done.stdout + done.stderr:
            self.skipTest("this OpenFOAM fails with -func on any case, as that of Debian 13 does")
        self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr[-2000:])
        return done.stdout

    def test_polynomials_of_order_two_have_exact_derivatives(self):
        x, y, z = (self.centres * 1000).T
        write_field(self.case, "T", 2 * x * x - x * y + 3 * y * z - z + 5, self.patches)
        found = mq.flow_sizes(self.case, "T", error=1.0)
        np.testing.assert_allclose(found.points, self.centres * 1000, rtol=1e-12)
        np.testing.assert_allclose(found.gradients, np.column_stack((4 * x - y, 3 * z - x, 3 * y - 1)), atol=1e-2)
        np.testing.assert_allclose(found.hessians, np.tile([4, 0, 0, -1, 3, 0], (len(x), 1)), atol=1e-2)
        largest = np.abs(np.linalg.eigvalsh([[4, -1, 0], [-1, 0, 3], [0, 3, 0]])).max()
        wanted = np.clip(np.sqrt(8 / largest), found.cells / 4, found.cells * 4)
        np.testing.assert_allclose(found.sizes, wanted, rtol=1e-2)

    def test_centres_and_gradients_are_those_of_openfoam(self):
        field = np.sin(0.1 * self.centres @ [1000.0, 2000.0, 500.0])
        write_field(self.case, "T", field, self.patches)
        with open(os.path.join(self.case, "system", "fvSchemes"), "r+", encoding="utf-8") as stream:
            text = stream.read().replace("gradSchemes { default Gauss pointLinear; }", "gradSchemes { default leastSquares; }")
            self.assertIn("leastSquares", text)
            stream.seek(0)
            stream.truncate()
            stream.write(text)
        self.run_openfoam("postProcess", "-func", "writeCellCentres", "-time", "0")
        np.testing.assert_allclose(read_field(self.case, "C")[0], self.centres, atol=1e-8)
        self.run_openfoam("postProcess", "-func", "grad(T)", "-time", "0")
        theirs, ours = read_field(self.case, "grad(T)", 0)[0], 1000 * mq.flow_sizes(self.case, "T").gradients
        inner = np.ones(len(field), dtype=bool)
        inner[self.mesh.owner[len(self.mesh.neighbour):]] = False  # at patches theirs has that their normal gradient is zero
        exact = np.cos(0.1 * self.centres @ [1000.0, 2000.0, 500.0])[:, None] * [100.0, 200.0, 50.0]
        error = [np.linalg.norm((found - exact)[inner]) / np.linalg.norm(exact[inner]) for found in (ours, theirs)]
        self.assertLess(error[0], 0.03)
        self.assertLess(error[0], error[1])
        self.assertLess(np.linalg.norm((ours - theirs)[inner]) / np.linalg.norm(exact[inner]), 0.1)

    def test_binary_and_compressed_files_read_alike(self):
        write_field(self.case, "U", self.centres**2, self.patches)
        text = mq.flow_sizes(self.case, "U")
        self.assertEqual(text.values.shape, (self.mesh.cells, 3))
        for name in ("points", "faces"):
            path = os.path.join(self.case, "constant", "polyMesh", name)
            with open(path, "rb") as stream, gzip.open(f"{path}.gz", "wb") as packed:
                packed.write(stream.read())
            os.remove(path)
        np.testing.assert_array_equal(mq.flow_sizes(self.case, "U").sizes, text.sizes)
        with open(os.path.join(self.case, "system", "controlDict"), "r+", encoding="utf-8") as stream:
            control = stream.read().replace("writeFormat ascii", "writeFormat binary")
            stream.seek(0)
            stream.write(control)
        self.run_openfoam("foamFormatConvert", "-time", "0")
        with open(os.path.join(self.case, "0", "U"), "rb") as stream:
            self.assertIn(b"binary;", stream.read(2000))
        binary = mq.flow_sizes(self.case, "U")
        np.testing.assert_allclose(binary.values, text.values, rtol=1e-15)
        np.testing.assert_allclose(binary.sizes, text.sizes, rtol=1e-9)

    def test_decomposed_cases_read_like_whole_ones(self):
        points = self.centres * 1000
        values = np.sin(0.2 * points[:, 2]) + 0.01 * points[:, 0]**2
        write_field(self.case, "T", values, self.patches)
        whole = mq.flow_sizes(self.case, "T")
        with open(os.path.join(self.case, "system", "decomposeParDict"), "w", encoding="utf-8") as stream:
            stream.write("FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }\n"
                         "numberOfSubdomains 3;\nmethod simple;\nsimpleCoeffs { n (1 1 3); delta 0.001; }\n")
        self.run_openfoam("decomposePar", "-time", "0")
        shutil.rmtree(os.path.join(self.case, "0"))
        parts = mq.flow_sizes(self.case, "T")
        self.assertEqual(parts.time, "0")
        order, theirs = (np.lexsort(np.round(found.points, 6).T) for found in (whole, parts))
        np.testing.assert_allclose(parts.points[theirs], whole.points[order], atol=1e-6)
        np.testing.assert_allclose(parts.cells[theirs], whole.cells[order], rtol=1e-6)
        np.testing.assert_allclose(parts.hessians[theirs], whole.hessians[order], atol=1e-6 * np.abs(whole.hessians).max())
        np.testing.assert_allclose(parts.sizes[theirs], whole.sizes[order], rtol=1e-4)
        mesh = mq.triangulate(Part.makeCylinder(10, 40), size_field=f"{self.case}#T")
        self.assertEqual(len(mesh.triangles), len(mq.triangulate(Part.makeCylinder(10, 40), size_field=parts).triangles))
        with self.assertRaisesRegex(mq.InvalidInput, "is a folder"):
            mq.triangulate(Part.makeCylinder(10, 40), size_field=self.case)
        write_field(self.case, "T", values, self.patches, "1")  # later than that of the parts
        self.assertEqual(mq.flow_sizes(self.case, "T").time, "1")
        self.assertEqual(mq.flow_sizes(self.case, "T", time=0).time, "0")
        with self.assertRaisesRegex(mq.InvalidInput, "there at 0, 1"):
            mq.flow_sizes(self.case, "T", time=7)
        shutil.rmtree(os.path.join(self.case, "processor1"))
        with self.assertRaisesRegex(mq.IoError, "processor1 is missing"):
            mq.flow_sizes(self.case, "T")

    def test_surfaces_and_regions_follow(self):
        x = self.centres[:, 0] * 1000
        write_field(self.case, "T", np.tanh((self.centres[:, 2] * 1000 - 20) / 2) + 0 * x, self.patches, "12.5")
        found = mq.flow_sizes(self.case, "T", error=0.02, max_size=6.0)
        self.assertEqual(found.time, "12.5")
        near = abs(found.points[:, 2] - 20) < 3
        self.assertLess(np.median(found.sizes[near]), 0.5 * np.median(found.sizes[~near]))
        part = Part.makeCylinder(10, 40)
        surface = mq.triangulate(part, size_field=found)
        self.assertLessEqual(surface.report.size_ratio, 1.3)
        middle = surface.vertices[surface.triangles].mean(axis=1)[:, 2]
        self.assertGreater((abs(middle - 20) < 5).sum(), (abs(middle - 20) > 10).sum())
        plain, refined = os.path.join(self.folder, "plain"), os.path.join(self.folder, "refined")
        coarse = mq.triangulate(part, max_edge=6, chord_height=1)
        mq.write_openfoam_case(coarse, plain, cell=4)
        mq.write_openfoam_case(coarse, refined, cell=4, size_field=found)
        counts = []
        for self.case in (plain, refined):
            self.run_openfoam("blockMesh")
            self.run_openfoam("snappyHexMesh", "-overwrite")
            said = self.run_openfoam("checkMesh")
            self.assertIn("Mesh OK.", said)
            centres, volumes = read_poly_mesh(self.case).centres_and_volumes()
            counts.append((len(centres), np.cbrt(volumes)[abs(centres[:, 2] - 0.02) < 0.002].mean()))
        self.assertGreater(counts[1][0], 1.5 * counts[0][0])
        self.assertLess(counts[1][1], 0.8 * counts[0][1])

    def test_boxes_cover_what_is_fine_and_no_more(self):
        low, high = np.zeros(3), np.array([80.0, 40.0, 40.0])
        boxes = refinement_boxes(lambda p: np.where((p[:, 0] < 20) & (p[:, 1] > 20), 1.0, 9.0), low, high, 4.0, 6)
        self.assertEqual([level for *_, level in boxes], [2, 1])
        for first, last, _ in boxes:
            np.testing.assert_allclose((*first, *last), (0, 20, 0, 20, 40, 40))
        self.assertEqual(refinement_boxes(lambda p: np.full(len(p), 5.0), low, high, 4.0, 6), [])
        noise = np.random.RandomState(3)
        self.assertLessEqual(len(refinement_boxes(lambda p: noise.choice([1.0, 9.0], len(p)), low, high, 1.0, 6)), 400)

    def test_what_is_wrong_is_named(self):
        write_field(self.case, "T", self.centres[:, 0], self.patches)
        write_field(self.case, "few", self.centres[:5, 0], self.patches)
        write_field(self.case, "holes", np.where(np.arange(len(self.centres)) == 7, np.nan, 1.0), self.patches)
        for call, said in ((lambda: mq.flow_sizes(self.case, "p"), "no time has a field p"), (lambda: mq.flow_sizes("nowhere", "p"), "nowhere"),
                           (lambda: mq.flow_sizes(self.case, "T", time=3), "T is there at 0"),
                           (lambda: mq.flow_sizes(self.case, "few"), "has 5 values for"),
                           (lambda: mq.flow_sizes(self.case, "holes"), "no number in cell 7"),
                           (lambda: mq.flow_sizes(self.case, "T", error=-1), "error = -1"),
                           (lambda: mq.flow_sizes(self.case, "T", change=0.5), "change = 0.5"),
                           (lambda: mq.flow_sizes(self.case, "T", min_size=3, max_size=2), "is above max_size")):
            with self.assertRaisesRegex((mq.InvalidInput, mq.IoError), said):
                call()
        path = os.path.join(self.case, "0", "T")
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        for changed, said in ((text.replace("internalField", "other"), "no internalField"), (text.replace("volScalar", "pointScalar"), "is a pointScalarField"),
                              (re.sub(r"\n\d+\n\(", "\n7\n(", text, count=1), "says 7 entries"), ("nothing", "no header")):
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(changed)
            with self.assertRaisesRegex(mq.IoError, said):
                mq.flow_sizes(self.case, "T")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(re.sub(r"nonuniform.*?\n\)\n", "uniform 4", text, flags=re.DOTALL))
        even = mq.flow_sizes(self.case, "T")
        np.testing.assert_allclose(even.sizes, 4 * even.cells)
