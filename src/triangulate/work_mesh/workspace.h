// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/single_precision_grid.h"
#include "geometry/cad_samples.h"
#include "geometry/session.h"
#include "mesh/quality/exempt_reason.h"
#include "triangulate/work_mesh/angle_history.h"
#include "triangulate/work_mesh/classified_mesh.h"
#include "triangulate/work_mesh/element_marks.h"
#include "triangulate/work_mesh/maxmin_swaps.h"

namespace mq::triangulate {

using Cause = mesh::ExemptCause;

struct Exemption {
    Cause cause = Cause::Fold;
    int vertex = -1;          ///< the vertex at the corner that causes it, or -1
    int edge = -1;            ///< the CAD edge that causes it, or -1
    std::uint32_t stamp = 0;  ///< version of the triangle when it was exempted
};

/// CAD faces that a piece of the mesh may lie on, each with an initial guess of (u, v) if there is one.
struct CandidateFaces {
    std::vector<int> faces;                    ///< ascending
    std::vector<std::optional<Vec2>> guesses;  ///< one for each face
};

/// A triangle that may lie on more than one CAD face.
struct MultiFaceClassification {
    std::vector<int> faces;  ///< the faces that it lies on, the one with the largest share first
    CandidateFaces sheets;   ///< all faces near it
};

/// The data shared by the algorithms while they work on one shape.
struct Workspace {
    geometry::Session& session;
    const SinglePrecisionGrid& grid;
    ClassifiedMesh& mesh;
    MaxMinSwaps& maxmin;
    Progress& progress;
    double floor = 0.0;                                            ///< least distance between neighbouring vertices, mm
    double min_edge = 0.0;                                         ///< TriangulateOptions::min_edge, mm; 0: none
    std::size_t budget = std::numeric_limits<std::size_t>::max();  ///< largest number of triangles
    std::vector<std::uint8_t> shrinks{};  ///< by vertex: insertions in its ancestry that made edges shorter
    std::map<int, Exemption> exempt{};    ///< by triangle
    std::map<int, MultiFaceClassification> spanning{};  ///< by triangle; only after smooth edges were removed
    TriangleMarks settled{};  ///< triangles from an earlier run, with good angles or exempt in that run
    geometry::CadSamples span_points{session, grid};
    /// By CAD edge: radius around each of its ends, mm, within which no vertices are placed on it (see
    /// unresolved_ends); empty: none.
    std::vector<std::array<double, 2>> unresolved{};
    double unseen = 0.0;              ///< mm: normals that turn within a smaller length need not be resolved
    std::size_t left_by_mending = 0;  ///< triangles below the bound when the attempts of mending were used up
    bool refused = false;             ///< whether the budget has refused triangles
    AngleHistory angle_history{};

    std::size_t triangles() const { return static_cast<std::size_t>(mesh.used_triangle_count()); }
    /// Whether the budget has room for that number of further triangles. To be asked before any are added: the first
    /// refusal ends the work, so that the mesh never has more triangles than the budget, or than it began with.
    bool check_budget(std::size_t more) {
        refused = refused || triangles() + more > budget;
        return !refused;
    }
    /// Whether the budget ended the work.
    bool over_budget() const { return refused || triangles() > budget; }
    double shortest_allowed() const { return min_edge > floor ? min_edge : floor; }
    /// Returns the exemption of the triangle in its present state; null: there is none.
    const Exemption* exemption_of(int triangle) const {
        const auto found = exempt.find(triangle);
        return found != exempt.end() && found->second.stamp == mesh.stamp(triangle) ? &found->second : nullptr;
    }
    Cause too_short() const { return min_edge > floor ? Cause::MinEdge : Cause::Resolution; }
};

}  // namespace mq::triangulate
