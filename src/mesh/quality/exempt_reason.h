// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

#include "base/message.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// The cause for which a triangle keeps an angle below the bound. Named and worded in Mod/MeshQuality/phrases.py, in
/// this order.
enum class ExemptCause {
    NarrowCorner,      ///< the angle lies between two CAD edges that meet in its corner
    Apex,              ///< singular point of the surface with too little angle around it for three triangles
    NarrowCluster,     ///< splitting further would shrink edges towards a small input angle without terminating
    InfeasibleCorner,  ///< edges meet at an angle beside which no triangulation reaches the bound
    ToleranceCorner,   ///< a corner that is narrow only as the shape's tolerances do not tell its entities apart
    SharpEdges,        ///< the angle lies between two sharp edges of a mesh without CAD
    IdentifiedCorner,  ///< a corner that is narrow only as entities closer than the detail count as one
    Resolution,        ///< a further vertex would be closer to others than the resolution of single precision
    FaceFloorRaised,   ///< too many triangles of the face are exempt at the resolution, so that it is refined no finer
    MinEdge,           ///< a further vertex would make an edge shorter than min_edge
    Crowded,  ///< a further vertex would be closer to another one than the length of the triangle's shortest edge
    Fold,     ///< a further vertex would fold the mesh over the surface
    NoSurfacePoint,          ///< the engine finds no point of the surface there
    NoImprovingChange,       ///< no change of the triangles around it enlarges the angle within the bounds
    Budget,                  ///< max_triangles is reached
    NoChangeWithinTolerance  ///< the same for a mesh without CAD, which may not move farther than the tolerance
};

/// An entity of the CAD shape. Creases and their ends are no entities of the shape: they have the dimension of an edge
/// or a vertex, and the entity of the shape that they lie on.
struct NamedEntity {
    std::int32_t dimension = -1;      ///< -1: none
    VertexEntity of_shape{{-1, -1}};  ///< dimension and index

    bool operator==(const NamedEntity& other) const {
        return dimension == other.dimension && of_shape == other.of_shape;
    }
};

/// Why a triangle keeps an angle below the bound: the cause, and the entities and the angle of the shape that lead to
/// it, as far as it has any.
struct ExemptReason {
    ExemptCause cause = ExemptCause::Fold;
    double angle = -1.0;                  ///< degrees, of the corner that causes it; -1: none
    std::array<NamedEntity, 2> edges{};   ///< the edges that enclose that angle, or one edge where the triangle lies
    NamedEntity vertex{};                 ///< where the edges meet, or the singular point
    NamedEntity face{};                   ///< the face that the triangle lies on
    std::array<NamedEntity, 2> joined{};  ///< entities of the shape that count as one, if that makes the corner
    double apart = -1.0;                  ///< mm: how far apart these are at most; -1: none

    bool operator==(const ExemptReason& other) const {
        return cause == other.cause && angle == other.angle && edges == other.edges && vertex == other.vertex &&
               face == other.face && joined == other.joined && apart == other.apart;
    }
};

/// "Face3", "a crease of Face3".
Message name_of(const NamedEntity& entity);

/// The name of a cause, for scripts: "narrow_corner".
const char* name_of(ExemptCause cause);

/// Whether the shape itself is the reason.
bool is_forced(ExemptCause cause);

/// The reason in words: "points cannot be placed any closer in single precision at Edge4 on Face2".
Message message_of(const ExemptReason& reason);

}  // namespace mq::mesh
