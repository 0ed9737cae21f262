// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Inventor/SbVec2s.h>
#include <Inventor/nodes/SoSeparator.h>

namespace mq::view {

/// A node of the scene that lies on the window rather than in space: it is drawn last, does not affect picking, and
/// "fit all" ignores it; clipping planes do not cut it.
class Overlay : public SoSeparator {
    SO_NODE_HEADER(Overlay);

  public:
    /// Makes the class known to Coin; any number of calls.
    static void initClass();
    Overlay();

    void GLRenderBelowPath(SoGLRenderAction* action) override;
    void getBoundingBox(SoGetBoundingBoxAction*) override {}
    void rayPick(SoRayPickAction*) override {}

  protected:
    ~Overlay() override = default;
    /// Called before drawing in a window of this size in pixels.
    virtual void begin_drawing(const SbVec2s& window) { static_cast<void>(window); }
};

}  // namespace mq::view
