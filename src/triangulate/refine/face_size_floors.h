// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// The least distance between vertices that refinement for angles inserts, by face.
///
/// Where a surface has a singular point inside a face, or a face is narrower than the resolution of single precision,
/// no triangulation has good angles: triangles become exempt at the resolution, and their neighbourhood is refined to
/// their size, which takes millions of triangles. So the more triangles of a face are exempt at the resolution, the
/// larger is the least distance on it.
class FaceSizeFloors {
  public:
    /// @param bound  of angles, radians; 0: no face is too narrow
    explicit FaceSizeFloors(const Workspace& work, double bound = 0.0) : work_(work), bound_(bound) {}

    /// Returns the least distance on a face, mm; `Workspace::shortest_allowed` unless it was raised.
    double of(int face) const;
    /// Whether halves of a segment of this length (mm) would be shorter than a raised floor of the faces beside it.
    bool too_short_to_split(int segment, double length) const;
    /// Whether the triangle and those beside it join two sides of the face's boundary that are nearer to each other
    /// than floor tan(bound). Halving divides both alike, so that the triangles between are right-angled, and pieces no
    /// shorter than the floor are too long for the bound.
    bool too_narrow(int triangle) const;
    /// Counts `added` further insertions; checks the exempt triangles if enough were made, and raises floors.
    void check_after(std::size_t added);
    /// Returns how often any floor was raised.
    std::size_t raises() const { return raises_; }

  private:
    struct Raised {
        double factor = 1.0;
        std::size_t most = 0;  // number of exempt triangles at which the floor is raised again
    };

    bool joins_near_sides(int triangle) const;

    const Workspace& work_;
    double bound_;                  // radians
    std::map<int, Raised> raised_;  // by face
    std::size_t added_ = 0;         // insertions since the last check
    std::size_t raises_ = 0;
};

}  // namespace mq::triangulate
