// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "triangulate/workspace.h"

namespace mq::triangulate {

/// How near to each other refinement for angles may put vertices, face by face.
///
/// Where a surface shrinks to a point inside a face, or a face is narrower than single precision tells apart, no
/// triangulation has good angles: triangles are given up at the resolution, and what lies around them is refined to
/// their size, which takes millions of triangles. So the more triangles of a face are given up for want of room, the
/// coarser is what its angles may ask for.
class FaceFloors {
  public:
    explicit FaceFloors(const Workspace& work);

    /// mm; `Workspace::shortest_allowed` on all faces that have not been raised.
    double of(int face) const;
    /// Halves of a segment of this length, mm, would be shorter than a raised floor of the faces beside it.
    bool too_short_to_split(int segment, double length) const;
    /// Looks at the triangles that were given up, once `added` more have been; raises the floors that follow.
    void look(std::size_t added);

  private:
    struct Raised {
        double factor = 1.0;
        std::size_t most = 0;  // triangles given up before it is raised again
    };

    const Workspace& work_;
    std::map<int, Raised> raised_;  // by face
    std::size_t added_ = 0;         // since the last look
};

}  // namespace mq::triangulate
