// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <algorithm>

#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/face_evaluator.h"
#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

namespace {

/// Extends the box by the peaks of a curve's coordinates: the surroundings of samples that are higher than their
/// neighbours are searched where they may exceed the box.
class CurveReach {
  public:
    CurveReach(const BRepAdaptor_Curve& curve, double first, double last) : curve_(curve), first_(first) {
        // Samples of a curve at least.
        constexpr int kLeastSamples = 16;
        // Samples of a curve at most; bounds the time.
        constexpr int kMostSamples = 200;
        const int spans = curve.GetType() == GeomAbs_BSplineCurve ? 3 * curve.NbKnots() : 0;
        const int count = std::clamp(spans, kLeastSamples, kMostSamples);
        step_ = (last - first) / count;
        for (int k = 0; k <= count; ++k) {
            points_.push_back(to_vec(curve.Value(first + k * step_)));
        }
    }

    void add_to(Box& box) const {
        for (const Vec3& p : points_) {
            box.add(p);
        }
        for (std::size_t k = 0; k < points_.size() && curve_.GetType() != GeomAbs_Line; ++k) {
            for (int way = 0; way < 6; ++way) {
                search_at(k, way / 2, way % 2 == 0 ? 1.0 : -1.0, box);
            }
        }
    }

  private:
    void search_at(std::size_t k, int axis, double sign, Box& box) const {
        const auto at = [&](std::size_t i) { return sign * points_[i][axis]; };
        const double bound = sign > 0.0 ? box.high[axis] : -box.low[axis];
        if ((k > 0 && at(k) < at(k - 1)) || (k + 1 < points_.size() && at(k) < at(k + 1))) {
            return;
        }
        const std::size_t inner = std::clamp<std::size_t>(k, 1, points_.size() - 2);
        if (at(k) + rise_over_sample(at(inner - 1), at(inner), at(inner + 1)) <= bound) {
            return;
        }
        // Relative step at which the search ends: the remaining error is of the order of its square.
        constexpr double kEnd = 1e-3;
        // Steps at most, so that the search ends on degenerate curves.
        constexpr int kPatternSteps = 200;
        const double last = first_ + (static_cast<double>(points_.size()) - 1.0) * step_;
        double t = first_ + static_cast<double>(k) * step_;
        Vec3 best = points_[k];
        double part = 0.5;
        for (int step = 0; step < kPatternSteps && part > kEnd; ++step) {
            bool better = false;
            for (const double next : {t - part * step_, t + part * step_}) {
                const Vec3 p = to_vec(curve_.Value(std::clamp(next, first_, last)));
                if (sign * p[axis] > sign * best[axis]) {
                    best = p;
                    t = std::clamp(next, first_, last);
                    better = true;
                }
            }
            part *= better ? 1.0 : 0.5;
        }
        box.add(best);
    }

    const BRepAdaptor_Curve& curve_;
    double first_;
    double step_;
    std::vector<Vec3> points_;
};

Box box_of_edges(const ShapeMap& live, const Topology& topology, const Progress* progress) {
    Box box;
    for (std::size_t i = 0; i < live.edges.size(); ++i) {
        check_cancelled(progress);
        const Edge& edge = topology.edges[i];
        if (!edge.degenerate && !edge.uses.empty()) {
            const BRepAdaptor_Curve curve(live.edges[i]);
            CurveReach(curve, edge.t0, edge.t1).add_to(box);
        }
    }
    return box;
}

/// The quick boxes of faces, each made once.
class QuickBoxes {
  public:
    const Bnd_Box& of(const TopoDS_Shape& face) {
        if (const Bnd_Box* known = boxes_.Seek(face)) {
            return *known;
        }
        Bnd_Box box;
        BRepBndLib::Add(face, box, Standard_False);
        return *boxes_.Bound(face, box);
    }

  private:
    NCollection_DataMap<TopoDS_Shape, Bnd_Box, TopTools_ShapeMapHasher> boxes_;
};

/// BRepBndLib::Add of all faces, with a look for a cancellation at each. Edges and vertices of no face are left out: no
/// mesh has them, and the box would not be that of what is meshed.
Bnd_Box quick_bounds(const TopoDS_Shape& shape, QuickBoxes& boxes, const Progress* progress) {
    Bnd_Box bounds;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        check_cancelled(progress);
        bounds.Add(boxes.of(faces.Current()));
    }
    return bounds;
}

bool much_larger(const Box& box, const Box& inner) {
    // Relative excess of the quick box above which the close box is computed.
    constexpr double kMuch = 1e-3;
    return inner.empty() || ((box.high - box.low) - (inner.high - inner.low)).maxCoeff() > kMuch * inner.largest_side();
}

bool may_reach_beyond(const Box& box, const Bnd_Box& quick) {
    if (quick.IsVoid()) {
        return false;
    }
    const Box around = to_box(quick);
    return box.empty() || (around.low.array() < box.low.array()).any() ||
           (around.high.array() > box.high.array()).any();
}

}  // namespace

/// The quick box contains the poles of curves and surfaces and can be several times too large. If it is, the close box
/// is computed from the edges, and from the faces that may exceed the box of the edges.
Box bounding_box(const TopoDS_Shape& shape, const ShapeMap& live, const Topology& topology,
                 const std::function<FaceEvaluator&(int)>& face, const Progress* progress) {
    // Margin of the close box, as a fraction of its size: it is not exact to the last digit.
    constexpr double kMargin = 1e-6;
    QuickBoxes boxes;
    const Bnd_Box quick = quick_bounds(shape, boxes, progress);
    Box box = to_box(quick);
    const Box inner = box_of_edges(live, topology, progress);
    if (!quick.IsVoid() && !quick.IsOpen() && much_larger(box, inner)) {
        Box close = inner;
        for (std::size_t i = 0; i < live.faces.size(); ++i) {
            check_cancelled(progress);
            if (!topology.faces[i].no_area && may_reach_beyond(close, boxes.of(live.faces[i]))) {
                face(static_cast<int>(i)).add_to(close);
            }
        }
        box = close.empty() ? box : close;
        const Vec3 margin = Vec3::Constant(kMargin * box.largest_side());
        box.low -= margin;
        box.high += margin;
    }
    box.add(inner);
    return box;
}

}  // namespace mq::geometry
