// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include "geometry/fingerprint.h"
#include "geometry/query.h"
#include "geometry/rigid_motion.h"
#include "geometry/topology.h"

namespace mq::geometry {

struct ElementarySurface;

/// Answers queries in one thread at a time.
class Answerer {
  public:
    virtual ~Answerer() = default;
    /// Never throws: failures are in the answer's status.
    virtual Answer answer(const Query& query) noexcept = 0;
};

/// A CAD model behind a modeler-neutral interface: the role that CAPRI has in Aftosmis 1999, section 2.
///
/// A model belongs to the engine that answers for it: only its main thread calls `answer` and `add_definition`, or,
/// while that waits, the work of Session::in_place on a thread for jobs. The topology and the place are plain data,
/// fixed once the model is built, and may be read from anywhere.
class Model : public Answerer {
  public:
    const Topology& topology() const { return topology_; }
    /// The object that answers queries in one of several threads that work while the engine's main thread waits for
    /// them; 0 is the model itself. All give the same answers. Made at the first call, on the engine's main thread;
    /// null if there is no further one.
    virtual Answerer* answerer(int thread) { return thread == 0 ? this : nullptr; }

    /// The surface of a face by formula, in the frame of the answers; empty where it has none. Plain data, which any
    /// thread may evaluate.
    virtual std::optional<ElementarySurface> elementary_surface(int face) = 0;

    /// The placement of the whole model: the motion from its own frame to that of the topology and the answers.
    const RigidMotion& place() const { return place_; }
    /// The placement of a face: the motion from the frame of its own definition to that of the topology and the
    /// answers. None where that is no rigid motion.
    virtual std::optional<RigidMotion> place_of_face(int /*face*/) { return std::nullopt; }
    /// The smallest angle of a face between its edges at a node, radians, as the shape has it, whatever the topology
    /// counts as one (Topology::joined). None where the node is no corner of the face.
    virtual std::optional<double> corner_angle(int /*face*/, int /*node*/) { return std::nullopt; }
    /// Adds all numbers that define the geometry of a face (its surface), an edge (its curve) or a node (its point).
    /// @param frame  a face with a placement, in whose frame they are; -1: in the model's own frame
    virtual void add_definition(Entity entity, int frame, Fingerprint& key) = 0;
    /// Adds the numbers that define the curve of an edge use in (u, v).
    virtual void add_definition_of_use(int use, Fingerprint& key) = 0;

  protected:
    Topology topology_;
    RigidMotion place_;
};

}  // namespace mq::geometry
