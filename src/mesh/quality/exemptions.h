// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Writes the list of exempt triangles, index and reason, to the report of a mesh, with the smallest angle of all
/// others.
void set_exempt(const TriangleMesh& mesh, std::vector<std::pair<std::int32_t, ExemptReason>> exempt,
                MeshReport& report);

/// Exempted triangles whose reasons differ in numbers only.
struct SameCause {
    std::string cause;      ///< the reason with '#' for every number: "corner of # degrees between Edge# and Edge# ..."
    std::size_t count = 0;  ///< number of triangles
    std::size_t first = 0;  ///< index into MeshReport::exempt
    std::vector<std::string> faces;  ///< names of the faces that they lie on, in the order met
};

/// The causes of all exemptions, most frequent first; equally frequent ones in the order in which they were met.
std::vector<SameCause> exempt_causes(const MeshReport& report);

/// Messages, or names, with commas between them: the first eight, and the number of the others.
Message list_of(const std::vector<Message>& all);
Message list_of(const std::vector<std::string>& names);

/// A line or two for each cause; empty without exemptions.
std::string exemptions_text(const MeshReport& report);

}  // namespace mq::mesh
