// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::workflows {

/// An operand as it was given: a mesh, and whether its coordinates may be rounded to single precision.
struct FramedOperand {
    const mesh::TriangleMesh* mesh = nullptr;
    bool round = false;  ///< true for meshes that FreeCAD stores in single precision and places with more digits
};

/// Brings operands into one frame: for models that lie far from the origin it is a local one (see SinglePrecisionGrid).
///
/// Operands that are in that frame already are used as they are, without a copy. Those that are moved into it, and
/// those to be rounded, become single-precision numbers again; meshes with more digits than that keep them, and then
/// the frame is the model's.
class OperandFrame {
  public:
    /// @throws InvalidInput for coordinates above 1.8e19 mm
    explicit OperandFrame(const std::vector<FramedOperand>& operands);

    /// Valid as long as this object and the given meshes are.
    const std::vector<const mesh::TriangleMesh*>& meshes() const { return meshes_; }
    /// Longest side of the box of all operands, mm.
    double size() const { return size_; }
    /// Whether all coordinates are single-precision numbers.
    bool single() const { return single_; }

  private:
    std::vector<mesh::TriangleMesh> moved_;
    std::vector<const mesh::TriangleMesh*> meshes_;
    double size_ = 0.0;
    bool single_ = true;
};

}  // namespace mq::workflows
