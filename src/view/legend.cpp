// SPDX-License-Identifier: LGPL-2.1-or-later
#include "view/legend.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoDepthBuffer.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoFont.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoText2.h>
#include <Inventor/nodes/SoTranslation.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include "view/overlay.h"

namespace mq::view {

namespace {

// The window reaches from -1 to 1 in both directions.
constexpr float kLeft = 0.92F, kRight = 0.96F, kBottom = -0.6F, kTop = 0.6F;
constexpr float kGap = 0.015F;
constexpr float kTextHeight = 0.02F;
constexpr float kFontSize = 13.0F;  // pixels

SoSeparator* text(const std::string& words, float x, float y) {
    auto* separator = new SoSeparator;
    auto* place = new SoTranslation;
    place->translation.setValue(x, y, 0.0F);
    auto* label = new SoText2;
    label->string.setValue(words.c_str());
    label->justification = SoText2::RIGHT;
    separator->addChild(place);
    separator->addChild(label);
    return separator;
}

SoFaceSet* bar(const std::vector<Colour>& colours) {
    auto* points = new SoVertexProperty;
    points->materialBinding = SoVertexProperty::PER_FACE;
    const float step = (kTop - kBottom) / static_cast<float>(colours.size());
    int n = 0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const float low = kBottom + step * static_cast<float>(i);
        points->orderedRGBA.set1Value(static_cast<int>(i), packed(colours[i]));
        points->vertex.set1Value(n++, kLeft, low, 0.0F);
        points->vertex.set1Value(n++, kRight, low, 0.0F);
        points->vertex.set1Value(n++, kRight, low + step, 0.0F);
        points->vertex.set1Value(n++, kLeft, low + step, 0.0F);
    }
    auto* faces = new SoFaceSet;
    faces->vertexProperty = points;
    faces->numVertices.setNum(static_cast<int>(colours.size()));
    for (std::size_t i = 0; i < colours.size(); ++i) {
        faces->numVertices.set1Value(static_cast<int>(i), 4);
    }
    return faces;
}

}  // namespace

SoSeparator* make_legend() {
    Overlay::initClass();
    return new Overlay;
}

void fill_legend(SoSeparator& legend, const std::string& title, const std::vector<Colour>& colours,
                 const std::vector<std::string>& labels) {
    legend.removeAllChildren();
    if (colours.empty()) {
        return;
    }
    auto* camera = new SoOrthographicCamera;
    camera->viewportMapping = SoCamera::LEAVE_ALONE;
    camera->position.setValue(0.0F, 0.0F, 1.0F);
    camera->height = 2.0F;
    camera->nearDistance = 0.5F;
    camera->farDistance = 2.0F;
    auto* in_front = new SoDepthBuffer;
    in_front->test = FALSE;
    auto* light = new SoLightModel;
    light->model = SoLightModel::BASE_COLOR;
    auto* font = new SoFont;
    font->size = kFontSize;
    auto* ink = new SoBaseColor;
    ink->rgb.setValue(0.0F, 0.0F, 0.0F);
    for (SoNode* node : {static_cast<SoNode*>(camera), static_cast<SoNode*>(in_front), static_cast<SoNode*>(light),
                         static_cast<SoNode*>(bar(colours)), static_cast<SoNode*>(font), static_cast<SoNode*>(ink)}) {
        legend.addChild(node);
    }
    legend.addChild(text(title, kRight, kTop + 3.0F * kTextHeight));
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const float part = labels.size() > 1 ? static_cast<float>(i) / static_cast<float>(labels.size() - 1) : 0.0F;
        legend.addChild(text(labels[i], kLeft - kGap, kBottom + part * (kTop - kBottom) - 0.5F * kTextHeight));
    }
}

}  // namespace mq::view
