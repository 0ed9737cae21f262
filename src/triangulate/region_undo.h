// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "triangulate/workspace.h"

namespace mq::triangulate {

/// What one face was like where its triangles have been replaced since, so that all of it can be undone.
class RegionUndo {
  public:
    explicit RegionUndo(Workspace& work) : work_(work) {}

    /// Of one face all of them, before they are replaced.
    void about_to_remove(const std::vector<int>& triangles);
    void added(const std::vector<int>& triangles) { now_.insert(triangles.begin(), triangles.end()); }

    /// The triangles in the place of those that were there.
    const std::set<int>& now() const { return now_; }
    /// The smallest angles, radians, of those that were there.
    const std::vector<double>& angles_before() const { return angles_; }

    /// @return the index now of each triangle that was there, by the one that it had. Corners keep their order.
    std::map<int, int> undo();

  private:
    Workspace& work_;
    std::set<int> now_;
    std::vector<int> removed_;
    std::vector<std::array<int, 3>> sites_;  // of the removed, as what follows
    std::vector<double> angles_;
    std::vector<std::optional<Exemption>> exemptions_;
};

}  // namespace mq::triangulate
