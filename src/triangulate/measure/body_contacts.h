// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "triangulate/measure/self_intersections.h"

namespace mq::triangulate {

/// The relation in the shape between two bodies whose triangles cross, in ascending severity.
enum class BodyContact : std::uint8_t {
    Touching,     ///< their surfaces lie on each other, with the bodies on different sides; only chords cross
    Apart,        ///< there is a gap between them, which the chords close
    Overlapping,  ///< the bodies have a volume in common, or their surfaces cross
};

/// The crossing triangles of two faces of different bodies.
struct FaceContact {
    SelfIntersections::Faces faces;
    std::vector<std::array<int, 2>> pairs;
    std::map<std::pair<int, int>, BodyContact> contacts;  ///< by two volumes that the faces belong to, ascending
    /// The pairs that are apart in the shape, with the gaps between them, mm.
    std::vector<std::pair<std::array<int, 2>, double>> apart;

    BodyContact worst() const;
};

/// Finds the reason why triangles of different bodies cross, as chords of bodies that only touch cross, too.
/// At a place where two triangles cross, the nearest points of both faces are computed. If the faces are parallel there
/// and the bodies on different sides, the distance of the two points is the gap between the bodies, or the depth of
/// their overlap. If the faces meet at an angle, one triangle ends just behind the other one, or the bodies overlap. If
/// it ends at an edge of the shape, the distance of that edge from the other face is the gap. Two solids are said to
/// overlap only if a point is found that is in both.
class BodyContacts {
  public:
    BodyContacts(Workspace& work, SelfIntersections& finder);

    /// Examines the crossing triangles of each pair of faces; only a sample of them if they are many and only touch.
    /// Repeated only after the mesh or the deviation has changed.
    /// @param deviation  largest distance of the mesh from its faces, mm
    /// @throws Cancelled
    const std::vector<FaceContact>& find(double deviation);

  private:
    struct Owner {
        int volume;
        bool solid;
        double side;  ///< -1: the volume sees the face from its other side
    };
    /// Where two triangles cross.
    struct Place {
        Vec3 common;                 ///< in the shape's frame, as all points here
        std::array<Vec3, 2> points;  ///< the nearest points of the two faces
        std::array<Vec3, 2> normals;
        double depth = 0.0;   ///< mm, by which the triangles go through each other, or overlap in one plane
        int ends = 0;         ///< the triangle, 0 or 1, that ends first
        int segment = -1;     ///< the segment where it ends; -1: it ends at no edge of the shape
        double height = 0.0;  ///< mm: height of that edge over the other face
        bool found = false;
        bool deep = false;  ///< deeper than chords explain
    };
    /// The results of the places of two volumes.
    struct Evidence {
        BodyContact contact = BodyContact::Touching;
        std::vector<Vec3> common;  ///< points that may be in both
    };
    using Pairs = std::vector<std::array<int, 2>>;

    std::vector<Place> places_of(const Pairs& pairs, double deviation);
    Place place_of(const std::array<int, 2>& pair, double deviation) const;
    void find_heights(const Pairs& pairs, std::vector<Place>& places);
    double gap_at(const Place& place, const Owner& first, const Owner& second, double tolerance,
                  Evidence& evidence) const;
    void examine(FaceContact& contact, const Pairs& pairs, double deviation);
    void examine_all(double deviation);
    bool have_in_common(const std::pair<int, int>& volumes, const std::vector<Vec3>& points);

    Workspace& work_;
    SelfIntersections& finder_;
    std::vector<std::vector<Owner>> owners_;            // by face
    std::map<std::pair<int, int>, Evidence> evidence_;  // by volumes, ascending
    std::vector<FaceContact> found_;
    std::array<std::int64_t, 2> state_{-1, -1};  // edges made and triangles of the mesh when it was examined
    double deviation_ = -1.0;
};

}  // namespace mq::triangulate
