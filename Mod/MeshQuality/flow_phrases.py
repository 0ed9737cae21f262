# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said of meshes for flows in documents; a part of the table of phrases. Imports nothing of FreeCAD."""

NO_WALL = "a wall names {value}, but {name} has faces Face1 to {face}: take it out or name another one"
WALL_ELSEWHERE = "a wall names {value}, but {name} does not hold that: select it again in the 3D view"
WALL_LOST = "{face} of the walls may be another face after the edit: choose the walls anew"
ONE_SOLID = "{name} has {count} solids, not one: the fluid must be a single solid; unite several, or make one of the faces; for the flow around them " \
            "give far_field"
NOT_PLANE = "{face} is not plane, but beside walls: layers cannot end in it; make it a wall, too"
TOO_THICK = "{face}: the layers are {length} thick, but the gap there is {length2} at most: give fewer or thinner layers"
NOWHERE = "{face}: nowhere on it do layers of {length} fit, not even a fifth as high, and end in the faces beside it: give fewer or thinner " \
          "layers, a finer surface by local_sizes, or leave it out of walls"
NO_LAYERS = "no valid layers were found: give thinner ones, or a finer surface by max_edge"
OPEN_REGION = "the surface of the solid is not closed, or touches itself along an edge: repair the solid"
COVERED = "layers cover {number} % of the walls, and {number2} % with the height that was asked for"
ON_WALL = "{face} {number} %"
NOT_COVERED = ("layers do not cover all of 1 wall: {list}", "layers do not cover all of {count} walls: {list}")
CELLS = ("1 cell", "{count} cells")
NON_ORTHOGONAL = "non-orthogonality up to {number}°"
FOAM_ORDER = "cases of OpenFOAM hold elements with straight sides, not of order {count}: make the mesh with order=1"
NEEDS_MIDDLES = "some elements are valid only with nodes amid their quadrilaterals, which FreeCAD's FEM meshes do not have: give a finer surface " \
                "by max_edge, or order 1"
NEEDS_NUMBERS = "The first height for a y+ needs a speed and a length above 0"
TEXTS = (NO_WALL, WALL_ELSEWHERE, WALL_LOST, COVERED, ON_WALL, *NOT_COVERED, *CELLS, NON_ORTHOGONAL, NEEDS_NUMBERS,
         ONE_SOLID, NOT_PLANE, TOO_THICK, NOWHERE, NO_LAYERS, OPEN_REGION, FOAM_ORDER, NEEDS_MIDDLES)
