// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "view/overlay.h"

class SoImage;
class SoTranslation;

namespace mq::view {

/// Corners of the window, as FreeCAD numbers them.
enum class Corner { TopLeft, TopRight, BottomLeft, BottomRight };

/// A picture of a legend.
struct LegendPicture {
    int width = 0, height = 0;       ///< pixels
    std::vector<std::uint8_t> rgba;  ///< four a pixel, the lowest row first
    Corner left_free = Corner::TopRight;
    int reach = 0;  ///< pixels from that corner in both directions that are not the legend's to cover; 0: none
};

/// A picture at the window's right side, beside what the window has in one of its corners. Empty until it is filled.
class Legend : public Overlay {
    SO_NODE_HEADER(Legend);

  public:
    /// Makes the class known to Coin; any number of calls.
    static void initClass();
    Legend();

    /// Shows another picture; one of no size: none.
    void show(const LegendPicture& picture);
    /// Where the picture's lower left corner is in a window of this size, in pixels from the window's.
    SbVec2s place_in(const SbVec2s& window) const;

  protected:
    ~Legend() override = default;
    void begin_drawing(const SbVec2s& window) override;

  private:
    LegendPicture picture_;
    SbVec2s window_{0, 0};  ///< that the picture was placed in last
    SoTranslation* place_ = nullptr;
};

}  // namespace mq::view
