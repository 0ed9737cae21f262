// SPDX-License-Identifier: LGPL-2.1-or-later
#include "view/shaded_triangles.h"

#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoPolygonOffset.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include <cstdint>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::view {

namespace {

/// The colour before any is set: light grey.
constexpr Colour kGrey{204, 204, 204, 255};
constexpr float kDarkest = 0.65F;  // fraction of its colour that a triangle keeps when it is turned away from the light
/// Direction to the light: above the usual view from the front right.
constexpr float kLight[3] = {0.365F, -0.548F, 0.753F};

float shade_of(const float* corners) {
    const SbVec3f a(corners), b(corners + 3), c(corners + 6);
    SbVec3f normal = (b - a).cross(c - a);
    if (normal.normalize() == 0.0F) {
        return 1.0F;
    }
    return kDarkest + (1.0F - kDarkest) * 0.5F * (1.0F + normal.dot(SbVec3f(kLight)));
}

std::uint32_t shaded(Colour colour, float shade) {
    for (std::size_t k = 0; k < 3; ++k) {
        colour[k] = static_cast<std::uint8_t>(static_cast<float>(colour[k]) * shade + 0.5F);
    }
    return packed(colour);
}

}  // namespace

ShadedTriangles::ShadedTriangles() : node_(new SoSeparator), property_(new SoVertexProperty), faces_(new SoFaceSet) {
    node_->renderCaching = SoSeparator::ON;
    auto* light = new SoLightModel;
    light->model = SoLightModel::BASE_COLOR;
    property_->materialBinding = SoVertexProperty::PER_FACE;
    faces_->vertexProperty = property_;
    node_->addChild(light);
    node_->addChild(new SoPolygonOffset);  // drawn behind the edges
    node_->addChild(faces_);
}

void ShadedTriangles::show(const float* corners, std::size_t triangles) {
    const int points = static_cast<int>(3 * triangles);
    property_->vertex.setNum(points);
    property_->vertex.setValues(0, points, reinterpret_cast<const float(*)[3]>(corners));
    const std::vector<std::int32_t> lengths(triangles, 3);
    faces_->numVertices.setNum(static_cast<int>(triangles));
    faces_->numVertices.setValues(0, static_cast<int>(triangles), lengths.data());
    shade_.resize(triangles);
    for (std::size_t t = 0; t < triangles; ++t) {
        shade_[t] = shade_of(corners + 9 * t);
    }
    colour(std::vector<Colour>(triangles, kGrey));
}

void ShadedTriangles::colour(const std::vector<Colour>& colours) {
    if (colours.size() != count()) {
        throw InvalidInput(phrases::kOneForEach, {{"name", "colours"}, {"count", colours.size()}, {"count2", count()}});
    }
    std::vector<std::uint32_t> values(colours.size());
    for (std::size_t t = 0; t < colours.size(); ++t) {
        values[t] = shaded(colours[t], shade_[t]);
    }
    property_->orderedRGBA.setNum(static_cast<int>(values.size()));
    property_->orderedRGBA.setValues(0, static_cast<int>(values.size()), values.data());
}

}  // namespace mq::view
