// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/narrow/touching_edges.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/angle.h"
#include "geometry/occt/narrow/edge_joining.h"

namespace mq::geometry {

namespace {

class TouchingEdges : EdgeJoining {
  public:
    TouchingEdges(Topology& topology, ShapeMap& live, const Progress* progress)
        : EdgeJoining(topology, live), progress_(progress), solid_(topology.faces.size(), kNoSolid) {
        for (std::size_t v = 0; v < topology.volumes.size(); ++v) {
            for (const Volume::Side& side : topology.volumes[v].sides) {
                int& solid = solid_[static_cast<std::size_t>(side.face)];
                const bool only = solid == kNoSolid && topology.volumes[v].kind == Volume::Kind::Solid;
                solid = only ? static_cast<int>(v) : kSeveral;
            }
        }
    }

    void run() {
        std::vector<Place> places = places_of_edges();
        std::sort(places.begin(), places.end(),
                  [](const Place& a, const Place& b) { return a.middle.x() < b.middle.x(); });
        bool any = false;
        for (std::size_t i = 0; i < places.size(); ++i) {
            check_cancelled(progress_);
            for (std::size_t k = i + 1; k < places.size() && near(places[i], places[k], 0); ++k) {
                const auto [a, b] = std::minmax(places[i].edge, places[k].edge);
                if (near(places[i], places[k], 1) && near(places[i], places[k], 2) && touch(a, b) && join(a, b)) {
                    topology_.faults.push_back(topology_.name_of({1, a}) + " and " + topology_.name_of({1, b}) +
                                               " lie on each other, where the solid touches itself: they count as one");
                    any = true;
                }
            }
        }
        if (any) {
            rename_nodes();
        }
    }

  private:
    static constexpr int kNoSolid = -1;
    static constexpr int kSeveral = -2;

    struct Place {
        Vec3 middle;       // between the points of both nodes
        double tolerance;  // the largest one of nodes and edge, mm
        int edge;
    };

    static bool near(const Place& a, const Place& b, int axis) {
        return std::abs(a.middle[axis] - b.middle[axis]) <= a.tolerance + b.tolerance;
    }

    int solid_of(int e) const { return solid_[static_cast<std::size_t>(use_of(edge(e).uses.front()).face)]; }

    /// The edges between two faces of one solid.
    std::vector<Place> places_of_edges() const {
        std::vector<Place> result;
        for (int e = 0; e < static_cast<int>(topology_.edges.size()); ++e) {
            if (is_side(e) && parts_two_faces(edge(e).uses.front()) && solid_of(e) >= 0) {
                const Node& first = topology_.nodes[static_cast<std::size_t>(edge(e).nodes[0])];
                const Node& last = topology_.nodes[static_cast<std::size_t>(edge(e).nodes[1])];
                const double near = std::max({first.tolerance, last.tolerance, tolerance(e)});
                result.push_back({0.5 * (first.point + last.point), near, e});
            }
        }
        return result;
    }

    /// Whether two edges of one solid lie on each other, and all of their faces are others and lie apart.
    bool touch(int a, int b) const {
        if (!is_side(a) || !is_side(b) || solid_of(a) != solid_of(b)) {
            return false;  // one of them was joined with a third one
        }
        const double within = tolerance(a) + tolerance(b);
        if (!alignment(a, b, within) || !alignment(b, a, within)) {
            return false;
        }
        // Radians: least angle between two faces that do not lie on each other.
        constexpr double kLeastAngle = 2.0 * kDegree;
        for (const int first : edge(a).uses) {
            for (const int second : edge(b).uses) {
                const std::optional<double> angle = dihedral_angle(first, second);
                if (use_of(first).face == use_of(second).face || !angle || *angle < kLeastAngle) {
                    return false;
                }
            }
        }
        return true;
    }

    const Progress* progress_;
    std::vector<int> solid_;  // by face: its volume, if that is a solid, and its only one
};

}  // namespace

void join_touching_edges(Topology& topology, ShapeMap& live, const Progress* progress) {
    TouchingEdges(topology, live, progress).run();
}

}  // namespace mq::geometry
