// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/face_orientation.h"

#include <BRepBndLib.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cstddef>

#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/edge_evaluator.h"

namespace mq::geometry {

namespace {

class FaceOrientation {
  public:
    FaceOrientation(Topology& topology, const ShapeMap& live, const std::vector<char>& loose, const Progress* progress)
        : topology_(topology), live_(live), loose_(loose), turned_(topology.faces.size(), -1), progress_(progress) {}

    std::vector<int> run() {
        std::vector<Set> sets;
        for (int f = 0; f < static_cast<int>(topology_.faces.size()); ++f) {
            if (loose_[static_cast<std::size_t>(f)] != 0 && turned_[static_cast<std::size_t>(f)] < 0) {
                sets.push_back(connected_to(f));
            }
        }
        sets.erase(std::remove_if(sets.begin(), sets.end(), [](const Set& set) { return set.faces.size() < 2; }),
                   sets.end());
        for (Set& set : sets) {
            measure(set);
        }
        std::vector<int> result;
        for (const Set& set : sets) {
            const int turn = side_to_turn(set, sets);
            for (const int f : set.faces) {
                if (turned_[static_cast<std::size_t>(f)] == turn) {
                    result.push_back(f);
                }
            }
        }
        for (const int f : result) {
            Face& face = topology_.faces[static_cast<std::size_t>(f)];
            face.reversed = !face.reversed;
        }
        return result;
    }

  private:
    struct Set {
        std::vector<int> faces;
        int edge = -1;  ///< an edge that two of the faces share
        bool closed = true;
        /// Whether the faces of a closed set look outward after those with 1 in `turned_` are reversed.
        bool outward = false;
        Bnd_Box box;
    };

    /// The faces that share edges with `face`, directly or through others. Sets `turned_` to 0 or 1: faces with
    /// different
    /// values must not both be reversed, nor both stay.
    Set connected_to(int face) {
        Set set;
        set.faces.push_back(face);
        turned_[static_cast<std::size_t>(face)] = 0;
        for (std::size_t i = 0; i < set.faces.size(); ++i) {
            for (const Loop& loop : topology_.faces[static_cast<std::size_t>(set.faces[i])].loops) {
                for (const int use : loop.uses) {
                    add_neighbour(use, set);
                }
            }
        }
        return set;
    }

    void add_neighbour(int use, Set& set) {
        const EdgeUse& own = topology_.uses[static_cast<std::size_t>(use)];
        const Edge& edge = topology_.edges[static_cast<std::size_t>(own.edge)];
        if (edge.degenerate || own.internal) {
            return;
        }
        if (edge.uses.size() != 2) {
            set.closed = false;
            return;
        }
        const EdgeUse& other =
            topology_.uses[static_cast<std::size_t>(edge.uses[0] == use ? edge.uses[1] : edge.uses[0])];
        const auto f = static_cast<std::size_t>(other.face);
        if (loose_[f] == 0 || turned_[f] >= 0) {
            return;
        }
        const auto runs = [&](const EdgeUse& u) {
            return u.forward != topology_.faces[static_cast<std::size_t>(u.face)].reversed;
        };
        const int as_own = turned_[static_cast<std::size_t>(own.face)];
        turned_[f] = runs(own) == runs(other) ? 1 - as_own : as_own;
        set.edge = own.edge;
        set.faces.push_back(other.face);
    }

    /// 0 or 1: the faces with this value in `turned_` have to be reversed.
    int side_to_turn(const Set& set, const std::vector<Set>& sets) {
        if (!set.closed) {
            const auto ones = std::count_if(set.faces.begin(), set.faces.end(),
                                            [&](int f) { return turned_[static_cast<std::size_t>(f)] == 1; });
            return 2 * static_cast<std::size_t>(ones) > set.faces.size() ? 0 : 1;
        }
        const auto around = std::count_if(sets.begin(), sets.end(), [&](const Set& other) {
            return &other != &set && other.closed && is_inside(set, other);
        });
        return set.outward == (around % 2 == 0) ? 1 : 0;
    }

    bool reversed_if_ones_turn(std::size_t face) const {
        return topology_.faces[face].reversed != (turned_[face] == 1);
    }

    void measure(Set& set) const {
        for (const int f : set.faces) {
            check_cancelled(progress_);
            BRepBndLib::Add(live_.faces[static_cast<std::size_t>(f)], set.box);
        }
        if (set.closed) {
            set.outward = volume(set) > 0.0;
        }
    }

    /// mm^3: volume of a closed set after its faces with 1 in `turned_` are reversed; negative: it is inside out.
    double volume(const Set& set) const {
        double sum = 0.0;
        for (const int f : set.faces) {
            check_cancelled(progress_);
            const auto i = static_cast<std::size_t>(f);
            BRepGProp_Face surface(live_.faces[i]);
            BRepGProp_Domain domain(live_.faces[i]);
            const double of_face = BRepGProp_Vinert(surface, domain, to_pnt(topology_.box.low)).Mass();
            sum += reversed_if_ones_turn(i) ? -of_face : of_face;
        }
        return sum;
    }

    /// The faces of a closed set as a solid. Those with 1 in `turned_` are reversed or, with `others`, those with 0.
    TopoDS_Solid solid_of(const Set& set, bool others) const {
        const BRep_Builder builder;
        TopoDS_Shell shell;
        builder.MakeShell(shell);
        for (const int f : set.faces) {
            const auto i = static_cast<std::size_t>(f);
            const bool reversed = reversed_if_ones_turn(i) != others;
            builder.Add(shell, live_.faces[i].Oriented(reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
        }
        TopoDS_Solid solid;
        builder.MakeSolid(solid);
        builder.Add(solid, shell);
        return solid;
    }

    /// Whether a point of one set lies inside another, closed one.
    bool is_inside(const Set& set, const Set& other) const {
        check_cancelled(progress_);
        const Edge& edge = topology_.edges[static_cast<std::size_t>(set.edge)];
        const EdgeEvaluator curve(live_.edges[static_cast<std::size_t>(set.edge)], edge);
        const gp_Pnt point = to_pnt(curve.point(edge.t0).point);
        if (other.box.IsOut(point)) {
            return false;
        }
        BRepClass3d_SolidClassifier classifier(solid_of(other, !other.outward));
        classifier.Perform(point, Precision::Confusion());
        return classifier.State() == TopAbs_IN;
    }

    Topology& topology_;
    const ShapeMap& live_;
    const std::vector<char>& loose_;
    std::vector<int> turned_;  // by face; -1: in no set yet
    const Progress* progress_;
};

}  // namespace

std::vector<int> orient_loose_faces(Topology& topology, const ShapeMap& live, const std::vector<char>& loose,
                                    const Progress* progress) {
    return FaceOrientation(topology, live, loose, progress).run();
}

}  // namespace mq::geometry
