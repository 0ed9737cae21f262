// SPDX-License-Identifier: LGPL-2.1-or-later
#include "view/quality_scene.h"

#include <Inventor/SoDB.h>
#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoIndexedLineSet.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoPolygonOffset.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include "base/error.h"
#include "view/legend.h"

namespace mq::view {

namespace {

constexpr Colour kGrey{204, 204, 204, 255};
constexpr std::uint32_t kLit = 0xff20ffffU;  // red, green, blue, opacity: a colour that no scale has
constexpr float kEdgeColour[3] = {0.15F, 0.15F, 0.15F};
constexpr float kSideLight = 0.4F;
constexpr float kOutline = 3.0F;  // pixels

void set_corners(SoVertexProperty& property, const float* corners, std::size_t triangles) {
    property.vertex.setNum(static_cast<int>(3 * triangles));
    property.vertex.setValues(0, static_cast<int>(3 * triangles), reinterpret_cast<const float(*)[3]>(corners));
}

void set_runs(SoMFInt32& runs, std::size_t count, std::int32_t length) {
    const std::vector<std::int32_t> lengths(count, length);
    runs.setNum(static_cast<int>(count));
    runs.setValues(0, static_cast<int>(count), lengths.data());
}

std::vector<SbVec3f> normals_of(const float* corners, std::size_t triangles) {
    std::vector<SbVec3f> normals(triangles);
    for (std::size_t t = 0; t < triangles; ++t) {
        const SbVec3f a(corners + 9 * t), b(corners + 9 * t + 3), c(corners + 9 * t + 6);
        normals[t] = (b - a).cross(c - a);
        if (normals[t].normalize() == 0.0F) {
            normals[t] = SbVec3f(0.0F, 0.0F, 1.0F);
        }
    }
    return normals;
}

/// A separator whose drawing is kept by Coin.
SoSeparator* kept_separator() {
    auto* separator = new SoSeparator;
    separator->renderCaching = SoSeparator::ON;
    return separator;
}

SoLightModel* unlit() {
    auto* light = new SoLightModel;
    light->model = SoLightModel::BASE_COLOR;
    return light;
}

}  // namespace

QualityScene::QualityScene() {
    if (!SoDB::isInitialized()) {
        throw GeometryError("there is no 3D view: the quality of meshes is drawn in FreeCAD's window only");
    }
    root_ = new SoSeparator;
    root_->ref();
    static int count = 0;
    name_ = "MeshQualityScene" + std::to_string(++count);
    root_->setName(name_.c_str());
    make_surface();
    make_edges();
    make_lit();
    legend_ = make_legend();
    root_->addChild(legend_);
    show(nullptr, 0);
    draw_edges(nullptr, 0, {});
}

void QualityScene::make_surface() {
    SoSeparator* surface = kept_separator();
    // Beside the light of the view, from all around: colours in the shade must still be those of the legend.
    for (const SbVec3f& from : {SbVec3f(1, 1, 1), SbVec3f(1, -1, -1), SbVec3f(-1, 1, -1), SbVec3f(-1, -1, 1)}) {
        auto* light = new SoDirectionalLight;
        light->direction = from;
        light->intensity = kSideLight;
        surface->addChild(light);
    }
    auto* hints = new SoShapeHints;  // neither closed nor oriented need the mesh be: both sides are lit
    hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
    auto* behind = new SoPolygonOffset;
    surface_ = new SoVertexProperty;
    surface_->normalBinding = SoVertexProperty::PER_FACE;
    surface_->materialBinding = SoVertexProperty::PER_FACE;
    faces_ = new SoFaceSet;
    faces_->vertexProperty = surface_;
    surface->addChild(hints);
    surface->addChild(behind);
    surface->addChild(faces_);
    root_->addChild(surface);
}

void QualityScene::make_edges() {
    SoSeparator* edges = kept_separator();
    auto* colour = new SoBaseColor;
    colour->rgb.setValue(kEdgeColour);
    edge_points_ = new SoVertexProperty;
    edges_ = new SoIndexedLineSet;
    edges_->vertexProperty = edge_points_;
    edges->addChild(unlit());
    edges->addChild(colour);
    edges->addChild(edges_);
    root_->addChild(edges);
}

void QualityScene::make_lit() {
    auto* lit = new SoSeparator;
    auto* style = new SoDrawStyle;
    style->lineWidth = kOutline;
    lit_ = new SoVertexProperty;
    lit_->orderedRGBA = kLit;
    lit_->materialBinding = SoVertexProperty::OVERALL;
    lit_faces_ = new SoFaceSet;
    lit_faces_->vertexProperty = lit_;
    lit_outlines_ = new SoLineSet;
    lit_outlines_->vertexProperty = lit_;
    lit->addChild(unlit());
    lit->addChild(style);
    lit->addChild(lit_faces_);
    lit->addChild(lit_outlines_);

    root_->addChild(lit);
}

QualityScene::~QualityScene() {
    root_->unref();
}

void QualityScene::show(const float* corners, std::size_t triangles) {
    triangles_ = triangles;
    set_corners(*surface_, corners, triangles);
    const std::vector<SbVec3f> normals = normals_of(corners, triangles);
    surface_->normal.setNum(static_cast<int>(triangles));
    surface_->normal.setValues(0, static_cast<int>(triangles), normals.data());
    set_runs(faces_->numVertices, triangles, 3);
    colour(std::vector<Colour>(triangles, kGrey));
    light_up(nullptr, 0);
}

void QualityScene::colour(const std::vector<Colour>& colours) {
    if (colours.size() != triangles_) {
        throw InvalidInput(std::to_string(colours.size()) + " colours were given for " + std::to_string(triangles_) +
                           " triangles");
    }
    std::vector<std::uint32_t> values(colours.size());
    for (std::size_t t = 0; t < colours.size(); ++t) {
        values[t] = packed(colours[t]);
    }
    surface_->orderedRGBA.setNum(static_cast<int>(values.size()));
    surface_->orderedRGBA.setValues(0, static_cast<int>(values.size()), values.data());
}

void QualityScene::draw_edges(const float* points, std::size_t count, const std::vector<std::int32_t>& lines) {
    edge_points_->vertex.setNum(static_cast<int>(count));
    edge_points_->vertex.setValues(0, static_cast<int>(count), reinterpret_cast<const float(*)[3]>(points));
    edges_->coordIndex.setNum(static_cast<int>(lines.size()));
    edges_->coordIndex.setValues(0, static_cast<int>(lines.size()), lines.data());
}

void QualityScene::light_up(const float* corners, std::size_t triangles) {
    // Outlines are closed by their first corner again.
    std::vector<float> rounds;
    rounds.reserve(12 * triangles);
    for (std::size_t t = 0; t < triangles; ++t) {
        rounds.insert(rounds.end(), corners + 9 * t, corners + 9 * t + 9);
        rounds.insert(rounds.end(), corners + 9 * t, corners + 9 * t + 3);
    }
    lit_->vertex.setNum(static_cast<int>(4 * triangles));
    lit_->vertex.setValues(0, static_cast<int>(4 * triangles), reinterpret_cast<const float(*)[3]>(rounds.data()));
    set_runs(lit_faces_->numVertices, triangles, 4);
    set_runs(lit_outlines_->numVertices, triangles, 4);
}

void QualityScene::legend(const std::string& title, const std::vector<Colour>& colours,
                          const std::vector<std::string>& labels) {
    fill_legend(*legend_, title, colours, labels);
}

}  // namespace mq::view
