// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "triangulate/cavity.h"
#include "triangulate/corner_room.h"
#include "triangulate/face_floors.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// Splits a segment at a point of its curve, and the triangles beside it. `on_faces[k]` is the point as use k sees it.
/// @return the halves of these triangles. The new segment is the mesh's last.
std::vector<int> split_at(Workspace& work, int segment, double t, const Vec3& point, const geometry::Answer* on_faces);

/// Splits constraining edges on their CAD curves: in the middle by arc length, and near a CAD node with an acute
/// corner on concentric shells, at power-of-two multiples of the innermost (Ruppert 1995, modified segment splitting).
/// On shells the pieces at one narrow corner get equal lengths, and equal pieces at less than 60 degrees do not
/// encroach on each other.
class SegmentSplitter {
  public:
    /// Before anything was refined: measures how much room there is around every CAD node. With `guard_apexes` seams
    /// that end in a guarded apex are not split for the sake of angles (see ApexRings).
    explicit SegmentSplitter(Workspace& work, bool guard_apexes = true);

    /// Φ_encroached for the apexes of the triangles beside the segment.
    bool encroached(int segment) const;
    /// The innermost piece of a CAD edge at a narrow corner is not split any more once it is short against everything
    /// else around the corner. Pieces on one shell could go on to encroach on each other through their neighbours for
    /// ever (the cascade that Shewchuk 2002 calls the terminator's problem); an innermost shell ends it, and leaves one
    /// triangle in the corner with the angle that the part has there. `corner_vertex` is the corner's node.
    bool frozen(int segment, int* corner_vertex = nullptr) const;
    /// The CAD node with a narrow corner whose innermost shell p lies within or beside, as a vertex; -1: none.
    int narrow_corner_near(const Vec3& p) const;
    /// p lies so near the segment that its angle over it is above 120 degrees.
    bool in_lens(int segment, const Vec3& p) const;

    /// With `force` also when it is frozen: for bounds on lengths and chord heights, which end by themselves. The other
    /// edge of its narrow corner follows to the same shell.
    void request(int segment, bool force = false);
    /// With force, and not in its middle but at this distance (mm) from one of its ends. That this fails says nothing
    /// about other places.
    void request_at(int segment, int end, double distance);
    /// Splits all that were requested and all that become encroached by it, in batches. Changed triangles are
    /// appended to `touched`.
    void run(std::vector<int>& touched);
    /// Where `min_edge` alone forbade it, no longer than that is in force.
    bool refused(int segment) const;
    /// Whether triangles around the origin of `h` are for ApexRings alone to change.
    bool guards(int h) const;
    /// The vertex is an apex where rings do not help.
    void free_apex(int vertex) { free_apexes_.insert(vertex); }
    bool is_free(int vertex) const { return free_apexes_.count(vertex) > 0; }
    /// Why it may not be split for the sake of angles; nothing: it may.
    std::optional<Cause> obstacle(int segment) const;
    /// For the sake of angles.
    bool may_split(int segment) const;
    FaceFloors& floors() { return floors_; }
    bool idle() const { return pending_.empty(); }

  private:
    struct Shell {
        int end = -1;  ///< the end at whose node the shell is centred, -1: none
        double radius = 0.0;
    };
    Shell shell_of(int segment) const;
    double chord(int segment) const;
    geometry::Query place_query(int segment) const;
    void split_batch(const std::vector<int>& segments, std::vector<int>& touched);
    enum class Outcome { Split, TooShort, NoPoint, Folds, Later };
    Cavity cavity_for(int half_edge, const Vec3& point, geometry::Answer& on_face) const;
    Outcome split(int segment, const geometry::Answer& place, geometry::Answer* on_faces, std::vector<int>& touched);
    bool on_curve(int segment, const geometry::Answer& place) const;
    bool far_enough(int segment, const Vec3& point) const;
    Outcome wait_for(int segment, int other);
    void insert(int segment, double t, const Vec3& point, const geometry::Answer* on_faces,
                const std::vector<Cavity>& cavities, std::vector<int>& touched);
    void request_encroached_around(const std::vector<int>& triangles);

    void force_mates(int segment);

    Workspace& work_;
    FaceFloors floors_;
    bool guard_apexes_;
    std::set<int> free_apexes_;
    CornerRoom room_;  // as it was before anything was refined
    std::vector<int> pending_;
    std::vector<char> waiting_;   // per segment
    std::map<int, Shell> asked_;  // by segment, until it is split
    std::map<int, Cause> refusals_;
    std::map<int, int> postponed_;  // how often a segment had to wait for another
};

}  // namespace mq::triangulate
