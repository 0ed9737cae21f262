// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "geometry/fingerprint.h"
#include "geometry/rigid_motion.h"
#include "geometry/session.h"

namespace mq::triangulate {

/// The CAD entities of a body that is compared with others, in the order in which its faces name them: two equal bodies
/// have the same at the same indices. All indices are those of the topology.
struct BodyEntities {
    std::array<std::vector<int>, 3> of;  ///< by dimension
    std::vector<int> uses;
};

/// The bodies of a shape that are equal to another one at another place.
struct EqualBodies {
    /// By body: the body with the lowest face that is equal to it, if that is another one; -1: there is none.
    std::vector<int> original;
    std::vector<geometry::RigidMotion> motion;  ///< by body: motion from its original to the body
    std::vector<BodyEntities> entities;         ///< by body; empty where none could be equal to it
    std::array<std::vector<int>, 3> places;     ///< by dimension and entity: its index in the entities of its body
    std::vector<int> places_of_uses;

    /// The entity of a copy that corresponds to `entity` of its original; -1 if no face of the original has it.
    int in_copy(geometry::Entity entity, int copy) const {
        const auto d = static_cast<std::size_t>(entity.dimension);
        const int place = places[d][static_cast<std::size_t>(entity.index)];
        return place < 0 ? -1 : entities[static_cast<std::size_t>(copy)].of[d][static_cast<std::size_t>(place)];
    }
    int use_in_copy(int use, int copy) const {
        return entities[static_cast<std::size_t>(copy)]
            .uses[static_cast<std::size_t>(places_of_uses[static_cast<std::size_t>(use)])];
    }
};

/// Finds bodies that consist of the same geometry with the same topology and tolerances, numbered in the same order, at
/// places between which lies a rigid motion: what scales or mirrors is not equal. The numbers that define the
/// geometry are compared bit by bit, in the frame of the body's first face.
/// A body that has an edge or a node in common with another one is not compared.
/// @param bodies  by body: its faces, ascending
/// @param add_more  adds what else about an entity has to be equal
/// @throws Cancelled
EqualBodies find_equal_bodies(geometry::Session& session, const std::vector<std::vector<int>>& bodies,
                              const std::function<void(geometry::Entity, geometry::Fingerprint&)>& add_more);

}  // namespace mq::triangulate
