// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include "base/stopwatch.h"
#include "base/vec.h"
#include "geometry/topology.h"
#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// Ends the stages of a clock and, for debugging, writes the mesh under construction after each: NUMBER-STAGE.ply in
/// the folder that the environment variable MESHQUALITY_STAGES names. Without the variable nothing is written.
class StageMeshes {
  public:
    /// Writes the initial triangulation.
    /// @throws IoError naming the file that cannot be written, as does `end`
    StageMeshes(const ClassifiedMesh& mesh, const geometry::Topology& topology, const Vec3& origin, StageTimer& clock);

    /// Ends the running stage and names it, and releases memory. The time for writing counts for the next one.
    void end(const char* stage);
    /// Ends the running stage, in which stages ran side by side (see StageTimer::end_together), and writes one mesh.
    void end_together(const StageTimes& stages);

  private:
    // Returns freed memory that the allocator keeps to the system, if the mesh is large.
    void release_memory() const;
    void write(const std::string& stage);

    const ClassifiedMesh& mesh_;
    const geometry::Topology& topology_;
    Vec3 origin_;
    StageTimer& clock_;
    std::string folder_;
    int written_ = 0;
};

}  // namespace mq::triangulate
