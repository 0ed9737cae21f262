// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>

#include "geometry/occt/conversion.h"
#include "geometry/occt/live_shape.h"

namespace mq::geometry {

namespace {

Box to_box(const Bnd_Box& bounds) {
    Box box;
    if (!bounds.IsVoid()) {
        box.add(to_vec(bounds.CornerMin()));
        box.add(to_vec(bounds.CornerMax()));
    }
    return box;
}

/// Of some points of the part.
Box inner_box(const LiveShape& live, const Topology& topology, const Progress* progress) {
    constexpr int kPoints = 16;
    Box box;
    Pace pace(progress);
    for (std::size_t i = 0; i < live.edges.size(); ++i) {
        pace.step();
        const Edge& edge = topology.edges[i];
        if (edge.degenerate) {
            continue;
        }
        const BRepAdaptor_Curve curve(live.edges[i]);
        for (int k = 0; k <= kPoints; ++k) {
            box.add(to_vec(curve.Value(edge.t0 + k * (edge.t1 - edge.t0) / kPoints)));
        }
    }
    return box;
}

bool much_larger(const Box& box, const Box& inner) {
    constexpr double kMuch = 1e-3;
    return inner.empty() || ((box.high - box.low) - (inner.high - inner.low)).maxCoeff() > kMuch * inner.largest_side();
}

bool may_reach_beyond(const Box& box, const TopoDS_Face& face) {
    Bnd_Box quick;
    BRepBndLib::Add(face, quick, Standard_False);
    if (quick.IsVoid()) {
        return false;
    }
    const Box around = to_box(quick);
    return box.empty() || (around.low.array() < box.low.array()).any() ||
           (around.high.array() > box.high.array()).any();
}

}  // namespace

/// The quick box is that of the poles and can be several times too large; the close one takes up to a second for a
/// part of many free-form faces, and is only looked for where the quick one is loose, of faces that may reach farther
/// than the edges do.
Box bounding_box(const TopoDS_Shape& shape, const LiveShape& live, const Topology& topology, const Progress* progress) {
    // The close box is right to a part of its size, not to the last digit.
    constexpr double kMargin = 1e-6;
    Bnd_Box quick;
    BRepBndLib::Add(shape, quick, Standard_False);
    Box box = to_box(quick);
    const Box inner = inner_box(live, topology, progress);
    if (!quick.IsVoid() && much_larger(box, inner)) {
        Bnd_Box close;
        for (const TopoDS_Face& face : live.faces) {
            look_for_cancel(progress);
            if (may_reach_beyond(inner, face)) {
                BRepBndLib::AddOptimal(face, close, Standard_False, Standard_False);
            }
        }
        Box near = to_box(close);
        if (!inner.empty()) {
            near.add(inner.low);
            near.add(inner.high);
        }
        box = near.empty() ? box : near;
        const Vec3 margin = Vec3::Constant(kMargin * box.largest_side());
        box.low -= margin;
        box.high += margin;
    }
    if (!inner.empty()) {
        box.add(inner.low);
        box.add(inner.high);
    }
    return box;
}

}  // namespace mq::geometry
