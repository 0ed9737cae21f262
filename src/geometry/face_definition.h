// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <map>
#include <vector>

#include "geometry/fingerprint.h"
#include "geometry/model.h"

namespace mq::geometry {

/// Entities in the order in which they occur first, so that their numbers within the shape have no effect.
class LocalNumbers {
  public:
    /// Returns an entity's number here, from 0 on by dimension.
    int of(Entity entity) {
        const auto d = static_cast<std::size_t>(entity.dimension);
        const auto [entry, fresh] = numbers_[d].emplace(entity.index, static_cast<int>(numbers_[d].size()));
        if (fresh) {
            in_order_[d].push_back(entity.index);
        }
        return entry->second;
    }
    /// The entities of a dimension by their number here.
    const std::vector<int>& in_order(int dimension) const { return in_order_[static_cast<std::size_t>(dimension)]; }

  private:
    std::array<std::map<int, int>, 3> numbers_;
    std::array<std::vector<int>, 3> in_order_;
};

/// Adds all numbers that define the geometry, the topology and the tolerances of a face and of its edges and nodes,
/// to be called in Session::run.
/// @param frame  a face in whose frame the geometry is; -1: the model's own frame
/// @param numbers  receives the face's edges and nodes, where they are not in it
void add_face_definition(Model& model, int face, int frame, LocalNumbers& numbers, Fingerprint& key);

/// The uses of a face in the order of its loops: the same order for two faces with equal definitions.
std::vector<int> uses_in_order(const Face& face);

}  // namespace mq::geometry
