# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arguments of bin/meshquality. Its help and its manual page are made from this parser.

Imports nothing of FreeCAD.
"""

import argparse
import re
import sys

from .. import options
from ..formats import CURVED_SUFFIXES, ELEMENTS_WRITTEN, FLAT_ONLY_SUFFIXES, READABLE, SUFFIXES
from ..version import __version__

CAD_SUFFIXES = (".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".fcstd")
MESH_SUFFIXES = (".stl", ".ply", ".obj", ".off", ".bms", ".ast")
SOLID_SUFFIXES = (".step", ".stp")
POINT_SUFFIXES = (".xyz", ".asc", ".txt", ".csv", ".pts")  # a line a point; more columns than three are left out
ELEMENT_SUFFIXES = tuple(READABLE)  # extensions of meshes that other programs made

INPUTS = {"triangulate": CAD_SUFFIXES, "curve": CAD_SUFFIXES, "improve": MESH_SUFFIXES, "simplify": MESH_SUFFIXES,
          "quality": MESH_SUFFIXES, "measures": MESH_SUFFIXES + ELEMENT_SUFFIXES, "section": MESH_SUFFIXES + ELEMENT_SUFFIXES, "to-solid": MESH_SUFFIXES, "certify": ELEMENT_SUFFIXES,
          "verify": (".json",), "boolean": MESH_SUFFIXES + CAD_SUFFIXES,
          "thickness": MESH_SUFFIXES + CAD_SUFFIXES, "clearance": MESH_SUFFIXES + CAD_SUFFIXES,
          "draft": MESH_SUFFIXES + CAD_SUFFIXES, "voids": MESH_SUFFIXES + CAD_SUFFIXES,
          "offset": MESH_SUFFIXES + CAD_SUFFIXES, "hollow": MESH_SUFFIXES + CAD_SUFFIXES,
          "wrap": MESH_SUFFIXES + CAD_SUFFIXES, "cam": MESH_SUFFIXES + CAD_SUFFIXES, "deviation": MESH_SUFFIXES + POINT_SUFFIXES,
          "adapt": (".fcstd",), "volume": CAD_SUFFIXES}
OUTPUTS = {"triangulate": SUFFIXES, "curve": CURVED_SUFFIXES + FLAT_ONLY_SUFFIXES, "improve": SUFFIXES, "simplify": SUFFIXES,
           **dict.fromkeys(("boolean", "offset", "hollow"), SUFFIXES + SOLID_SUFFIXES), "wrap": SUFFIXES, "cam": SUFFIXES,
           "adapt": CURVED_SUFFIXES, "section": ELEMENTS_WRITTEN, "to-solid": SOLID_SUFFIXES, "volume": tuple(suffix for suffix in ELEMENTS_WRITTEN if suffix != ".re2"),  # no prisms
           **dict.fromkeys(("quality", "measures", "certify", "verify", "thickness", "clearance", "draft", "voids", "deviation"), ())}
WITH_INPUTS = ("boolean", "clearance", "wrap")  # that take several files
# Commands whose meshes have faces of a shape, of which patches are made.
WITH_PATCHES = ("triangulate", "curve", "volume")
FOLDERS = ("volume",)  # commands that write a case of OpenFOAM into an output without extension
TABLES = {"triangulate": (*options.TRIANGULATE, options.THREADS), "curve": (*options.CURVE, options.THREADS),
          "improve": options.IMPROVE, "simplify": options.simplify.SIMPLIFY, "boolean": (*options.BOOLEAN, options.THREADS), "quality": (), "measures": (), "section": (), "to-solid": (),
          "certify": (), "verify": (), "thickness": options.inspection.THICKNESS, "clearance": options.inspection.CLEARANCE,
          "draft": options.inspection.DRAFT, "voids": options.inspection.VOIDS,
          "deviation": options.inspection.DEVIATION,
          "offset": options.offset.OFFSET, "hollow": options.offset.HOLLOW,
          "wrap": options.wrap.WRAP, "cam": options.cam.CAM, "adapt": options.adapt.ADAPT,
          "volume": options.volume.VOLUME}
_FLAT_HEADING = {"Display": "Flat triangles"}
# Commands that have a page with pictures of what they made or measured.
WITH_PAGES = ("triangulate", "curve", "improve", "simplify", "quality", "boolean", "offset", "hollow", "wrap", "cam", "thickness", "draft", "deviation")
BATCHED = ("triangulate", "curve", "improve", "quality")

STATUS = ("Exit status: 0 done, 1 failed, 2 bad usage or input, 3 with --strict: done, but a requested limit is not "
          "met.\nThe last line on stderr says why.")

EXAMPLES = {
    None: """
examples:
  meshquality triangulate part.step -o part.ply --chord-height-relative 0.001
  meshquality curve part.step --order 2 --volume -o part.msh
  meshquality boolean a.stl b.stl --operation difference -o c.stl
  meshquality batch parts/ -o out/ --jobs 8
""",
    "triangulate": """
examples:
  meshquality triangulate part.step -o part.ply              max. deviation 0.003 of the size
  meshquality triangulate part.FCStd --object Body -o part.stl --chord-height 0.05
  meshquality triangulate part.step --local-sizes "Face3=0.5, Edge7=0.2" --json
  meshquality triangulate duct.step --patches bc.json -o duct.stl --ascii --scale 0.001
  cat part.brep | meshquality triangulate - --input-format brep -o - --format ply > part.ply
""",
    "curve": """
examples:
  meshquality curve part.step --order 3 -o part.vtu
  meshquality curve part.step --volume -o part.inp           quadratic tetrahedra for CalculiX
  meshquality curve part.step -o part.stl --deviation 0.01   flat triangles
  meshquality curve part.step --volume --patches bc.json -o part.cgns --scale 0.001
  meshquality curve part.step --mesh netgen.unv --order 2 -o part.inp      curves a mesh that you have
""",
    "boolean": """
examples:
  meshquality boolean block.step scan.stl --operation difference -o left.ply --tolerance 0.01
  meshquality boolean a.stl b.stl c.stl -o all.stl
""",
    "offset": """
examples:
  meshquality offset part.step --distance 0.5 -o larger.stl
  meshquality offset scan.stl --distance -1 --tolerance 0.02 -o core.ply
""",
    "hollow": """
examples:
  meshquality hollow part.step --thickness 2 -o shell.stl
  meshquality hollow cup.step --thickness 1.2 --openings Face3,Face5 -o cup.stl --strict
""",
    "cam": """
examples:
  meshquality cam part.step --tolerance 0.05 -o part.stl
  meshquality cam core.step --tolerance 0.1 --side inside -o core.stl
""",
    "wrap": """
examples:
  meshquality wrap assembly.step --gap 2 -o outside.stl
  meshquality wrap scan.stl frame.step --gap 5 --tolerance 0.5 --dry "0, 0, 300" -o outside.ply --strict
""",
    "improve": """
examples:
  meshquality improve scan.stl -o better.ply --min-angle 30
""",
    "simplify": """
examples:
  meshquality simplify scan.stl -o lighter.stl --tolerance 0.05
""",
    "quality": """
examples:
  meshquality quality part.stl
  meshquality quality part.stl --shape part.step --json
""",
    "measures": """
examples:
  meshquality measures part.stl
  meshquality measures mesh.msh --csv measures.csv --json
""",
    "section": """
examples:
  meshquality section mesh.msh --point 0,0,12.5 --normal z --csv cut.csv
  meshquality section part.stl --point 5,0,0 --normal 1,1,0 -o half.vtu --json
""",
    "to-solid": """
examples:
  meshquality to-solid print.stl -o print.step
  meshquality hollow part.step --thickness 2 -o shell.step   exact surfaces, as the CAD is known
""",
    "certify": """
examples:
  meshquality certify mesh.msh
  meshquality certify mesh.inp --shape part.step --json
  meshquality certify metres.msh --shape part.step --mesh-scale 1000
  meshquality certify mesh.msh --save mesh.cert.json         to be checked again by verify
""",
    "verify": """
examples:
  meshquality verify mesh.cert.json
  meshquality verify mesh.cert.json --mesh copies/mesh.msh
""",
    "thickness": """
examples:
  meshquality thickness part.step
  meshquality thickness part.step --min-thickness 1.2 --strict --csv walls.csv
  meshquality thickness scan.stl --measure rays --gap --json
""",
    "clearance": """
examples:
  meshquality clearance assembly.step --min-clearance 0.2 --strict
  meshquality clearance case.step board.step fan.stl --within 5 --json
""",
    "draft": """
examples:
  meshquality draft part.step --pull-direction z --min-draft 1.5
  meshquality draft part.step --pull-direction 0,1,0.2 --csv draft.csv --json
""",
    "voids": """
examples:
  meshquality voids print.stl --strict
""",
    "adapt": """
examples:
  meshquality adapt bracket.FCStd --target-error 0.02 -o bracket.inp
""",
    "volume": """
examples:
  meshquality volume pipe.step -o case --layers 5 --first-height 0.05 --growth-rate 1.2 --wall Face1
  meshquality volume duct.step -o duct.msh --layers 8 --first-height 0.01 --patches bc.json --wall walls
  meshquality volume wing.step -o case --far-field box:10 --symmetry 'y>0' --layers 12 --y-plus 1 --speed 30 --length 200
""",
    "deviation": """
examples:
  meshquality deviation scan.stl --reference part.step --align any --tolerance 0.1 --strict
  meshquality deviation points.xyz --reference part.step --mesh-scale 25.4 --csv deviation.csv --json
""",
    "batch": """
examples:
  meshquality batch parts/ -o out/ --chord-height-relative 0.002
  meshquality batch parts/ -o out/ --command curve --volume --order 2 --format msh
  meshquality batch parts/ -o out/ --scheduler tcp://head:8786
""",
}


class Formatter(argparse.RawDescriptionHelpFormatter):
    """Help with room for the names of options; descriptions and examples are left as they are."""

    def __init__(self, prog):
        super().__init__(prog, max_help_position=26)
        self._action_max_length = 22  # least width; argparse's own forgets that commands are indented


_NEGATIVE_NUMBER = re.compile(r"-(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$")


def parser(batched="triangulate"):
    """The argument parser; `batched` is what `batch` does to each part: its options are taken."""
    top = argparse.ArgumentParser(
        prog="meshquality", formatter_class=Formatter,
        description="Quality meshes of CAD shapes, and operations on meshes. Lengths are in mm, angles in "
                    "degrees.",
        epilog=EXAMPLES[None].lstrip("\n") + "\nmeshquality COMMAND --help lists the options of a "
               "command.\n" + STATUS)
    top.add_argument("--version", action="version", version=f"meshquality {__version__}")
    commands = top.add_subparsers(title="commands", dest="command", required=True,
                                  metavar="COMMAND")
    _add_single(commands, "triangulate", "mesh a CAD shape",
                "Triangulates a CAD shape with a guaranteed smallest angle and deviation.")
    _add_single(commands, "curve", "mesh a CAD shape with curved elements",
                "Meshes a CAD shape with curved triangles or tetrahedra, each proven valid.\n"
                "By the extension of the output, .msh, .msh2, .vtu, .mesh and .xml hold the curved elements, .cgns\n"
                "those up to order 4, .inp, .unv, .nas, .bdf and .exo those of order 1 and 2, .su2 straight ones, the\n"
                "others flat triangles.")
    _add_single(commands, "boolean", "unite, intersect or subtract closed meshes and shapes",
                "Boolean of two or more meshes or CAD shapes, applied in their order. The result\n"
                "is closed and free of self-intersections.")
    _add_offsets(commands)
    _add_wrap(commands)
    _add_changed_meshes(commands)
    one = _add_single(commands, "quality", "measure the quality of a mesh",
                      "Measures a mesh: topology, angles, and its distance to a shape if given.")
    one.add_argument("--shape", metavar="CAD", help="CAD file to measure the distance to")
    _add_measures(commands)
    one = _add_single(commands, "certify", "prove which elements of any mesh are valid",
                      "Proves which elements of a mesh that any program made are valid: triangles, quadrilaterals,\n"
                      "tetrahedra, prisms, pyramids and hexahedra of orders 1 to 5.")
    one.add_argument("--shape", metavar="CAD", help="CAD file that the surface of the mesh is measured against")
    _add_mesh_scale(one)
    one.add_argument("--save", metavar="FILE.json", help="file for the certificate, which verify checks again")
    one = _add_single(commands, "verify", "check a saved certificate of a mesh again",
                      "Checks a certificate of certify --save: that the mesh is the same file, and, by a verifier that\n"
                      "shares no code with the prover, that each element is what the certificate says. Exit status 3 where\n"
                      "it does not hold.")
    one.add_argument("--mesh", metavar="FILE", help="the mesh, where it is not where the certificate says: "
                     f"{' '.join(ELEMENT_SUFFIXES)}")
    one = _add_single(commands, "thickness", "measure the thickness of walls, or the width of gaps",
                      "Measures how thick the walls of a CAD shape or a mesh are, by rays and by inscribed spheres, and where\n"
                      "they are thinnest. Exit status 3 with --strict where a wall is thinner than --min-thickness.")
    one.add_argument("--csv", metavar="FILE.csv", help="file for the values of each triangle")
    _add_single(commands, "clearance", "measure the distances between bodies",
                "Measures how near the bodies of an assembly are to each other: the solids of one CAD file, or several files,\n"
                "each of them a body. Exit status 3 with --strict where bodies overlap or are nearer than --min-clearance.")
    one = _add_single(commands, "draft", "measure the draft and the undercuts of a moulded shape",
                      "Measures the draft of a CAD shape or a mesh against the direction in which a mould opens, and its undercuts.\n"
                      "Exit status 3 with --strict where there are undercuts, or faces with less draft than --min-draft.")
    one.add_argument("--pull-direction", default="z", metavar="X,Y,Z",
                     help="direction in which one half of the mould opens, or one of x, y, z, -x, -y, -z (default: z)")
    one.add_argument("--csv", metavar="FILE.csv", help="file for the values of each triangle")
    _add_single(commands, "voids", "find closed cavities",
                "Finds the closed cavities of a CAD shape or a mesh, from which nothing comes out, and their volumes.\n"
                "Exit status 3 with --strict where there are some.")
    _add_volumes(commands)
    _add_deviation(commands)
    _add_batch(commands, batched)
    return top


def _add_changed_meshes(commands):
    _add_single(commands, "improve", "improve the triangles of a mesh",
                "Improves the triangles of a mesh on its own surface; sharp edges stay.")
    _add_single(commands, "simplify", "fewer triangles within a proven distance",
                "The same surface with fewer triangles: no point of either is farther than the tolerance from the other one, proven.")


def _add_measures(commands):
    one = _add_single(commands, "measures", "measure each element as Verdict and OpenFOAM do",
                      "Measures each element of a mesh: edge ratio, aspect ratio, scaled Jacobian, equiangle skew, angles, skew, taper and\n"
                      "warpage as Verdict defines them, and of volumes OpenFOAM's non-orthogonality and skewness.")
    one.add_argument("--csv", metavar="FILE.csv", help="file for the measures of each element")
    one = _add_single(commands, "section", "cut a mesh by a plane",
                      "Cuts a mesh by a plane: how many elements it cuts, the area of the cut, of a surface of what it encloses. -o writes the\n"
                      "whole elements whose middle is not in the half that is cut off.")
    one.add_argument("--point", default=(0.0, 0.0, 0.0), type=_place, metavar="X,Y,Z", help="a place on the plane, mm (default: 0,0,0)")
    one.add_argument("--normal", required=True, metavar="X,Y,Z",
                     help="direction to the half that is cut off, of any length, or one of x, y, z, -x, -y, -z")
    one.add_argument("--csv", metavar="FILE.csv", help="file for the area of each element that is cut")


    _add_single(commands, "to-solid", "a CAD solid of planar facets from a closed mesh",
                "Makes a CAD solid of a closed mesh, coplanar triangles merged to one face, checks it and reads the STEP file back. A mesh in a\n"
                "file knows no CAD: boolean, offset and hollow of CAD files write solids with exact surfaces into .step themselves.")


def _add_volumes(commands):
    _add_single(commands, "adapt", "refine the mesh of an analysis where its error is",
                "Solves the analysis of a FreeCAD document by CalculiX, refines its FEM mesh where the estimated error is, and so on\n"
                "until that is small enough. --object: the analysis, where there are several.")

    one = _add_single(commands, "volume", "fill a solid, or the space around it, for flow solvers, with layers on walls",
                      "Fills a CAD solid, the region of a flow, or the space around a part with layers of prisms on the walls and tetrahedra,\n"
                      "each proven valid.\n"
                      "Where -o FILE has no extension it is a folder, which becomes a case of OpenFOAM with constant/polyMesh, in metres.\n"
                      "Exit status 3 with --strict where layers had to be left off.")
    one.add_argument("--wall", dest="walls", metavar="NAMES", type=lambda text: [name.strip() for name in text.split(",")],
                     help="faces, or patches of --patches, that get layers, such as Face1,Face4; the faces beside them must be planes "
                          "(default: all of the part)")
    one.add_argument("--binary", action="store_true", help="of a case of OpenFOAM: numbers as bytes instead of text")
    one.add_argument("--far-field", metavar="FORM",
                     help="the flow goes around the part: box or sphere, with its distance in sizes of the part, such as box:10 (default: 5), "
                          "or a CAD file with a solid. Its faces are xMin to zMax, farField, Far1, Far2, ... in --patches")
    one.add_argument("--symmetry", metavar="HALF", help="half-space of the fluid, 'y>0' or 'z>-2.5', in mm; its plane is the patch symmetry")
    flow = one.add_argument_group("first height by y+")
    flow.add_argument("--y-plus", type=float, metavar="N",
                      help="of the centre of the first cell: instead of --first-height, estimated as on a flat plate")
    flow.add_argument("--speed", type=float, metavar="M/S", help="of the free flow")
    flow.add_argument("--length", type=float, metavar="MM", help="of the wall along the flow; of a duct its diameter")
    flow.add_argument("--fluid", default="air", metavar="NAME", help="air or water of 20 degrees Celsius, or m^2/s of kinematic viscosity "
                                                                     "(default: air)")


def _add_deviation(commands):
    one = _add_single(commands, "deviation", "measure how far a scan is from a part",
                      "Measures the signed distance of each vertex of a mesh, or of each point of a text file, from a CAD shape or\n"
                      "another mesh: positive outside. Exit status 3 with --strict where points are beyond --tolerance.")
    one.add_argument("--reference", metavar="FILE", required=True,
                     help=f"the CAD file or mesh that is measured against: {' '.join(CAD_SUFFIXES + MESH_SUFFIXES)}")
    _add_mesh_scale(one)
    one.add_argument("--csv", metavar="FILE.csv", help="file for the deviation of each point")


def _places(text):
    try:
        places = [tuple(float(x) for x in place.split(",")) for place in text.split(";")]
    except ValueError:
        places = [()]
    if any(len(place) != 3 for place in places):
        raise argparse.ArgumentTypeError(f"'{text}' is no list of places such as '0, 0, 300; 10, 0, 20'")
    return places


def _place(text):
    places = _places(text)
    if len(places) != 1:
        raise argparse.ArgumentTypeError(f"'{text}' is no place such as 0,0,12.5")
    return places[0]


def _add_offsets(commands):
    _add_single(commands, "offset", "grow or shrink a solid by a distance",
                "All points within a distance of a CAD shape or a mesh, or those deeper in it. The result is closed and free\n"
                "of self-intersections, and its distance is proven.")
    one = _add_single(commands, "hollow", "leave a wall of a solid",
                      "Leaves a wall of a CAD shape or a mesh, which grows inward. The result is closed and free of\n"
                      "self-intersections, and its distance is proven.")
    one.add_argument("--openings", metavar="FACES", type=lambda text: [face.strip() for face in text.split(",")],
                     help="faces of the shape that the hollow reaches, such as Face3,Face5 (default: it is closed)")


def _add_wrap(commands):
    _add_single(commands, "cam", "a mesh for machining on one side of a solid",
                "A mesh of a CAD shape or a mesh that is never inside of it, so that a tool that touches the mesh does not cut into the\n"
                "part, or never outside. Which side it is on is proven, as its distance is.")
    one = _add_single(commands, "wrap", "close the outer surface of objects that need not be clean",
                      "The outer surface of one or several CAD shapes and meshes, which may overlap, be open, or have gaps: all\n"
                      "that a ball as wide as the gap can touch from outside. The result is closed and free of\n"
                      "self-intersections. Exit status 3 with --strict where a place of --dry is not dry.")
    one.add_argument("--dry", metavar="PLACES", type=_places,
                     help='places in mm that are to stay inside, as in "0, 0, 300; 10, 0, 20" (default: none)')


def _new(commands, name, title, description, arguments):
    """A parser of a command. No abbreviations: what a script says must mean the same in all later versions."""
    made = commands.add_parser(name, help=title, description=description, allow_abbrev=False,
                               usage=f"meshquality {name} {arguments} [options]",
                               epilog=EXAMPLES[name].lstrip("\n") + "\n" + STATUS,
                               formatter_class=Formatter)
    # What argparse takes for a number, not for an option; it knows none with an exponent before Python 3.14.
    made._negative_number_matcher = _NEGATIVE_NUMBER
    return made


def _add_single(commands, name, title, description):
    inputs = {"boolean": "INPUT INPUT ...", "clearance": "INPUT ...", "wrap": "INPUT ..."}.get(name, "INPUT")
    output = " [-o FILE]" if OUTPUTS[name] else ""
    one = _new(commands, name, title, description, inputs + output)
    kind = {CAD_SUFFIXES: "CAD file", MESH_SUFFIXES: "mesh file", ELEMENT_SUFFIXES: "mesh file",
            (".json",): "certificate", (".fcstd",): "FreeCAD document", MESH_SUFFIXES + ELEMENT_SUFFIXES: "mesh file", MESH_SUFFIXES + POINT_SUFFIXES: "mesh or file of points"}.get(INPUTS[name],
                                                                      "mesh or CAD file")
    text = f"{kind}: {' '.join(INPUTS[name])}; -: standard input"
    if name in WITH_INPUTS:
        one.add_argument("inputs", nargs="+", metavar="INPUT", help=text)
    else:
        one.add_argument("input", metavar="INPUT", help=text)
    one.add_argument("--input-format", metavar="NAME",
                     help="format of standard input: " + _names(INPUTS[name]))
    if OUTPUTS[name]:
        one.add_argument("-o", "--output", metavar="FILE",
                         help=f"mesh file: {' '.join(OUTPUTS[name])}; -: standard output")
        one.add_argument("--format", metavar="NAME",
                         help="format of the mesh, whatever the extension: " + _names(OUTPUTS[name]))
    if name in WITH_PATCHES:
        _add_writing(one, with_patches=True, with_interfaces=name == "triangulate", with_text=name != "volume")
    _add_strict(one, "the mesh is written, but" if OUTPUTS[name] else "the mesh")
    if name not in ("improve", "simplify", "verify", "measures", "section", "to-solid"):
        one.add_argument("--object", metavar="NAME",
                         help="name or label of the object to take from an FCStd file; default: all "
                              "final ones")
    one.add_argument("--json", action="store_true",
                     help="print the report as one JSON object on stdout")
    if name in WITH_PAGES:
        one.add_argument("--report", dest="page", metavar="FILE.html",
                         help="file for a page with pictures, what was requested and found, a histogram, faces and places; FILE.pdf is printed by a browser")
    running = one.add_argument_group("limits")
    running.add_argument("--time-limit", type=float, metavar="SECONDS",
                         help="end with status 1 after this time, reading and checks included (default: none)")
    running.add_argument("--memory-limit", type=float, metavar="GIB",
                         help="end with status 1 beyond this memory; on Linux (default: none)")
    _add_options(one, TABLES[name])
    if name == "curve":
        one.add_argument("--mesh", metavar="FILE",
                         help="a mesh of triangles or tetrahedra that another program made of the part: it is curved, and "
                              f"stays as it is unless elements would be invalid: {' '.join(ELEMENT_SUFFIXES)}")
        _add_mesh_scale(one)
        _add_options(one, options.CURVED_DISPLAY, _FLAT_HEADING)
    return one


def _add_mesh_scale(one):
    one.add_argument("--mesh-scale", type=float, default=1.0, metavar="FACTOR",
                     help="factor from the coordinates of the given mesh to mm: 1000 for one in metres, 25.4 for inches "
                          "(default: 1)")


def _add_writing(one, with_patches, with_interfaces=False, with_text=True):
    """What is written of a mesh; `with_patches` has a file that names faces, which fits one part only."""
    file = one.add_argument_group("file")
    if with_patches:
        file.add_argument("--patches", metavar="FILE.json",
                          help='named groups of faces: {"inlet": ["Face1", "Face4"]}, or {"inlet": {"faces": ["Face1"], '
                               '"colour": "#ff0000"}}')
    file.add_argument("--patch-rest", metavar="NAME",
                      help="name of the patch of all other faces (default: each face is one by its own name)")
    file.add_argument("--scale", type=float, default=1.0, metavar="FACTOR",
                      help="factor of the coordinates, which are mm: 0.001 for metres (default: 1)")
    if with_interfaces:
        file.add_argument("--interfaces", nargs="?", const=True, default=False, type=_interfaces, metavar="sheet",
                          help="with --imprint: what lies between two solids is a patch of its own, Solid1_to_Solid2 on "
                               "the side of the first; sheet: one for both, Solid1_and_Solid2, with its triangles once")
    if with_text:
        file.add_argument("--ascii", action="store_true", help="STL as text, with one solid a patch")


def _add_strict(one, start):
    one.add_argument("--strict", action="store_true",
                     help=f"exit with status 3 where {start} does not meet a requested limit or has faults; see "
                          "the verdict in --json")


def _names(suffixes):
    return ", ".join(suffix[1:] for suffix in suffixes)


def _add_batch(commands, batched):
    one = _new(
        commands, "batch", "process every file below a folder",
        "Meshes every file below a folder, on several cores or machines. A part that crashes, hangs\n"
        "or takes too much memory costs that part only. A second run does what is missing.\n"
        "The options of --command are taken, too: see triangulate, curve, improve and quality.", "DIR -o OUT")
    one.add_argument("folder", metavar="DIR", help="folder with CAD files (meshes for improve and "
                     "quality); subfolders are searched, too")
    one.add_argument("-o", "--output", metavar="OUT", required=True,
                     help="folder for meshes/, parts.jsonl (one line per part), parts.csv and report.html")
    one.add_argument("--command", dest="batched", choices=BATCHED, metavar="NAME",
                     default="triangulate",
                     help=f"command for each part: {', '.join(BATCHED)} (default: triangulate)")
    one.add_argument("--format", metavar="NAME", help="format of the meshes (default: ply; "
                     "curve: msh)")
    one.add_argument("--only", action="append", metavar="PATTERN",
                     help="only files whose path below DIR matches, such as 'gears/*.step'; can be "
                          "repeated")
    running = one.add_argument_group("execution")
    running.add_argument("--jobs", type=int, metavar="N",
                         help="parts processed at the same time on this machine (default: number of "
                              "cores)")
    running.add_argument("--scheduler", metavar="ADDRESS",
                         help="use the Dask cluster with this scheduler, such as tcp://host:8786; its "
                              "workers must see DIR, OUT and this program under the same paths")
    running.add_argument("--time-limit", type=float, default=600.0, metavar="SECONDS",
                         help="time limit for each part (default: 600)")
    running.add_argument("--memory-limit", type=float, default=4.0, metavar="GIB",
                         help="memory limit for each part (default: 4)")
    one.add_argument("--reports", action="store_true",
                     help="write a page with pictures for each part, too, below OUT/reports/; report.html has links to them")
    running.add_argument("--dashboard", action="store_true",
                         help="show Dask's dashboard at http://127.0.0.1:8787 while it runs, to all users of this "
                              "machine")
    running.add_argument("--retry", action="store_true",
                         help="repeat the parts that failed in earlier runs")
    running.add_argument("--check-content", action="store_true",
                         help="compare files by content; default: by size and time of change")
    one.add_argument("--json", action="store_true",
                     help="print a summary as one JSON object on stdout")
    if batched in WITH_PATCHES:
        _add_writing(one, with_patches=False)
    _add_strict(one, "all parts are done, but a mesh")
    _add_options(one, TABLES[batched])
    if batched == "curve":
        _add_options(one, options.CURVED_DISPLAY, _FLAT_HEADING)


def _add_options(one, table, headings=None):
    groups = {}
    for option in table:
        title = (headings or {}).get(option.group, option.group)
        group = groups.get(title) or one.add_argument_group(title[0].lower() + title[1:])
        groups[title] = group
        if option.kind is bool:
            # --no-... exists for options that are on by default.
            action = argparse.BooleanOptionalAction if option.default else "store_true"
            group.add_argument(option.flag, action=action, default=option.default,
                               help=option.help)
            _add_alias(group, option, action=action)
            continue
        if option.is_distance:
            groups[options.DISTANCE] = groups.get(options.DISTANCE) \
                or group.add_mutually_exclusive_group()
            group = groups[options.DISTANCE]
        default = f"; default: {option.unset if option.default is None else option.default}" \
            if not option.is_sizes and option.name != options.DISTANCE[0] else ""
        text = f"{option.help} ({option.range_text}{default})"
        # The default of the bound on the distance depends on both of its options: options.check has it.
        group.add_argument(option.flag, type=_type(option), metavar=_metavar(option),
                           default=None if option.is_distance else option.default,
                           help=text.replace("%", "%%"))
        _add_alias(group, option, type=_type(option))


def _add_alias(group, option, **how):
    """The flag of older versions, which help does not show."""
    if option.alias:
        group.add_argument(option.alias_flag, dest=option.name, default=argparse.SUPPRESS,
                           help=argparse.SUPPRESS, **how)


def _type(option):
    if option.can_be_unbounded:
        return _length_or_none
    return str if option.is_sizes or option.is_fields else option.kind


def _length_or_none(text):
    if text == options.NO_BOUND:
        return options.NO_BOUND
    try:
        return float(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"'{text}' is neither a length in mm nor "
                                         f"{options.NO_BOUND}") from error


def _metavar(option):
    if option.can_be_unbounded:
        return "MM|none"
    if option.unit:
        return option.unit.upper()
    if option.is_sizes:
        return "SIZES"
    if option.is_fields:
        return "FILE"
    return "NAME" if option.choices else {int: "N", float: "NUMBER"}[option.kind]


def parse(arguments=None):
    """The arguments as a namespace; ends the program for --help, --version and bad usage."""
    arguments = _with_plain_interfaces(sys.argv[1:] if arguments is None else arguments)
    return parser(_batched_of(arguments)).parse_args(arguments)


def _interfaces(text):
    if text not in ("", "sheet"):
        raise argparse.ArgumentTypeError(f"{text!r} is not possible: give sheet, or nothing")
    return text or True


def _with_plain_interfaces(arguments):
    """`--interfaces` takes the word sheet alone: what else follows is not its value, but the file to read."""
    given, left = [], list(arguments)
    while left:
        word = left.pop(0)
        if word == "--interfaces":
            word = "--interfaces=" + (left.pop(0) if left[:1] == ["sheet"] else "")
        given.append(word)
    return given


def _batched_of(arguments):
    """What `--command` says, where it is good: it decides which options there are."""
    peek = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    peek.add_argument("--command", nargs="?")
    chosen = peek.parse_known_args(arguments)[0].command
    return chosen if chosen in BATCHED else "triangulate"
