# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where and how the legend is drawn: at the right side of the 3D view, upon what is in the scene."""

import ctypes
import os

from pivy import coin

from .legend import BOTTOM_RIGHT, TOP_RIGHT

_MARGIN = 10  # pixels between the picture and the edge of the view
_CLIP_PLANE, _CLIP_PLANES = 0x3000, 6  # GL_CLIP_PLANE0 of OpenGL, and as many as every OpenGL has


class LegendNode:
    """A picture in a corner of the view that other things leave free. It is drawn last and is neither picked nor cut by
    clipping planes; "fit all" ignores it.

    node  for the scene
    """

    def __init__(self):
        self.size, self._left_free, self._reach = (0, 0), TOP_RIGHT, 0
        self._seen = None  # the size of the view for which it was placed last
        self._place, self._image = coin.SoTranslation(), coin.SoImage()
        self._image.vertAlignment, self._image.horAlignment = coin.SoImage.BOTTOM, coin.SoImage.LEFT
        camera = coin.SoOrthographicCamera()  # shows coordinates from -1 to 1 in both directions
        camera.viewportMapping, camera.height = coin.SoCamera.LEAVE_ALONE, 2.0
        camera.position, camera.nearDistance, camera.farDistance = (0.0, 0.0, 1.0), 0.5, 2.0
        pick, begin = coin.SoPickStyle(), coin.SoCallback()
        pick.style = coin.SoPickStyle.UNPICKABLE
        begin.setCallback(self._begin, None)
        self._drawn = coin.SoAnnotation()
        for child in (pick, begin, camera, self._place, self._image):
            self._drawn.addChild(child)
        # A class of FreeCAD's.
        self.node = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
        self.node.getField("mode").set("EXCLUDE_BBOX")

    def show(self, picture, left_free, reach):
        """Shows a picture, uint8 (height, width, 4), the lowest row first; one without rows hides it.

        left_free  the corner of the view from which `reach` pixels in both directions stay free
        """
        self.size, self._left_free, self._reach, self._seen = picture.shape[1::-1], left_free, reach, None
        self.node.removeAllChildren()
        if picture.size:
            self._image.image.setValue(coin.SbVec2s(*self.size), 4, picture.tobytes())
            self.node.addChild(self._drawn)

    def place_in(self, width, height):
        """(left, low): pixels of its lower left corner in a view of this size."""
        right, low, high = width - _MARGIN, _MARGIN, height - _MARGIN
        if self._reach and self._left_free in (TOP_RIGHT, BOTTOM_RIGHT):
            if high - low - self._reach < self.size[1]:
                right -= self._reach
            elif self._left_free == TOP_RIGHT:
                high -= self._reach
            else:
                low += self._reach
        return right - self.size[0], (low + high - self.size[1]) // 2

    def _begin(self, _, action):
        if not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            return
        # Coin enables those of the scene again.
        for plane in range(_CLIP_PLANES):
            _gl().glDisable(_CLIP_PLANE + plane)
        pixels = coin.SoViewportRegionElement.get(action.getState()).getViewportSizePixels()
        seen = pixels[0], pixels[1]  # getValue() gives no numbers in pivy of Debian testing
        if seen == self._seen:
            return
        self._seen = seen
        # A point slightly inside of the pixel, so that rounding does not lead to the one before.
        x, y = (2.0 * (place + 0.25) / max(size, 1) - 1.0 for place, size in zip(self.place_in(*seen), seen))
        # The legend is being drawn: no notification is needed to draw it again.
        told = self._place.translation.enableNotify(False)
        self._place.translation = (x, y, 0.0)
        self._place.translation.enableNotify(told)


def _gl():
    """The OpenGL that Coin has loaded."""
    return ctypes.WinDLL("opengl32") if os.name == "nt" else ctypes.CDLL(None)
