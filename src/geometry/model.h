// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/fingerprint.h"
#include "geometry/motion.h"
#include "geometry/query.h"
#include "geometry/topology.h"

namespace mq::geometry {

/// A part behind a modeler-neutral face: the role that CAPRI has in Aftosmis 1999, section 2.
///
/// A model belongs to the thread of the engine that answers for it: only that thread calls `answer` and
/// `add_definition`. The topology and the place are plain data, fixed once the model stands, and may be read from
/// anywhere.
class Model {
  public:
    virtual ~Model() = default;

    const Topology& topology() const { return topology_; }
    /// Never throws: what goes wrong is in the answer's status.
    virtual Answer answer(const Query& query) noexcept = 0;

    /// Where the part stands as a whole: what takes its own frame to that of the topology and the answers.
    const Motion& place() const { return place_; }
    /// Adds all numbers that the geometry of a face (its surface), an edge (its curve) or a node (its point) is made
    /// of, in the part's own frame.
    virtual void add_definition(Entity entity, Fingerprint& key) = 0;
    /// The same of the curve of an edge use in (u, v).
    virtual void add_definition_of_use(int use, Fingerprint& key) = 0;

  protected:
    Topology topology_;
    Motion place_;
};

}  // namespace mq::geometry
