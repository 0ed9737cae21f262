# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of curved meshes, read back by the programs they are for: Gmsh and VTK."""

import json
import math
import os
import subprocess
import unittest

import helpers
import Part

import MeshQuality as mq

PYTHON = "/usr/bin/python3"
TETRAHEDRON, TRIANGLE = "Tetrahedron", "Triangle"

# In a process of its own: Gmsh's OpenCASCADE must not meet FreeCAD's.
READ_BY_GMSH = """
import json, sys
import gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
results = []
for path in sys.argv[1:]:
    gmsh.clear()
    gmsh.open(path)
    mesh = gmsh.model.mesh
    names = [gmsh.model.getPhysicalName(*group) for group in gmsh.model.getPhysicalGroups()]
    dimension = gmsh.model.getDimension()
    (kind,), (elements,), _ = mesh.getElements(dimension)
    name, _, order, width, _, _ = mesh.getElementProperties(kind)
    points, weights = mesh.getIntegrationPoints(kind, "Gauss12")
    _, determinants, _ = mesh.getJacobians(kind, points)
    determinants = determinants.reshape(len(elements), -1)
    results.append({"names": names, "nodes": len(mesh.getNodes()[0]), "name": name,
                    "order": int(order), "elements": len(elements),
                    "least": float(determinants.min()),
                    "measure": float((determinants * weights).sum())})
print(json.dumps(results))
"""


READ_BY_VTK = """
import json, sys
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(sys.argv[1])
reader.Update()
grid = reader.GetOutput()
off = 0.0
for c in range(0, grid.GetNumberOfCells(), 10):
    cell = grid.GetCell(c)
    count = cell.GetNumberOfPoints()
    places = cell.GetParametricCoords()
    for i in range(count):
        at = [0.0] * 3
        cell.EvaluateLocation(reference(0), places[3 * i:3 * i + 3], at, [0.0] * count)
        off = max(off, max(abs(a - b) for a, b in zip(at, cell.GetPoints().GetPoint(i))))
surface, triangles, mass = vtkDataSetSurfaceFilter(), vtkTriangleFilter(), vtkMassProperties()
surface.SetInputData(grid)
surface.SetNonlinearSubdivisionLevel(4)
triangles.SetInputConnection(surface.GetOutputPort())
mass.SetInputConnection(triangles.GetOutputPort())
mass.Update()
print(json.dumps({"points": grid.GetNumberOfPoints(), "cells": grid.GetNumberOfCells(),
                  "off": off, "volume": mass.GetVolume()}))
"""


def has(module):
    return subprocess.run([PYTHON, "-c", f"import {module}"], capture_output=True,
                          check=False).returncode == 0


class FileTest(helpers.DocumentTest):
    """Writes meshes into the folder and has programs read them."""

    def write(self, mesh, name):
        path = os.path.join(self.folder, name)
        mesh.write(path)
        return path

    def read(self, program, paths):
        """What a program of Python prints about files, as JSON in its last line."""
        done = subprocess.run([PYTHON, "-c", program, *paths], capture_output=True, text=True,
                              timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout.splitlines()[-1])


class Files(FileTest):
    @unittest.skipUnless(has("gmsh"), "Gmsh's Python module is not installed")
    def test_gmsh_reads_the_elements_that_were_written(self):
        solid, sphere = Part.makeCylinder(5, 10), Part.makeSphere(5)
        meshes = [mq.curve(solid, order=order, volume=True) for order in range(1, 5)]
        meshes += [mq.curve(sphere, order=order) for order in range(1, 6)]
        paths = [self.write(mesh, f"{i}.msh") for i, mesh in enumerate(meshes)]
        area = 4 * math.pi * 25
        for mesh, read in zip(meshes, self.read(READ_BY_GMSH, paths)):
            volume = len(mesh.tetrahedra) > 0
            self.assertTrue(read["name"].startswith(TETRAHEDRON if volume else TRIANGLE), read)
            self.assertEqual((read["order"], read["elements"], read["nodes"]),
                             (mesh.order, len(mesh.elements), len(mesh.nodes)))
            # Gmsh's Jacobians are those of the core: the same nodes in the same order.
            self.assertGreater(read["least"], 0.0)
            if volume:
                self.assertAlmostEqual(read["measure"] / mesh.report.volume, 1.0, places=9)
                self.assertEqual(sorted(read["names"]), ["Edge1", "Edge2", "Edge3", "Face1",
                                                         "Face2", "Face3", "Solid1"])
            else:
                self.assertLess(abs(read["measure"] / area - 1.0), 0.1 ** mesh.order)

    @unittest.skipUnless(has("vtkmodules"), "VTK's Python module is not installed")
    def test_vtk_reads_the_elements_that_were_written(self):
        for order, volume in ((1, True), (2, True), (3, True), (4, True), (2, False), (5, False)):
            with self.subTest(order=order, volume=volume):
                mesh = mq.curve(Part.makeTorus(10, 3), order=order, volume=volume)
                read = self.read(READ_BY_VTK, [self.write(mesh, f"{order}.vtu")])
                self.assertEqual((read["points"], read["cells"]),
                                 (len(mesh.nodes), len(mesh.elements)))
                # In VTK's node order its shape functions give each node its place, and the
                # elements' surfaces, cut finely, enclose the volume.
                self.assertLess(read["off"], 1e-9)
                self.assertAlmostEqual(read["volume"] / mesh.report.volume, 1.0, delta=2e-3)
