// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "triangulate/workspace.h"

namespace mq::triangulate {

/// What the mesh was like where its triangles have been replaced since, so that all of it can be undone.
class RegionUndo {
  public:
    explicit RegionUndo(Workspace& work) : work_(work) {}

    /// Before triangles are replaced.
    void about_to_remove(const std::vector<int>& triangles);
    void added(const std::vector<int>& triangles) { now_.insert(triangles.begin(), triangles.end()); }
    /// Before a segment is split, which may be done once; its uses lie on different faces. The triangles beside it are
    /// told to `about_to_remove` first, and their halves to `added`.
    void about_to_split(int segment);

    /// Before the vertex between two segments gives way to another one; the triangles around it are told to
    /// `about_to_remove` first, and to `added` afterwards. None of the segments is split later on.
    void about_to_slide(int near, int far);

    /// The triangles in the place of those that were there.
    const std::set<int>& now() const { return now_; }
    /// The smallest angles, radians, of those that were there.
    std::vector<double> angles_before() const;
    /// The smallest alignment of those (see alignment).
    double alignment_before() const { return alignment_; }

    /// @return the index now of each triangle that was there, by the one that it had. Corners keep their order.
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
        std::vector<std::array<int, 2>> bases;  ///< by use: sites at the ends of the segment
        std::vector<int> faces;
    };
    struct Slide {
        int near = -1;
        int far = -1;
        int vertex = -1;
        double t = 0.0;
        std::map<int, int> sites;  ///< of the vertex, by use
    };
    mesh::SurfaceMesh::Refill refill_of(int face) const;
    void slide_back(const Slide& slide);

    Workspace& work_;
    std::set<int> now_;
    std::vector<Before> before_;
    double alignment_ = 1.0;
    std::optional<Split> split_;
    std::vector<Slide> slides_;
};

/// Trials within trials, of which the last can be undone, or all be kept.
class UndoStack {
  public:
    explicit UndoStack(Workspace& work) : work_(work) {}

    void begin() { open_.emplace_back(work_); }
    bool empty() const { return open_.empty(); }
    /// All that has changed.
    const RegionUndo& first() const { return open_.front(); }
    /// What has changed since the last `begin`.
    const RegionUndo& last() const { return open_.back(); }

    /// As RegionUndo's; without an open trial nothing happens.
    void about_to_remove(const std::vector<int>& triangles);
    void about_to_split(int segment);
    void about_to_slide(int near, int far, const std::vector<int>& around);
    void added(const std::vector<int>& triangles);

    /// @return as RegionUndo::undo
    std::map<int, int> undo_last();
    void keep_all() { open_.clear(); }

  private:
    Workspace& work_;
    std::deque<RegionUndo> open_;
};

}  // namespace mq::triangulate
