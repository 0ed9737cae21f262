// SPDX-License-Identifier: LGPL-2.1-or-later
#include "view/quality_scene.h"

#include <Inventor/SoDB.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoCallback.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoIndexedLineSet.h>
#include <Inventor/nodes/SoInfo.h>
#include <Inventor/nodes/SoLevelOfDetail.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include <algorithm>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "view/legend.h"

namespace mq::view {

namespace {

constexpr std::uint32_t kLit = 0xff20ffffU;  // red, green, blue, opacity: a colour that no scale has
/// The colour of edges: red, green, blue, 0 to 1; dark grey.
constexpr float kEdgeColour[3] = {0.15F, 0.15F, 0.15F};
constexpr int kFine = 0, kCoarse = 1;  // children of the switch
/// Square pixels of the box of the mesh for each edge, below which no edges are drawn, as they would blacken the
/// surface: where the box is filled to 70 %, edges are 5 pixels long there.
constexpr float kPixelsOfEdge = 5.0F;
constexpr float kOutline = 3.0F;  // width of outlines, pixels

void set_runs(SoMFInt32& runs, std::size_t count, std::int32_t length) {
    const std::vector<std::int32_t> lengths(count, length);
    runs.setNum(static_cast<int>(count));
    runs.setValues(0, static_cast<int>(count), lengths.data());
}

/// A separator whose drawing Coin caches.
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
        throw GeometryError(phrases::kNoView);
    }
    root_ = new SoSeparator;
    root_->ref();
    static int count = 0;
    name_ = "MeshQualityScene" + std::to_string(++count);
    root_->setName(name_.c_str());
    make_triangles();
    make_lit();
    Legend::initClass();
    legend_ = new Legend;
    root_->addChild(legend_);
    show(nullptr, 0);
    draw_edges(nullptr, 0, {});
}

void QualityScene::make_triangles() {
    detail_ = new SoSwitch;
    detail_->whichChild = kFine;
    auto* fine = new SoSeparator;
    fine->renderCaching = SoSeparator::OFF;  // the calls that take time must not be left out
    auto* before = new SoCallback;
    auto* after = new SoCallback;
    before->setCallback(&QualityScene::begin_drawing, this);
    after->setCallback(&QualityScene::end_drawing, this);
    fine->addChild(before);
    fine->addChild(fine_.node());
    fine->addChild(make_edges());
    fine->addChild(after);
    detail_->addChild(fine);
    detail_->addChild(coarse_.node());
    root_->addChild(detail_);
}

void QualityScene::begin_drawing(void* scene, SoAction* action) {
    if (action->isOfType(SoGLRenderAction::getClassTypeId())) {
        static_cast<QualityScene*>(scene)->began_ = std::chrono::steady_clock::now();
    }
}

void QualityScene::end_drawing(void* scene, SoAction* action) {
    if (action->isOfType(SoGLRenderAction::getClassTypeId())) {
        auto* self = static_cast<QualityScene*>(scene);
        self->seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - self->began_).count();
    }
}

SoLevelOfDetail* QualityScene::make_edges() {
    SoSeparator* edges = kept_separator();
    edge_detail_ = new SoLevelOfDetail;
    edge_detail_->addChild(edges);
    edge_detail_->addChild(new SoInfo);  // nothing
    auto* colour = new SoBaseColor;
    colour->rgb.setValue(kEdgeColour);
    edge_points_ = new SoVertexProperty;
    edges_ = new SoIndexedLineSet;
    edges_->vertexProperty = edge_points_;
    edges->addChild(unlit());
    edges->addChild(colour);
    edges->addChild(edges_);
    return edge_detail_;
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
    fine_.show(corners, triangles);
    light_up(nullptr, 0);
}

void QualityScene::moving(bool moves) {
    const int child = moves && coarse_.count() > 0 ? kCoarse : kFine;
    if (detail_->whichChild.getValue() != child) {
        detail_->whichChild = child;
    }
}

void QualityScene::draw_edges(const float* points, std::size_t count, const std::vector<std::int32_t>& lines) {
    edge_points_->vertex.setNum(static_cast<int>(count));
    edge_points_->vertex.setValues(0, static_cast<int>(count), reinterpret_cast<const float(*)[3]>(points));
    edges_->coordIndex.setNum(static_cast<int>(lines.size()));
    edges_->coordIndex.setValues(0, static_cast<int>(lines.size()), lines.data());
    edge_detail_->screenArea = kPixelsOfEdge * static_cast<float>(std::count(lines.begin(), lines.end(), -1));
}

void QualityScene::light_up(const float* corners, std::size_t triangles) {
    // Outlines are closed by repeating their first corner.
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

}  // namespace mq::view
