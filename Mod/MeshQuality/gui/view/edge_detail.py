# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges that are drawn only where they are told apart: those of a mesh that is small on the screen would blacken it.

What is drawn follows the camera, as Coin decides at each drawing by the square pixels of the box around the mesh.
"""

from pivy import coin

PIXELS = 5.0  # square pixels of the box for each edge: edges are 5 pixels long where it is filled to 70 %


def thinned(lines, edges):
    """A node that draws `lines`, a separator with its own coordinates, where these many edges are told apart."""
    detail, contents, kit = coin.SoLevelOfDetail(), coin.SoSeparator(), coin.SoWrapperKit()
    detail.addChild(lines)
    detail.addChild(coin.SoInfo())  # nothing
    contents.addChild(detail)
    # FreeCAD's actions for selections have no state by which the detail is chosen, and a Coin with assertions ends FreeCAD
    # for that. They go into groups, but not into kits.
    kit.setPart("contents", contents)
    set_count(kit, edges)
    return kit


def set_count(kit, edges):
    """Sets the number of edges."""
    kit.getPart("contents", False).getChild(0).screenArea = PIXELS * edges


def thin_out(root, edges):
    """Thins out edges in FreeCAD's display modes that draw faces and lines, below the root node of a view."""
    for group in _modes(root):
        for i in range(group.getNumChildren()):
            child = group.getChild(i)
            if child.isOfType(coin.SoWrapperKit.getClassTypeId()):
                set_count(child, edges)
            elif _draws_lines(child) and _draws_faces(group):
                group.replaceChild(i, thinned(child, edges))


def _modes(root):
    """The groups among which FreeCAD's switch chooses."""
    switches = (child for child in _children(root) if child.isOfType(coin.SoSwitch.getClassTypeId()))
    return [mode for switch in switches for mode in _children(switch) if mode.isOfType(coin.SoGroup.getClassTypeId())]


def _children(node):
    return [node.getChild(i) for i in range(node.getNumChildren())]


def _draws_lines(node):
    return node.isOfType(coin.SoSeparator.getClassTypeId()) and any(
        child.isOfType(coin.SoDrawStyle.getClassTypeId()) and child.style.getValue() == coin.SoDrawStyle.LINES
        for child in _children(node))


def _draws_faces(group):
    search = coin.SoSearchAction()
    search.setType(coin.SoShapeHints.getClassTypeId())  # shape hints are for faces only
    search.setSearchingAll(True)
    search.apply(group)
    return search.getPath() is not None
