// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mq::triangulate {

struct Workspace;

/// The smallest angle over the number of triangles while vertices are inserted (Aftosmis 1999, figures 7 and 10).
/// Records nothing until it is started.
class AngleHistory {
  public:
    struct Entry {
        std::size_t triangles = 0;
        double min_angle = 0.0;  ///< degrees; over the triangles that are not exempt
    };

    void start() { running_ = true; }
    void stop() { running_ = false; }
    bool running() const { return running_; }
    /// Adds the present state, while it runs. Time O(triangles).
    void record(const Workspace& work) {
        if (running_) {
            add(work);
        }
    }
    const std::vector<Entry>& entries() const { return entries_; }

  private:
    struct Known {
        std::uint64_t version = 0;  // 1 + version of the triangle; 0: not measured
        double angle = 0.0;         // radians
    };
    void add(const Workspace& work);

    std::vector<Entry> entries_;
    std::vector<Known> known_;  // by triangle
    bool running_ = false;
};

}  // namespace mq::triangulate
