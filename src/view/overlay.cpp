// SPDX-License-Identifier: LGPL-2.1-or-later
#include "view/overlay.h"

#include <Inventor/actions/SoGLRenderAction.h>

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
        SoSeparator::GLRenderBelowPath(action);
    } else {
        action->addDelayedPath(action->getCurPath()->copy());
    }
}

}  // namespace mq::view
