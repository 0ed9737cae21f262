// SPDX-License-Identifier: LGPL-2.1-or-later
#include "view/legend.h"

#include <Inventor/nodes/SoDepthBuffer.h>
#include <Inventor/nodes/SoImage.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoTranslation.h>

#include <algorithm>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::view {

namespace {

constexpr int kMargin = 10;  // pixels between the picture and the window's edge

SoOrthographicCamera* whole_window() {
    auto* camera = new SoOrthographicCamera;  // shows coordinates from -1 to 1 in both directions
    camera->viewportMapping = SoCamera::LEAVE_ALONE;
    camera->position.setValue(0.0F, 0.0F, 1.0F);
    camera->height = 2.0F;
    camera->nearDistance = 0.5F;
    camera->farDistance = 2.0F;
    return camera;
}

SoImage* image_of(const LegendPicture& picture) {
    auto* image = new SoImage;
    image->vertAlignment = SoImage::BOTTOM;
    image->horAlignment = SoImage::LEFT;
    image->image.setValue(SbVec2s(static_cast<short>(picture.width), static_cast<short>(picture.height)), 4,
                          picture.rgba.data());
    return image;
}

/// The coordinate of the window from -1 to 1 at a pixel.
float window_coordinate(int pixel, int pixels) {
    // A point slightly inside of the pixel, so that rounding does not lead to the one before.
    return (2.0F * (static_cast<float>(pixel) + 0.25F)) / static_cast<float>(std::max(pixels, 1)) - 1.0F;
}

}  // namespace

SO_NODE_SOURCE(Legend);

void Legend::initClass() {
    Overlay::initClass();
    if (getClassTypeId() == SoType::badType()) {
        SO_NODE_INIT_CLASS(Legend, Overlay, "Overlay");
    }
}

Legend::Legend() {
    SO_NODE_CONSTRUCTOR(Legend);
}

void Legend::show(const LegendPicture& picture) {
    if (picture.rgba.size() != std::size_t{4} * picture.width * picture.height) {
        throw InvalidInput(phrases::kLegendNumbers,
                           {{"count", picture.width}, {"count2", picture.height}, {"count3", picture.rgba.size()}});
    }
    removeAllChildren();
    picture_ = picture;
    window_ = SbVec2s(0, 0);
    if (picture.rgba.empty()) {
        return;
    }
    auto* in_front = new SoDepthBuffer;
    in_front->test = FALSE;
    place_ = new SoTranslation;
    addChild(whole_window());
    addChild(in_front);
    addChild(place_);
    addChild(image_of(picture));
}

SbVec2s Legend::place_in(const SbVec2s& window) const {
    int right = window[0] - kMargin, low = kMargin, high = window[1] - kMargin;
    const bool at_top = picture_.left_free == Corner::TopRight;
    if (picture_.reach > 0 && (at_top || picture_.left_free == Corner::BottomRight)) {
        if (high - low - picture_.reach >= picture_.height) {
            (at_top ? high : low) += at_top ? -picture_.reach : picture_.reach;
        } else {
            right -= picture_.reach;
        }
    }
    return {static_cast<short>(right - picture_.width), static_cast<short>((low + high - picture_.height) / 2)};
}

void Legend::begin_drawing(const SbVec2s& window) {
    if (window == window_ || getNumChildren() == 0) {
        return;
    }
    window_ = window;
    const SbVec2s place = place_in(window);
    // The legend is being drawn: no notification is needed to draw it again.
    const SbBool told = place_->translation.enableNotify(FALSE);
    place_->translation.setValue(window_coordinate(place[0], window[0]), window_coordinate(place[1], window[1]), 0.0F);
    place_->translation.enableNotify(told);
}

}  // namespace mq::view
