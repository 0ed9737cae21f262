# SPDX-License-Identifier: LGPL-2.1-or-later
"""Icons of the tree with a badge in their corner."""

import os
from functools import lru_cache

from PySide import QtCore, QtGui, QtSvg

from ...compat import HOME
from ...core.certify import verdict
from ...features import mesh_object

ICONS = os.path.join(HOME, "Resources", "icons")
MISSED, UNDECIDED, OUTDATED, FAILED = (f"MeshQuality_{name}" for name in ("missed", "undecided", "outdated", "failed"))
_SIDE = 64  # pixels


def path_of(name):
    """The file of an icon."""
    return os.path.join(ICONS, f"{name}.svg")


def badge_of(obj):
    """The badge of a mesh object; None where it is up to date and meets all limits."""
    status = getattr(obj, "Status", "")
    if status == mesh_object.SOURCE_DELETED or status.startswith(mesh_object.FAILED):
        return FAILED
    if verdict.is_missed(getattr(obj, "Certificate", "")):
        return MISSED
    if verdict.is_open(getattr(obj, "Certificate", "")):
        return UNDECIDED
    return OUTDATED if status in (mesh_object.OUT_OF_DATE, mesh_object.COMPUTING) else None


@lru_cache(maxsize=None)
def with_badge(name, badge):
    """The icon with the badge over it, as the text of an XPM picture, which views may return."""
    picture = QtGui.QImage(_SIDE, _SIDE, QtGui.QImage.Format_ARGB32)
    picture.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(picture)
    for layer in (name, badge):
        QtSvg.QSvgRenderer(path_of(layer)).render(painter)
    painter.end()
    buffer = QtCore.QBuffer()
    buffer.open(QtCore.QIODevice.WriteOnly)
    picture.save(buffer, "XPM")
    return bytes(buffer.data()).decode("ascii")
