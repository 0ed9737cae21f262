# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes the faces of one solid with Gmsh, for quality_peers.py: a Python that has gmsh runs it.

    quality_gmsh.py MODEL.brep OUT.off ALGORITHM ELEMENTS

ELEMENTS are those on a full turn of the curvature. Prints the seconds of the processor that the
meshing call took and the number of faces that got no triangle, as JSON.
"""

import json
import os
import sys
import time

import gmsh


def load(path, algorithm, elements):
    gmsh.initialize(["gmsh"])
    options = {
        "General.Terminal": 0, "General.NumThreads": 1,
        # An error would end the process otherwise, however many faces it has meshed.
        "General.AbortOnError": 0,
        "Mesh.Algorithm": algorithm, "Mesh.MeshSizeFromCurvature": elements,
    }
    for name, value in options.items():
        gmsh.option.setNumber(name, value)
    gmsh.model.add("part")
    gmsh.model.occ.importShapes(path)
    gmsh.model.occ.synchronize()


def write(path):
    """The triangles as OFF; returns the number of faces without any."""
    tags, points, _ = gmsh.model.mesh.getNodes()
    index = {int(tag): k for k, tag in enumerate(tags)}
    triangles, empty = [], 0
    for _, face in gmsh.model.getEntities(2):
        found = [nodes.reshape(-1, 3) for kind, nodes in
                 zip(*gmsh.model.mesh.getElements(2, face)[::2]) if kind == 2]
        empty += not found
        triangles += [[index[int(tag)] for tag in row] for nodes in found for row in nodes]
    with open(path, "w", encoding="ascii") as stream:
        stream.write(f"OFF\n{len(tags)} {len(triangles)} 0\n")
        stream.writelines("%.17g %.17g %.17g\n" % tuple(p) for p in points.reshape(-1, 3))
        stream.writelines("3 %d %d %d\n" % tuple(t) for t in triangles)
    return empty


def main():
    model, out, algorithm, elements = sys.argv[1:5]
    load(model, int(algorithm), float(elements))
    start, said = time.process_time(), ""
    try:
        gmsh.model.mesh.generate(2)
    except Exception as error:  # what is meshed is judged
        said = str(error)
    seconds = time.process_time() - start
    print(json.dumps({"seconds": seconds, "empty_faces": write(out), "said": said,
                      "version": gmsh.GMSH_API_VERSION}), flush=True)
    os._exit(0)


main()
