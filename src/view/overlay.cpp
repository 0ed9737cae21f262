// SPDX-License-Identifier: LGPL-2.1-or-later
#include "view/overlay.h"

#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoClipPlaneElement.h>
#include <Inventor/system/gl.h>

namespace mq::view {

SO_NODE_SOURCE(Overlay);

void Overlay::initClass() {
    if (getClassTypeId() == SoType::badType()) {
        SO_NODE_INIT_CLASS(Overlay, SoSeparator, "Separator");
    }
}

Overlay::Overlay() {
    SO_NODE_CONSTRUCTOR(Overlay);
    renderCaching = OFF;
}

void Overlay::GLRenderBelowPath(SoGLRenderAction* action) {
    if (action->isRenderingDelayedPaths()) {
        begin_drawing(action->getViewportRegion().getViewportSizePixels());
        // Clipping planes are of the scene, and cut nothing that lies on the window.
        const int planes = SoClipPlaneElement::getInstance(action->getState())->getNum();
        for (int i = 0; i < planes; ++i) {
            glDisable(static_cast<GLenum>(GL_CLIP_PLANE0 + i));
        }
        SoSeparator::GLRenderBelowPath(action);
        for (int i = 0; i < planes; ++i) {
            glEnable(static_cast<GLenum>(GL_CLIP_PLANE0 + i));
        }
    } else {
        action->addDelayedPath(action->getCurPath()->copy());
    }
}

}  // namespace mq::view
