// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "view/colour.h"

class SoFaceSet;
class SoIndexedLineSet;
class SoLineSet;
class SoSeparator;
class SoVertexProperty;

namespace mq::view {

/// A mesh with one colour a triangle, its edges, triangles that are lit up, and a legend at the window's right side.
///
/// Coin keeps what is drawn as a display list, so that turning a million triangles costs the graphics card only. All
/// calls belong to the thread of the window.
class QualityScene {
  public:
    /// @throws GeometryError when Coin is not running, as outside of a FreeCAD with windows
    QualityScene();
    ~QualityScene();
    QualityScene(const QualityScene&) = delete;
    QualityScene& operator=(const QualityScene&) = delete;

    SoSeparator* root() const { return root_; }
    /// Of the root; no other node of this process has it. pivy finds nodes by their names.
    const std::string& name() const { return name_; }
    std::size_t triangles() const { return triangles_; }

    /// Takes triangles as nine coordinates each. Grey until they are coloured; nothing is lit up.
    void show(const float* corners, std::size_t triangles);
    /// @throws InvalidInput unless there is a colour for each triangle
    void colour(const std::vector<Colour>& colours);
    /// Lines as runs of point indices, each ended by -1; points as three coordinates each. No lines: none are drawn.
    void draw_edges(const float* points, std::size_t count, const std::vector<std::int32_t>& lines);
    /// Lights up other triangles than before: they are drawn over the others with thick outlines, so that the smallest
    /// one is seen from afar.
    void light_up(const float* corners, std::size_t triangles);
    /// Colours from bottom to top, and labels spread evenly over them; none: no legend.
    void legend(const std::string& title, const std::vector<Colour>& colours, const std::vector<std::string>& labels);

  private:
    void make_surface();
    void make_edges();
    void make_lit();

    std::string name_;
    SoSeparator* root_ = nullptr;
    SoVertexProperty* surface_ = nullptr;
    SoFaceSet* faces_ = nullptr;
    SoVertexProperty* edge_points_ = nullptr;
    SoIndexedLineSet* edges_ = nullptr;
    SoVertexProperty* lit_ = nullptr;
    SoFaceSet* lit_faces_ = nullptr;
    SoLineSet* lit_outlines_ = nullptr;
    SoSeparator* legend_ = nullptr;
    std::size_t triangles_ = 0;
};

}  // namespace mq::view
