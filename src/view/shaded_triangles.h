// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "view/colour.h"

class SoFaceSet;
class SoSeparator;
class SoVertexProperty;

namespace mq::view {

/// Triangles with one colour each, as a node whose drawing Coin caches.
///
/// The shading is computed into the colours once, with a fixed light: without lamps and normals the processor of a
/// machine without a graphics card draws a million triangles four times as fast. The shading is weak, so that colours
/// stay those of the legend.
class ShadedTriangles {
  public:
    ShadedTriangles();

    SoSeparator* node() const { return node_; }
    std::size_t count() const { return shade_.size(); }

    /// Takes triangles as nine coordinates each. Grey until they are coloured.
    void show(const float* corners, std::size_t triangles);
    /// @throws InvalidInput unless there is a colour for each triangle
    void colour(const std::vector<Colour>& colours);

  private:
    SoSeparator* node_;
    SoVertexProperty* property_;
    SoFaceSet* faces_;
    std::vector<float> shade_;  ///< for each triangle the visible fraction of its colour
};

}  // namespace mq::view
