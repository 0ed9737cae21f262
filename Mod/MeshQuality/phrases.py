# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core, the certificates and errors say, in one table, so that panels can say it in the
user's language. Imports nothing of FreeCAD.

Documents, scripts and the command line have the English text with lengths in mm. A phrase of the table
has places for what differs, such as {face}, and is its own key. A Text is an English text that keeps its
phrase and what stands in the places, a Text again or a value: by these it is translated. In the place
{length} stands a number with " mm", for which the window has the user's unit. Angles are in degrees
everywhere; of their numbers, as of all, the window changes the decimal point alone.

A plain text stays as it is, but for its lengths: what documents of older versions hold, and what is said of faults of
single files or shapes.
"""

import json
import re
from collections.abc import Callable
from dataclasses import dataclass

from . import fault_phrases, flow_phrases, label_phrases, report_phrases, solid_phrases
from .error_phrases import ERRORS as CORE_ERRORS
from .note_phrases import NOTES
from .stage_names import STAGES

# The verdict on a mesh.
MET, NOT_MET, NOT_DECIDED = "met", "not met", "not decided"
NOT_MET_TEXT, NOT_DECIDED_TEXT = f"{NOT_MET}: {{text}}", f"{NOT_DECIDED}: {{text}}"

# Parts of certificates; verdict.py puts them together. Pairs are for one and for many. Whole sentences end with a
# full stop; at the head of one the first letter is a capital.
NOT_CLOSED = ("not watertight: 1 open edge.", "not watertight: {count} open edges.")
NONMANIFOLD = ("not manifold: 1 edge has three or more triangles.",
               "not manifold: {count} edges have three or more triangles.")
PINCHED = ("not manifold: the surface only touches itself at 1 vertex.",
           "not manifold: the surface only touches itself at {count} vertices.")
DEGENERATE = ("1 triangle has no area.", "{count} triangles have no area.")
NOT_ORIENTED = ("the triangles on both sides of 1 edge disagree on the outside.",
                "the triangles on both sides of {count} edges disagree on the outside.")
INSIDE_OUT = "the surface is inside out: its triangles face inwards."
CROSSING = ("the surface intersects itself: 1 pair of triangles crosses.",
            "the surface intersects itself: {count} pairs of triangles cross.")
CROSSING_MANY = "the surface intersects itself: more than {count} pairs of triangles cross."
FACES_CROSS = "{face} and {face2} cross."
CROSSES_ITSELF = "{face} crosses itself."
MISSING = ("1 face could not be meshed and was left out: {list}.",
           "{count} faces could not be meshed and were left out: {list}.")
ANGLE = "smallest angle {number}° (requested {number2}°), {phrase}."
MORE_BELOW = ("1 more triangle is below {number}°.", "{count} more triangles are below {number}°.")
MORE_FORCED = ("1 more triangle is below {number}°, at a small corner of the shape too.",
               "{count} more triangles are below {number}°, all of them at small corners of the shape.")
SHAPE_DISTANCE = "max. deviation {length} (requested {length2})."
SHAPE_DISTANCE_AT = "max. deviation {length} (requested {length2}), {phrase}."
SIZE_RATIO = "edges up to {number} times the size field ({number2} promised), at ({phrase}) mm."
LONGEST_EDGE = "longest edge {length} (requested {length2}), {phrase}."
THIN_WALL = "smallest thickness {length} (requested {length2})."
NARROW_GAP = "smallest gap {length} (requested {length2})."
WALL_NOT_DECIDED = "smallest thickness between {length2} and {length3} (requested {length}), as the measured mesh deviates by up to " \
                   "{length4}; a max. deviation of {length5} may decide it, unless the wall is just as thick."
GAP_NOT_DECIDED = "smallest gap between {length2} and {length3} (requested {length}), as the measured mesh deviates by up to {length4}; a " \
                  "max. deviation of {length5} may decide it, unless the gap is just as wide."
LOW_DRAFT = ("less draft than {number}° on 1 face.", "less draft than {number}° on {count} faces.")
UNDERCUTS = ("1 face has undercuts.", "{count} faces have undercuts.")
BEYOND_TOLERANCE = "max. deviation {length} (allowed {length2}): {number} % of the points are beyond."
HAS_VOIDS = ("1 closed void.", "{count} closed voids.")
BODIES_OVERLAP = ("1 pair of bodies overlaps.", "{count} pairs of bodies overlap.")
BODY_OVERLAPS, BODY_INSIDE = "{name} and {name2} overlap.", "{name} lies inside {name2}."
BODY_TWICE = "{name} and {name2} are one body twice."
BODIES_NEAR = ("1 pair of bodies crosses in the mesh only.", "{count} pairs of bodies cross in the mesh only.")
BODY_NEAR = "{name} and {name2} cross: a smaller max. deviation separates them."
LIMIT = "the mesh is incomplete: a limit ended the work early"
FAULTS_LEFT = ("1 fault remains that no repair removed.", "{count} faults remain that no repair removed.")
GUESSED = "{number} % of the surface is a guess, where operands are open."
FOLDED = ("1 of {count2} elements is not proven valid: {list}.",
          "{count} of {count2} elements are not proven valid: {list}.")
NOT_CONFORMING = ("the elements do not fit together: a face has more than two of them, or a corner of one lies amid an edge or "
                  "a face of another.")
OVERLAPPING_BODIES = ("1 pair of bodies lies in one another.", "{count} pairs of bodies lie in one another.")
NOT_ON_SHAPE = "the surface is not on the shape: {text}."
ELEMENTS_TURNED = "neighbouring elements disagree on the side that is outside."
DISTORTED = "max. shape distortion {number} (limit {number2}), {phrase}."
MORE_DISTORTED = ("1 more element is distorted by more than {number}.",
                  "{count} more elements are distorted by more than {number}.")
BEFORE_CURVING = "before curving: {phrase}"
AND_MORE = "{list} and {count} more"
TRIANGLE, TETRAHEDRON = "triangle {count}", "tetrahedron {count} of {solid}"
ON_FACE, ON_EDGE = "{phrase} on {face}", "{phrase} at {edge}"
CERTIFICATE = (
    *NOT_CLOSED, *NONMANIFOLD, *PINCHED, *DEGENERATE, *NOT_ORIENTED, INSIDE_OUT, *CROSSING, CROSSING_MANY,
    FACES_CROSS, CROSSES_ITSELF, *MISSING, ANGLE, *MORE_BELOW, *MORE_FORCED, SHAPE_DISTANCE, SHAPE_DISTANCE_AT,
    LONGEST_EDGE, SIZE_RATIO, THIN_WALL, NARROW_GAP, WALL_NOT_DECIDED, GAP_NOT_DECIDED, *BODIES_OVERLAP, BODY_OVERLAPS, BODY_INSIDE, BODY_TWICE, *BODIES_NEAR, BODY_NEAR, *LOW_DRAFT, *UNDERCUTS, *HAS_VOIDS, BEYOND_TOLERANCE, LIMIT, *FAULTS_LEFT, GUESSED, *FOLDED, NOT_CONFORMING, *OVERLAPPING_BODIES, NOT_ON_SHAPE, ELEMENTS_TURNED, DISTORTED, *MORE_DISTORTED,
    BEFORE_CURVING, AND_MORE, TRIANGLE, TETRAHEDRON,
)

# Parts of the line that the report view gets for a finished object.
FIGURES = (
    ("1 triangle", "{count} triangles"), ("1 element", "{count} elements"),
    "smallest angle {number}°", "max. deviation {length}",
    "max. shape distortion {number}",
    ("1 pair of triangles where bodies overlap", "{count} pairs of triangles where bodies overlap"),
    ("1 pair of elements not proven apart", "{count} pairs of elements not proven apart"),
)
TRIANGLES, ELEMENTS, SMALLEST_ANGLE, MAX_DEVIATION, MAX_DISTORTION, OVERLAPS, NOT_PROVEN_APART = FIGURES
OVERLAPS_HINT = "to make one mesh of bodies that overlap or touch: Join bodies that touch (More options), Mesh Boolean or Wrap"
# What the report view gets, beside that line, for an exported file.
EXPORTED = (
    "requested: smallest angle {number}°, max. deviation {length}",
    "requested before curving: smallest angle {number}°, max. deviation {length}",
    ("1 exempt triangle", "{count} exempt triangles"), "watertight", "not watertight", "elements of order {count}",
    "left out, as they have no faces: {list}", "{face} to {face2} of all that is exported",
)
REQUESTED, REQUESTED_BEFORE, EXEMPT_TRIANGLES, WATERTIGHT, NOT_WATERTIGHT, OF_ORDER, LEFT_OUT_WITHOUT_FACES, FACES_OF_BODY = EXPORTED
NOTHING_LEFT = "nothing is left: the solid is nowhere that deep"
HOLLOW_SEALED = "a closed void is sealed inside, from which resin, powder or air cannot leave; it saves {volume}, {number} % of the " \
                "volume"
STAYS_WHOLE = "the solid stays whole: it is nowhere thicker than two walls"
NEVER_INSIDE = "never inside the part: every point of the mesh is {length} to {length2} outside of it"
NEVER_OUTSIDE = "never outside the part: every point of the mesh is {length} to {length2} inside of it"
SIMPLIFIED = "{count} of {count2} triangles are left; no point of either surface is farther than {length} from the other one"
FITTED = "aligned: root mean square {length} of {count} points"
SMALLEST_WALL = "smallest thickness {length}"
SMALLEST_GAP = "smallest gap {length}"
NO_WALLS = "no two sides face each other: there is no smallest thickness or gap"
ALL_MET = "all requested limits are met."
LEFT_OUT = ("1 hidden object of {name} is no part of it: {list}.", "{count} hidden objects of {name} are no part of it: {list}.")
TARGET_NOT_MET = "target not met: {text}"
TARGET_NOT_DECIDED = "target not decided: {text}"

# Why a triangle keeps a smaller angle, by the causes of src/mesh/quality/exempt_reason.h in their order: the build
# compiles these into the core (tools/core_phrases).
EXEMPT = {
    "narrow_corner": "the shape itself has a corner of {number}° between {edge} and {edge2} at {vertex}",
    "apex": "the surface comes to a point with too little angle around it at {vertex}",
    "narrow_cluster": "edges at the narrow corner of the shape would become ever shorter at {vertex}",
    "infeasible_corner": "edges of the shape that meet at {number}° leave no room for larger angles at {vertex}",
    "tolerance_corner": "{name} and {name2} count as one, as the shape's tolerances do not tell them apart ({length}): that makes a corner of {number}° between {edge} and {edge2} at {vertex}",
    "sharp_edges": "its smallest angle lies between two sharp edges that must stay",
    "identified_corner": "{name} and {name2} count as one, as they are no farther apart than {length}: that makes a corner of {number}°, which the shape does not have and a smaller max. deviation avoids, between {edge} and {edge2} at {vertex}",
    "resolution": "points cannot be placed any closer in single precision",
    "face_floor_raised": "too many triangles there have no room for a further point, so the face is refined no further",
    "min_edge": "a further point would make an edge shorter than min_edge",
    "crowded": "a further point would lie closer to its neighbours than they do to each other",
    "fold": "a further point would fold the mesh",
    "no_surface_point": "no point of the surface was found there",
    "no_improving_change": "no change of the triangles around it makes the angle larger within the limits",
    "budget": "the triangle limit max_triangles was reached",
    "no_change_within_tolerance": "no change within the tolerance makes it better",
}
FORCED = ("narrow_corner", "apex", "narrow_cluster", "infeasible_corner", "tolerance_corner", "sharp_edges")  # reasons that are the shape itself
CREASE, CREASE_END = "a crease of {name}", "the end of a crease on {name}"
NOT_REACHABLE = "target angle not reachable: {phrase}."
_EXEMPT_TRIANGLE = "triangle {count}: {phrase}"

# A mesh in a container that it is made of.
IN_ITS_SOURCE = "it is made of {name} and cannot lie in that, as each would wait for the other: put it beside that, where " \
                "it follows, too"
TAKEN_OUT = "it is made of {name} and cannot lie in that, as each would wait for the other: it was taken out again, and " \
            "follows from outside, too"
# A FEM mesh in an analysis that has one.
MORE_MESHES = "the analysis {name} has another mesh, {name2}: FreeCAD solves on one mesh only; take the others out"
# A FEM mesh that is not seen where its part is.
FEM_BESIDE = "the mesh stands beside its part, which lies in {name}, as FreeCAD's FEM workbench looks for faces without the containers " \
             "around them: it solves rightly; to see mesh and results on the part, put the analysis, or the mesh without one, into {name}"
FEM_BESIDE_ANY = "the mesh stands beside its part, as FreeCAD's FEM workbench looks for faces without the containers around them ({name}): it " \
                 "solves rightly; to see mesh and results on the part, take the part out of these"
FEM_IN_CONTAINER = "the mesh stands beside its part, as FreeCAD's FEM workbench looks for faces where the document has them, whatever the " \
                   "containers around the mesh: it solves rightly; to see mesh and results on the part, take the mesh and its analysis out of {name}"
TAKES_PLACE = "in the analysis {name} it takes the place of {name2}, as FreeCAD solves on one mesh only; what it replaces stays in " \
              "the document"
# What curing a mesh that another program made has found and changed.
GIVEN_INVALID = ("given mesh: 1 of {count2} elements is not proven valid", "given mesh: {count} of {count2} elements are not proven valid")
CURED_INVALID = ("now 1 of {count2}", "now {count} of {count2}")
GIVEN_REPLACED = ("1 element replaced", "{count} elements replaced")
GIVEN_MOVED = ("1 vertex moved", "{count} vertices moved")
GROUP_LOST = ("the group {name} has lost 1 element, which was replaced: add those that are there now to it",
              "the group {name} has lost {count} elements, which were replaced: add those that are there now to it")
CURING = (TAKES_PLACE, *GIVEN_INVALID, *CURED_INVALID, *GIVEN_REPLACED, *GIVEN_MOVED, *GROUP_LOST)

# Errors that a panel can meet.
BOUND_BY_EXPRESSION = (
    "{option} cannot be changed: the property {name} of {name2} is set by the expression {value}; clear that first, by "
    "{name3} or in the property editor")
NOT_A_WHOLE_NUMBER = "{option} = {value} is not allowed: it must be a whole number, {range}"
NOT_A_NUMBER = "{option} = {value} is not allowed: it must be a number, {range}"
LENGTH_NOT_ALLOWED = "{option} = {length} is not allowed: it must be {range}"
NOT_ALLOWED = "{option} = {value} is not allowed: it must be {range}"
TWO_BOUNDS = "chord_height = {length} and chord_height_relative = {number} exclude each other: give one of them"
NO_BOUND_AND_BOUND = "chord_height = 'none' and chord_height_relative = {number} exclude each other: give one of them"
MIN_ABOVE_MAX = "min_edge = {length} is longer than max_edge = {length2}"
NO_SOURCE = "Source is empty: choose an object with a shape"
NO_SOURCES = "Sources is empty: choose objects with a mesh or a shape"
GIVEN_DELETED = "Given is empty: the FEM mesh was deleted; choose another one, or delete this mesh"
NOT_MEASURED = "the surface of the mesh is not measured: it is not of triangles of one order"
NO_PART = "{name} does not say of which part it is a mesh: give part=, or select the part beside it"
NOT_GIVEN = "{option} is 0: give a length"
OPENINGS_OF_MESH = "openings are faces of a shape, and {name} has a mesh: hollow it without openings, and cut them by a Boolean"
NO_OPENING = "an opening names {value}, but {name} has faces Face1 to {face}: take it out or name another one"
OPENING_ELSEWHERE = "an opening names {value}, but {name} does not hold that: select it again in the 3D view"
OPENING_LOST = "{face} of the openings may be another face after the edit: choose the openings anew"
SHAPES_AND_MESHES = "{name} holds shapes and meshes: unite them by a Boolean first"
NO_MESH = "Source is not a mesh: choose one object with a mesh"
FEW_SOURCES = ("Sources has 1 object: choose two or more with a mesh or a shape",
               "Sources has {count} objects: choose two or more with a mesh or a shape")
IS_NULL_RECOMPUTE = "{name} is null: it has no geometry; recompute the document, if it is new"
IS_NULL_HIDDEN = "{name} is null: it has no geometry; what is hidden in a container does not count: show it"
IS_NULL = "{name} is null: it has no geometry"
NO_FACES = "{name} has no faces (its type is {name2}): give a solid, a shell or faces"
NO_TRIANGLES = "{name} has no triangles"
NO_POINTS = "{name} has no points"
POINTS_NO_NUMBERS = "{name} has points whose coordinates are no numbers: leave these out"
DEVIATION_OF_TWO = "Sources is incomplete: choose a scan, and the part that it is measured against"
POINTS_NEEDED = "{name} is no mesh and no point cloud: choose a scan, and the part that it is measured against"
NOT_ALIGNED = "{name} cannot be aligned with {name2}: after {count} steps its points are {length} off (root mean square). Move it " \
              "near to where it belongs and align it from there, give pairs of points, or check its unit"
NO_SUCH_ELEMENT = "local_sizes names {value}, but {name} does not hold that: select it again in the 3D view"
SOURCE_DELETED = "Source is empty: the source was deleted; choose another one, or delete this mesh"
SOURCE_GONE = "The source was deleted. Close this panel."
DOCUMENT_CLOSED = "The document was closed. Close this panel."
ERRORS = (
    IN_ITS_SOURCE, TAKEN_OUT, MORE_MESHES, FEM_BESIDE, FEM_BESIDE_ANY, FEM_IN_CONTAINER,
    BOUND_BY_EXPRESSION, NOT_A_WHOLE_NUMBER, NOT_A_NUMBER, LENGTH_NOT_ALLOWED, NOT_ALLOWED,
    TWO_BOUNDS, NO_BOUND_AND_BOUND, MIN_ABOVE_MAX, NO_SOURCE, NO_SOURCES, NOT_GIVEN, OPENINGS_OF_MESH, NO_OPENING, OPENING_ELSEWHERE, OPENING_LOST,
    *fault_phrases.TEXTS, *flow_phrases.TEXTS, *label_phrases.TEXTS, *report_phrases.TEXTS, *solid_phrases.TEXTS, SHAPES_AND_MESHES, NO_MESH, GIVEN_DELETED, NO_PART, NOT_MEASURED, *FEW_SOURCES, IS_NULL_RECOMPUTE, IS_NULL_HIDDEN,
    IS_NULL, NO_FACES, NO_TRIANGLES, NO_POINTS, POINTS_NO_NUMBERS, DEVIATION_OF_TWO, POINTS_NEEDED, NOT_ALIGNED, NO_SUCH_ELEMENT, SOURCE_DELETED, SOURCE_GONE, DOCUMENT_CLOSED,
)
# Errors of patches, files and cases for meshers of flows.
PATCH_NAME = "{value} is not possible as the name of a patch: give a text that is not empty, without blanks at its ends"
PATCH_REST_NAME = "{value} is not possible as patch_rest: give a text that is not empty, without blanks at its ends"
PATCH_NO_FACE = "patch {name} names {value}, which is no face: give names such as Face1"
PATCH_FACE_TWICE = "{face} is twice in patch {name}: a face belongs to one patch; name it once"
PATCH_FACE_IN_TWO = "{face} is in patch {name} and in patch {name2}: a face belongs to one patch; name it once"
PATCH_ELSEWHERE = "a patch names {value}, but {name} does not hold that: name a face as local_sizes does"
PATCH_BEYOND = "patch {name} names {face}, but {name2} has faces Face1 to {face2}: take it out or name another one"
PATCH_LIKE_FACE = "patch {name} has the name of a face that is in no patch: give it another name, or name the patch of all other " \
                  "faces by patch_rest"
PATCH_LIKE_GROUP = "patch {name} has the name of a group of the FEM mesh: give it another name"
PATCH_LIKE_COLOUR = "{value} is not possible as the name of a patch: it ends as a colour does; choose another"
PATCH_LINE = "the patch {value} is not possible: write its name, a colon and its faces, such as \"inlet: Face1, Face4\""
PATCHES_ALIKE = "there are two patches called {name}: put their faces into one"
PATCH_LOST = "{face} of patch {name} may be another face after the edit: choose the faces of the patch anew"
PATCHES_NOT_FOLLOWED = "the patches are not followed: {text}"
NO_PATCHES = {
    "labels": "{name} holds no parts: choose faces, or name patches by an analysis",
    "colours": "{name} has faces of one colour alone: colour them in the 3D view, or choose faces",
    "analysis": "{name} has no faces to which an analysis refers: add constraints, or choose faces",
}
FILE_PATCH_TOO_LONG = "{value} files cannot hold a patch called {name}: names there have at most {count} characters; give it a " \
                      "shorter one"
FOAM_PATCH = "OpenFOAM cannot hold a patch called {name}: give it letters without accents, digits, _ - + and . only, a letter first"
CASE_OPEN = "the mesh has {count} open edges: meshers of flows need a closed surface; close the part, or mesh all of its faces"
CASE_SOLIDS = "the mesh has {count} solids, and one space is meshed at a time: write a case of mesh.of_solid(i) for each, or unite " \
              "them first"
CASE_OVERLAP = "{name} and {name2} overlap or cross: unite them first, or mesh them with overlap = allow"
CASE_CELL = "cell = {value} is not possible: give a length in mm from {length} on that is less than the size of the part, {length2}"
CASE_NO_INSIDE = "no point inside of the mesh was found: it encloses no space"
CASE_NO_UNDO = "a CFD surface of {name} would end FreeCAD when it is undone, unless MeshQuality was built for this FreeCAD: write the mesh " \
               "with its patches as STL, or an OpenFOAM case"
CASE_NO_FOLDER = "the case has no folder: give the name of one"
FILE_NO_NAME = "the file has no name: give one that ends in one of {value}"
FILE_IS_FOLDER = "{value} is a folder and cannot be written: give the name of a file that ends in one of {value2}"
FILE_ENDING = "{value}: a mesh is written into files with a name that ends in one of {value2}"
FILE_ENDING_CURVED = "{value}: curved elements of order {count} are written into files with a name that ends in one of {value2}"
FILE_NO_FOLDER = "{value}: there is no folder {value2}"
FILE_NOT_WRITABLE = "{value} cannot be written"
NOTHING_TO_EXPORT = "nothing to export: select an object with faces or a mesh"
FEM_MESH_ALONE = "{name} is a FEM mesh, which goes into a file of its own: select it alone"
NO_TRIANGLES_YET = "{name} has no triangles: compute it first"
FILE_ERRORS = (
    PATCH_NAME, PATCH_REST_NAME, PATCH_NO_FACE, PATCH_FACE_TWICE, PATCH_FACE_IN_TWO, PATCH_ELSEWHERE, PATCH_BEYOND, PATCH_LIKE_FACE,
    PATCH_LIKE_GROUP, PATCH_LIKE_COLOUR, PATCH_LINE, PATCHES_ALIKE, PATCH_LOST, PATCHES_NOT_FOLLOWED, *NO_PATCHES.values(),
    FILE_PATCH_TOO_LONG, FOAM_PATCH, CASE_OPEN, CASE_OVERLAP, CASE_SOLIDS, CASE_CELL, CASE_NO_INSIDE, CASE_NO_UNDO, CASE_NO_FOLDER, FILE_NO_NAME,
    FILE_IS_FOLDER, FILE_ENDING, FILE_ENDING_CURVED, FILE_NO_FOLDER, FILE_NOT_WRITABLE, NO_TRIANGLES_YET,
    NOTHING_TO_EXPORT, FEM_MESH_ALONE,
)
ANY_LENGTH = "a length"
FIELD_NAMES = "names of Size regions of the document, or paths of files"
FACE_NAMES = "names of faces, such as Face3, Face7"
LOCAL_SIZES = "lengths in mm greater than 0 by sub-elements, such as Face3=0.5, Edge7=0.2"
FROM_TO, AT_LEAST, LONGER_THAN, ONE_OF = "at least {number} and at most {number2}", "at least {number}", "greater than {length}", "one of {list}"
RANGES = (
    "greater than {number} and at most {number2} degrees",
    "greater than {number} and at most {number2}",
    FROM_TO,
    "greater than {length}, or 'none'",
    LONGER_THAN,
    "greater than {number}",
    AT_LEAST,
    ONE_OF,
    ANY_LENGTH,
    LOCAL_SIZES,
    FACE_NAMES, FIELD_NAMES,
)

# Phrases that may end other phrases, hence last in the table.
ENDINGS = (ON_EDGE, ON_FACE)

# Parts of a stage that work cannot interrupt, of the core too.
WAITS_FOR_KERNEL = "waits for OpenCASCADE: {stage}"
WAITS_FOR_ENGINE = "waits for the shape engine, used by {name}"
OTHER_WORK = "other work"
CHECKING, READING, MEASURING_VOLUME = "checking {name}", "reading {name}", "measuring the volume of {name}"
ADDING = "waits for FreeCAD: adding the mesh to the document"
CORE_WAITS = {
    "waits_for_kernel": WAITS_FOR_KERNEL, "waits_for_engine": WAITS_FOR_ENGINE, "other_work": OTHER_WORK,
    "checking": CHECKING, "reading": READING, "measuring_volume": MEASURING_VOLUME,
}
_WAITS = (*CORE_WAITS.values(), ADDING)
# All that the build compiles into the core.
CORE = {
    **CORE_ERRORS, **CORE_WAITS, **NOTES, "repairs": fault_phrases.DONE, "one_hole": fault_phrases.ONE_HOLE,
    "and_more": AND_MORE, "on_edge": ON_EDGE, "on_face": ON_FACE, "crease": CREASE, "crease_end": CREASE_END,
    "not_allowed": NOT_ALLOWED, "length_not_allowed": LENGTH_NOT_ALLOWED, "not_given": NOT_GIVEN, "two_bounds": TWO_BOUNDS,
    "min_above_max": MIN_ABOVE_MAX, "openings_of_mesh": OPENINGS_OF_MESH, "no_triangles": NO_TRIANGLES,
    "from_to": FROM_TO, "at_least": AT_LEAST, "longer_than": LONGER_THAN, "one_of": ONE_OF,
}
_KERNEL_STILL_WORKS, _STILL_WORKS = "OpenCASCADE still finishes: {stage}", "still finishes: {stage}"

# What is said in a panel where the English text is made for scripts.
_SHOWN = {
    NOT_A_WHOLE_NUMBER: "{option}: {value} is not possible, it must be a whole number, {range}",
    NOT_A_NUMBER: "{option}: {value} is not possible, it must be a number, {range}",
    LENGTH_NOT_ALLOWED: "{option}: {length} is not possible, it must be {range}",
    NOT_ALLOWED: "{option}: {value} is not possible, it must be {range}",
    TWO_BOUNDS: "The max. deviation is given twice, as {length} and as {number} of the size: give one of them",
    NO_BOUND_AND_BOUND: "The max. deviation is given twice, as unlimited and as {number} of the size: give one of them",
    NOT_GIVEN: "{option}: give a length that is not 0",
    MIN_ABOVE_MAX: "The shortest edge of {length} is longer than the longest edge of {length2}",
    "greater than {length}, or 'none'": "greater than {length}, or without a limit",
    CASE_SOLIDS: "The mesh has {count} solids, and one space is meshed at a time: unite them first, or take one alone",
    CASE_CELL: "The length of the cells is not possible: it must be at least {length} and less than the size of the part, {length2}",
    PATCH_REST_NAME: "{value} is not possible as the name of the other faces: give one without blanks at its ends",
    PATCH_ELSEWHERE: "A patch names {value}, but {name} does not hold that: select it again in the 3D view",
    PATCH_LIKE_FACE: "Patch {name} has the name of a face that is in no patch: give it another name, or name all other faces",
    LOCAL_SIZES: "lengths greater than 0 by sub-elements, such as Face3=0.5 mm, Edge7=0.2 mm",
    EXEMPT["min_edge"]: "a further point would make an edge shorter than the shortest that is allowed",
    EXEMPT["budget"]: "the triangle limit was reached",
    **{CORE_ERRORS[name]: shown for name, shown in {
        "no_solids": "The shape has no solids to fill with tetrahedra: switch that off to curve its faces",
        "not_triangulated":
            "Faces cannot be meshed: {value}. Repair the shape (Part - Check geometry), or choose to skip "
            "faces that fail under More options",
        "fine_chord_height":
            "A max. deviation of {length} is below the single precision of meshes in FreeCAD, here {length2}. Choose a "
            "larger value",
        "fine_tolerance":
            "A max. deviation of {length} is below the single precision of meshes in FreeCAD, here {length2}. Choose a larger "
            "value",
        "above_distance": "The max. deviation is {length}: at most the distance of {length2} is possible; give a smaller one",
        "half_of_gap": "The max. deviation is {length}: at most half of the gap of {length2} is possible; give a smaller one, or a larger gap",
        "fine_deviation":
            "A display accuracy of {length} is below the single precision of meshes in FreeCAD, here {length2}. Choose a "
            "larger value",
        "many_triangles":
            "A display accuracy of {length} takes more than {count} triangles. Choose a larger value",
        "wrap_memory": "A wrap with a max. deviation of {length} would take more than 2 GB of memory. Choose a larger one",
        "wrap_across": "The largest side is more than {count} times the max. deviation of {length}. Choose a larger one",
        "many_rays":
            "A max. deviation of {length} is not possible with sampling, which reaches {length2} at best. Choose a larger "
            "one or exact intersection as the method",
        "full_by_sampling":
            "Only sampling can reconstruct everything. Choose sampling as the method, or turn \"Reconstruct everything\" off",
        "no_such_entity":
            "A local size is given for {name}, but the shape has only {count} of these",
        "volume_order":
            "Tetrahedra of order {count} are not possible: choose an order from 1 to {count2}",
        "not_filled":
            "The surface could not be filled with tetrahedra: it intersects itself, or walls are too thin for "
            "its triangles. Choose a smaller max. deviation ({value})",
    }.items()},
}

def flat(phrases):
    """The phrases, of which some are pairs, or tuples of these, one after the other."""
    return [phrase for one in phrases for phrase in ((one,) if isinstance(one, str) else flat(one))]


_NUMBER = r"[-+]?(?:\d[\d.]*(?:e[-+]?\d+)?|inf|nan)"
_LINE = (*TRIANGLES, *ELEMENTS, *FIGURES[2:-2], *OVERLAPS, *NOT_PROVEN_APART, OVERLAPS_HINT, NOTHING_LEFT, HOLLOW_SEALED, STAYS_WHOLE, FITTED, SIMPLIFIED, NEVER_INSIDE, NEVER_OUTSIDE, SMALLEST_WALL, SMALLEST_GAP, NO_WALLS, ALL_MET, TARGET_NOT_MET, TARGET_NOT_DECIDED, *LEFT_OUT, *CURING, *flat(EXPORTED))
_PHRASES = (*CERTIFICATE, NOT_REACHABLE, *EXEMPT.values(), CREASE, CREASE_END, *_LINE, *ERRORS, *FILE_ERRORS, *flat((*CORE_ERRORS.values(), *NOTES.values())), *RANGES, *ENDINGS)
_TABLE = frozenset((*_PHRASES, *_WAITS))
_LENGTHS = re.compile(rf"(?<![\w.]){_NUMBER} mm(?!\w)")


@dataclass(frozen=True)
class Wording:
    """How the texts of this module are said to somebody; by default as they are.

    translate  translate(text of `texts`) -> text in the user's language
    number     number(text such as "4.57" or "1,203") -> text as the user writes numbers
    lengths    lengths(texts such as ["0.0171 mm", "0.01 mm"]) -> as many texts in the user's unit, different
               ones where the lengths differ
    title      title(name of an option) -> its name in panels
    volume     volume(text such as "511.2 mm³") -> text in the user's unit
    """

    translate: Callable = str
    number: Callable = str
    lengths: Callable = list
    title: Callable = str
    volume: Callable = str


class Text(str):
    """An English text that keeps what it is made of.

    phrase  of the table, or one that only joins others
    places  {name: what stands in that place of the phrase: text, a Text, or a list of those}
    upper   whether the first letter is made a capital, as at the head of a sentence
    """

    def __new__(cls, phrase, /, **places):
        return cls._of(phrase, places)

    @classmethod
    def _of(cls, phrase, places, upper=False):
        text = phrase.format(**{name: value if isinstance(value, str) else ", ".join(value)
                                for name, value in places.items()})
        self = super().__new__(cls, text[:1].upper() + text[1:] if upper else text)
        self.phrase, self.places, self.upper = phrase, places, upper
        return self

    def __reduce__(self):
        return Text._of, (self.phrase, self.places, self.upper)


def counted(pair, count, **places):
    """The first of a pair of phrases for a count of 1, else the second, with the count."""
    return Text(pair[count != 1], count=f"{count:,}", **places)


def counted_sentence(pair, count, /, **places):
    """counted() as a sentence."""
    return upper_first(counted(pair, count, **places))


def counted_list(pair, names, /, **places):
    """counted_sentence() with the names of the first items."""
    return counted_sentence(pair, len(names), list=first_of(names), **places)


def first_of(names, most=3):
    """The first names, and the number of the others."""
    listed = list(names[:most])
    return Text(AND_MORE, list=listed, count=str(len(names) - most)) if len(names) > most else listed


def joined(*parts):
    """The texts of sentences in one, with blanks between them."""
    parts = [part for text in parts for part in _sentences_of(text)]
    if len(parts) == 1:
        return parts[0]
    names = [f"phrase{i}" for i in range(len(parts))]
    return Text(" ".join(f"{{{name}}}" for name in names), **dict(zip(names, parts)))


def _sentences_of(text):
    is_joined = isinstance(text, Text) and text.phrase.startswith("{phrase0} ")
    return text.places.values() if is_joined else (text,)


def to_data(text):
    """A Text as plain values for JSON; the inverse of from_data."""
    if isinstance(text, Text):
        return {"phrase": text.phrase, "places": {name: to_data(value) for name, value in text.places.items()},
                "upper": text.upper}
    return text if isinstance(text, str) else [to_data(part) for part in text]


def from_data(data):
    """The Text of plain values, or of what the core gives for one."""
    if isinstance(data, dict):
        places = {name: from_data(value) for name, value in data["places"].items()}
        return Text._of(data["phrase"], places, data.get("upper", False))
    return data if isinstance(data, str) else [from_data(part) for part in data]


def stored(text, data):
    """A text that a document holds, as the Text that the JSON beside it describes; as it is where it was stored
    without, or changed without that.
    """
    try:
        found = from_data(json.loads(data))
    except (ValueError, KeyError, TypeError, AttributeError, IndexError):
        return text
    return found if found == text else text


def text_of(value):
    """The message of an error, or the text itself; a Text stays one."""
    said = value.args[0] if isinstance(value, Exception) and value.args else value
    return said if isinstance(said, Text) else str(value)


def renamed(text, before, name):
    """The text with the name `before` replaced by `name` throughout."""
    if isinstance(text, Text):
        return Text._of(text.phrase, {key: renamed(value, before, name) for key, value in text.places.items()}, text.upper)
    if not isinstance(text, str):
        return [renamed(part, before, name) for part in text]
    return re.sub(rf"{re.escape(before)}\b", lambda _: name, text)


def exempt_triangle(triangle, reason):
    """The sentence of documents on an exempt triangle."""
    return Text(_EXEMPT_TRIANGLE, count=str(triangle), phrase=reason)


def texts():
    """All texts that are to be translated."""
    return sorted({*(_SHOWN.get(phrase, phrase) for phrase in _PHRASES), *STAGES.values(), *_WAITS,
                   _KERNEL_STILL_WORKS, _STILL_WORKS})


def translated(text, wording):
    """The text in the words of a Wording; of a plain one only its lengths."""
    return _said(text, wording) if isinstance(text, Text) else _with_lengths(text, wording)


def _said(text, wording):
    """A Text in the words of a Wording."""
    places = {name: _place(name, value, wording) for name, value in text.places.items()}
    lengths = [name for name in places if _kind(name) == "length"]
    places.update(zip(lengths, wording.lengths([places[name] for name in lengths])))
    shown = _SHOWN.get(text.phrase, text.phrase)
    found = (wording.translate(shown) if text.phrase in _TABLE else shown).format(**places)
    return found[:1].upper() + found[1:] if text.upper else found


def _with_lengths(text, wording):
    shown = iter(wording.lengths(_LENGTHS.findall(text)))
    return _LENGTHS.sub(lambda _: next(shown), text)


def sentence(phrase):
    """A Text that is a phrase of the table without a full stop, as a sentence."""
    return upper_first(Text("{phrase}.", phrase=phrase))


def exempt_sentence(reason, forced):
    """A Text, a sentence on why a triangle is exempt; `forced`: whether the shape itself is the reason."""
    return upper_first(Text(NOT_REACHABLE, phrase=reason)) if forced else sentence(reason)


def upper_first(text):
    """The Text with a capital at its head."""
    return Text._of(text.phrase, text.places, True)


def lower_first(text):
    """A text, also of several sentences, to stand after a colon."""
    if not isinstance(text, Text):
        return text[:1].lower() + text[1:]
    first, *others = _sentences_of(text)
    return joined(Text._of(first.phrase, first.places), *others)


def is_wait(name):
    """Whether the stage is one that cannot be interrupted."""
    return isinstance(name, Text) and name.phrase in (WAITS_FOR_KERNEL, WAITS_FOR_ENGINE, ADDING)


def stage(name, wording):
    """Words for a stage."""
    return _said(name, wording) if isinstance(name, Text) else wording.translate(STAGES[name]) if name in STAGES else name


def rest(name, wording):
    """Words for what goes on after cancelling in the middle of a stage."""
    if is_wait(name) and name.phrase == WAITS_FOR_KERNEL:
        return wording.translate(_KERNEL_STILL_WORKS).format(stage=stage(name.places["stage"], wording))
    return wording.translate(_STILL_WORKS).format(stage=stage(name or "start", wording))


def _place(name, value, wording):
    """The text in a place of a phrase; lengths stay, as those of a whole phrase are written together."""
    kind = _kind(name)
    if kind in ("count", "number"):
        return wording.number(value)
    if kind == "volume":
        return wording.volume(value)
    if kind == "option":
        return wording.title(value)
    if kind == "list":
        parts = value.split(", ") if type(value) is str else [value] if isinstance(value, Text) else value
        return ", ".join(translated(part, wording) for part in parts)
    if kind == "stage":
        return stage(value, wording)
    return translated(value, wording) if kind in ("phrase", "range", "text") or isinstance(value, Text) else value


def _kind(name):
    return name.rstrip("0123456789")
