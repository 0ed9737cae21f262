// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "base/chord_table.h"
#include "tetrahedralise/cells/cell_measure.h"
#include "tetrahedralise/cells/tetrahedralisation.h"

namespace mq::tetrahedralise {

/// 1 for the regular tetrahedron, 0 for a flat one: its volume over the cube of its root mean square edge. The sign is
/// exact.
double volume_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The least sine of the dihedral angles.
double sine_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The condition that a flip must meet.
struct FlipRule {
    const CellMeasure* measure = nullptr;  ///< null: volume_quality is used
    double floor = 0.0;                    ///< every new cell must be better
    std::size_t most_around = 12;          ///< cells around an edge that is removed
    int chord_a = -1;                      ///< vertices around the edge that must be connected afterwards, or -1
    int chord_b = -1;
};

/// Flips whose scratch memory is used again.
class Flipper {
  public:
    explicit Flipper(Tetrahedralisation& mesh) : mesh_(mesh) {}

    /// Replaces two cells that share a face by three around the edge of their other corners.
    bool flip_face(int cell, int face, const FlipRule& rule) { return plan_face(cell, face, rule) && apply(); }
    /// Replaces the cells around an edge by the best ones without it (Shewchuk 2002: edge removal by dynamic
    /// programming over the triangulations of the ring).
    bool remove_edge(int a, int b, const FlipRule& rule) {
        return mesh_.ring(a, b, ring_) && plan_ring(a, b, rule) && apply();
    }
    EdgeRing& ring() { return ring_; }
    /// The cells that the last flip has made.
    const std::vector<int>& created() const { return created_; }

    /// Whether a face can be flipped, or the edge be removed whose ring has been found last; the mesh stays as it is.
    bool plan_face(int cell, int face, const FlipRule& rule);
    bool plan_ring(int a, int b, const FlipRule& rule);
    /// The cells that the flip planned last would remove and add.
    const std::vector<int>& removed() const { return removed_; }
    const std::vector<std::array<int, 4>>& added() const { return added_; }

  private:
    bool apply() {
        mesh_.replace(removed_, added_, created_);
        return true;
    }
    double quality(const std::array<int, 4>& v, const FlipRule& rule) const;
    double triangle_quality(int a, int b, std::size_t i, std::size_t k, std::size_t j, const FlipRule& rule) const;
    bool crosses_chord(std::size_t i, std::size_t k) const;

    static constexpr std::size_t kMostAround = 16;

    Tetrahedralisation& mesh_;
    EdgeRing ring_;
    int chord_from_ = -1;
    int chord_to_ = -1;
    ChordTable<double> table_;
    std::vector<std::array<int, 4>> added_;
    std::vector<int> removed_;
    std::vector<int> created_;
};

}  // namespace mq::tetrahedralise
