// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Records the mesh where its triangles are replaced, so that all changes can be undone.
class EditTransaction {
  public:
    explicit EditTransaction(Workspace& work) : work_(work) {}

    /// To be called before triangles are replaced.
    void about_to_remove(const std::vector<int>& triangles);
    void added(const std::vector<int>& triangles) { now_.insert(triangles.begin(), triangles.end()); }
    /// To be called before a segment is split, which may happen once; its uses must lie on different faces. Before,
    /// pass the triangles beside it to `about_to_remove`; afterwards, their halves to `added`.
    void about_to_split(int segment);

    /// To be called before the vertex between two segments is replaced by another one. Pass the triangles around it to
    /// `about_to_remove` before and to `added` afterwards. None of the segments may be split later.
    void record_relocation(int near, int far);

    /// The triangles that replaced the recorded ones.
    const std::set<int>& now() const { return now_; }
    /// Returns the smallest angle of each recorded triangle, radians.
    std::vector<double> angles_before() const;
    /// The smallest alignment of the recorded triangles (see alignment).
    double alignment_before() const { return alignment_; }

    /// Restores the recorded triangles. @return by old index: the present index of each. Corners keep their order.
    std::map<int, int> undo();

  private:
    struct Before {
        int triangle = -1;
        int face = -1;
        std::array<int, 3> sites{};
        double angle = 0.0;
        std::optional<Exemption> exemption;
    };
    struct Split {
        int near = -1;
        int far = -1;
        std::vector<std::array<int, 2>> bases;  ///< by use: the sites at the ends of the segment
        std::vector<int> faces;
    };
    struct Slide {
        int near = -1;
        int far = -1;
        int vertex = -1;
        double t = 0.0;
        std::map<int, int> sites;  ///< by use: the site of the vertex
    };
    ClassifiedMesh::CavityFill refill_of(int face) const;
    void undo_relocation(const Slide& slide);

    Workspace& work_;
    std::set<int> now_;
    std::vector<Before> before_;
    double alignment_ = 1.0;
    std::optional<Split> split_;
    std::vector<Slide> slides_;
};

/// Nested transactions: the last one can be undone, or all can be committed.
class TransactionStack {
  public:
    explicit TransactionStack(Workspace& work) : work_(work) {}

    void begin() { open_.emplace_back(work_); }
    bool empty() const { return open_.empty(); }
    /// All recorded changes.
    const EditTransaction& first() const { return open_.front(); }
    /// The changes since the last `begin`.
    const EditTransaction& last() const { return open_.back(); }

    /// As in EditTransaction; without an open transaction nothing happens.
    void about_to_remove(const std::vector<int>& triangles);
    void about_to_split(int segment);
    void record_relocation(int near, int far, const std::vector<int>& around);
    void added(const std::vector<int>& triangles);

    /// @return as EditTransaction::undo
    std::map<int, int> undo_last();
    void keep_all() { open_.clear(); }

  private:
    Workspace& work_;
    std::deque<EditTransaction> open_;
};

}  // namespace mq::triangulate
