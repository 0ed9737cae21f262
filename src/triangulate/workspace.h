// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/single_grid.h"
#include "geometry/session.h"
#include "mesh/surface_mesh.h"
#include "triangulate/maxmin.h"
#include "triangulate/span_points.h"
#include "triangulate/triangle_marks.h"

namespace mq::triangulate {

/// Why a triangle keeps an angle below the bound.
enum class Cause {
    NarrowCorner,    ///< the angle lies between two CAD edges that meet in its corner
    Apex,            ///< the surface comes to a point there, with too little angle around it for three triangles
    NarrowCluster,   ///< splitting further would shrink edges towards a narrow corner for ever
    Resolution,      ///< a further vertex would lie closer than single precision tells apart
    Abandoned,       ///< so much of the face was given up for want of room that it is refined no finer
    MinEdge,         ///< a further vertex would make an edge shorter than min_edge
    Crowded,         ///< a further vertex would lie closer to another one than the triangle's shortest edge
    Fold,            ///< a further vertex would fold the mesh over the surface
    NoSurfacePoint,  ///< the engine finds no point of the surface there
    Budget,          ///< max_triangles is reached
    Stuck,           ///< no change of the triangles around makes the angle larger within the bounds
};

struct Exemption {
    Cause cause = Cause::Fold;
    int vertex = -1;          ///< the corner at fault, or -1
    int segment = -1;         ///< the segment at fault, or -1
    std::uint32_t stamp = 0;  ///< of the triangle when it was exempted
};

/// CAD faces that a piece of the mesh may lie on, with a guess of (u, v) for each where there is one.
struct Sheets {
    std::vector<int> faces;                    ///< ascending
    std::vector<std::optional<Vec2>> guesses;  ///< one a face
};

/// A triangle that may lie on more than one CAD face.
struct Span {
    std::vector<int> faces;  ///< that it lies on, the one with the largest share first
    Sheets sheets;           ///< all that are near it
};

/// What the algorithms share while they work on one part.
struct Workspace {
    geometry::Session& session;
    const SingleGrid& grid;
    mesh::SurfaceMesh& mesh;
    Maxmin& maxmin;
    Progress& progress;
    double floor = 0.0;                   ///< no two neighbours closer than this, mm
    double min_edge = 0.0;                ///< as asked; 0: none
    std::size_t budget = 0;               ///< triangles
    std::vector<std::uint8_t> shrinks{};  ///< per vertex: insertions in its ancestry that made edges shorter
    std::map<int, Exemption> exempt{};    ///< by triangle
    std::map<int, Span> spanning{};       ///< by triangle; only after relics were released
    TriangleMarks settled{};              ///< those that came from an earlier run, with good angles
    SpanPoints span_points{session, grid};
    double unseen = 0.0;  ///< a surface that turns within this need not be followed, mm

    bool over_budget() const { return static_cast<std::size_t>(mesh.triangle_count()) >= budget; }
    double shortest_allowed() const { return min_edge > floor ? min_edge : floor; }
    /// Why the triangle as it is was given up; null: it was not.
    const Exemption* exemption_of(int triangle) const {
        const auto found = exempt.find(triangle);
        return found != exempt.end() && found->second.stamp == mesh.stamp(triangle) ? &found->second : nullptr;
    }
    Cause too_short() const { return min_edge > floor ? Cause::MinEdge : Cause::Resolution; }
};

}  // namespace mq::triangulate
