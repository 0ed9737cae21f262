// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Records the mesh where its triangles are replaced, so that all changes since `begin` can be undone. While it is
/// closed, nothing is recorded.
class EditTransaction {
  public:
    explicit EditTransaction(Workspace& work) : work_(work) {}

    /// Starts to record. Must be followed by `commit` or `undo`.
    void begin() { changes_.emplace(); }
    bool is_open() const { return changes_.has_value(); }
    /// Keeps the changes, and ends the recording.
    void commit() { changes_.reset(); }
    /// Restores the recorded triangles, and ends the recording.
    /// @return by old index: the present index of each. Corners keep their order.
    std::map<int, int> undo();

    /// To be called before triangles are replaced.
    void about_to_remove(const std::vector<int>& triangles);
    void added(const std::vector<int>& triangles);
    /// To be called before the vertex between two segments is replaced by another one; `around` are the triangles
    /// around it. Pass them to `added` afterwards.
    void record_relocation(int near, int far, const std::vector<int>& around);

    // The following functions need an open transaction. The triangles that replaced the recorded ones.
    const std::set<int>& now() const { return changes_->now; }
    /// Returns the smallest angle of each recorded triangle, radians.
    std::vector<double> angles_before() const;
    /// The smallest alignment of the recorded triangles (see alignment).
    double alignment_before() const { return changes_->alignment; }

  private:
    struct Before {
        int triangle = -1;
        int face = -1;
        std::array<int, 3> sites{};
        double angle = 0.0;
        std::optional<Exemption> exemption;
    };
    struct Slide {
        int near = -1;
        int far = -1;
        int vertex = -1;
        double t = 0.0;
        std::map<int, int> sites;  ///< by use: the site of the vertex
    };
    struct Changes {
        std::set<int> now;
        std::vector<Before> before;
        double alignment = 1.0;
        std::vector<Slide> slides;
    };
    ClassifiedMesh::CavityFill refill_of(const Changes& changes, int face) const;
    void undo_relocation(const Slide& slide);
    std::map<int, std::vector<int>> restore_triangles(const Changes& changes);

    Workspace& work_;
    std::optional<Changes> changes_;
};

}  // namespace mq::triangulate
