// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "view/legend.h"
#include "view/shaded_triangles.h"

class SoAction;
class SoFaceSet;
class SoIndexedLineSet;
class SoLineSet;
class SoSeparator;
class SoSwitch;
class SoVertexProperty;

namespace mq::view {

/// A mesh with one colour for each triangle, its edges, highlighted triangles, and a legend at the window's right side.
///
/// Coin caches the drawing as a display list, so that turning a million triangles needs the graphics card only. All
/// calls belong to the thread of the window.
class QualityScene {
  public:
    /// @throws GeometryError when Coin is not running, as outside of a FreeCAD with windows
    QualityScene();
    ~QualityScene();
    QualityScene(const QualityScene&) = delete;
    QualityScene& operator=(const QualityScene&) = delete;

    SoSeparator* root() const { return root_; }
    /// The name of the root; no other node of this process has it. pivy finds nodes by their names.
    const std::string& name() const { return name_; }
    ShadedTriangles& triangles() { return fine_; }
    /// Triangles that are drawn instead of the fine ones and their edges while the camera moves; when empty, nothing is
    /// drawn then.
    ShadedTriangles& coarse() { return coarse_; }

    /// Takes triangles as nine coordinates each. They are grey until they are coloured; none is highlighted.
    void show(const float* corners, std::size_t triangles);
    /// Sets whether the camera moves now.
    void moving(bool moves);
    /// Processor seconds of the last drawing of triangles and edges; 0: they were not drawn. Long without a graphics
    /// card.
    double drawing_seconds() const { return seconds_; }
    /// Lines as runs of point indices, each ended by -1; points as three coordinates each. No lines: none are drawn.
    void draw_edges(const float* points, std::size_t count, const std::vector<std::int32_t>& lines);
    /// Highlights these triangles and no others: they are drawn over the others with thick outlines, so that the
    /// smallest one is visible from afar.
    void light_up(const float* corners, std::size_t triangles);
    Legend& legend() { return *legend_; }

  private:
    static void begin_drawing(void* scene, SoAction* action);
    static void end_drawing(void* scene, SoAction* action);
    void make_triangles();
    SoSeparator* make_edges();
    void make_lit();

    std::string name_;
    SoSeparator* root_ = nullptr;
    SoSwitch* detail_ = nullptr;
    ShadedTriangles fine_, coarse_;
    std::chrono::steady_clock::time_point began_;
    double seconds_ = 0.0;
    SoVertexProperty* edge_points_ = nullptr;
    SoIndexedLineSet* edges_ = nullptr;
    SoVertexProperty* lit_ = nullptr;
    SoFaceSet* lit_faces_ = nullptr;
    SoLineSet* lit_outlines_ = nullptr;
    Legend* legend_ = nullptr;
};

}  // namespace mq::view
