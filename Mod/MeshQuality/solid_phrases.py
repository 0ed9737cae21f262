# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said of solids that are made of meshes; a part of the table of phrases. Imports nothing of FreeCAD."""

# Why there are no exact faces.
NO_CAD = "the mesh does not know the CAD it was made of"
NOT_INTERSECTED = "OpenCASCADE cannot intersect the faces ({text})"
NONE_ON_MESH = "no face of the CAD lies on the mesh"
NOT_CLOSED = "the faces of the CAD on the mesh do not close"
NOT_VALID = "the solid is not valid by OpenCASCADE's check"
OTHER_VOLUME = "the volume of the solid, {volume}, is not that of the mesh, {volume2}"
TOO_FAR = "the solid is {length} from the mesh, and {length2} are allowed"
# What ends the work.
REPAIR_FIRST = "the mesh is not closed, manifold and oriented: repair it first"
TOO_MANY = "{phrase}, and {count} triangles are too many facets: simplify the mesh to at most {count2}"
NO_FACETS = "{phrase}, and facets make no solid: {phrase2}"
NO_EXACT = "no solid with exact surfaces: {phrase}"
NO_MESH_OBJECT = "{name} holds no mesh: give an object with a mesh"
OUTDATED = "{name} is out of date: update it first"
# What was made.
EXACT = ("The solid has 1 face on an exact surface.", "The solid has {count} faces on exact surfaces.")
FACETS = ("The solid has 1 planar facet: {phrase}.", "The solid has {count} planar facets: {phrase}.")
DISTANCES = "Mesh and solid are within {length} of each other, measured at points; {length2} are allowed. Its volume is {volume}, that of the mesh {volume2}."
TEXTS = (NO_CAD, NOT_INTERSECTED, NONE_ON_MESH, NOT_CLOSED, NOT_VALID, OTHER_VOLUME, TOO_FAR, REPAIR_FIRST, TOO_MANY, NO_FACETS, NO_EXACT,
         NO_MESH_OBJECT, OUTDATED, *EXACT, *FACETS, DISTANCES)
