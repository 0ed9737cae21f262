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

/// The picture of a legend.
struct LegendPicture {
    int width = 0, height = 0;       ///< pixels
    std::vector<std::uint8_t> rgba;  ///< four bytes for each pixel, the lowest row first
    Corner left_free = Corner::TopRight;
    int reach = 0;  ///< pixels from that corner in both directions that the legend must not cover; 0: none
};

/// A picture at the window's right side, beside other things in one of the window's corners. Empty until it is filled.
class Legend : public Overlay {
    SO_NODE_HEADER(Legend);

  public:
    /// Makes the class known to Coin; any number of calls.
    static void initClass();
    Legend();

    /// Shows another picture; an empty one hides the legend.
    void show(const LegendPicture& picture);
    /// The position of the picture's lower left corner in a window of this size, in pixels from the window's.
    SbVec2s place_in(const SbVec2s& window) const;

  protected:
    ~Legend() override = default;
    void begin_drawing(const SbVec2s& window) override;

  private:
    LegendPicture picture_;
    SbVec2s window_{0, 0};  ///< window in which the picture was placed last
    SoTranslation* place_ = nullptr;
};

}  // namespace mq::view
