// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/query.h"
#include "geometry/topology.h"

namespace mq::geometry {

/// A part behind a modeler-neutral face: the role that CAPRI has in Aftosmis 1999, section 2.
///
/// A model belongs to the thread of the engine that answers for it: only that thread calls `answer`. The topology is
/// plain data, fixed once the model stands, and may be read from anywhere.
class Model {
  public:
    virtual ~Model() = default;

    const Topology& topology() const { return topology_; }
    /// Never throws: what goes wrong is in the answer's status.
    virtual Answer answer(const Query& query) noexcept = 0;

  protected:
    Topology topology_;
};

}  // namespace mq::geometry
