// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/checks/linear_time_checks.h"

#include <BRepCheck_Edge.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Vertex.hxx>
#include <BRepCheck_Wire.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>

namespace mq::geometry {

namespace {

/// A face with the same surface and only one wire or edge: OpenCASCADE searches all edges of the face that is the
/// context of a check.
TopoDS_Face bare_face(const TopoDS_Face& face, const TopoDS_Shape& wire) {
    TopoDS_Face bare = TopoDS::Face(face.EmptyCopied());
    BRep_Builder().Add(bare, wire);
    return bare;
}

TopoDS_Face bare_face(const TopoDS_Face& face, const TopoDS_Edge& edge) {
    TopoDS_Wire wire;
    BRep_Builder builder;
    builder.MakeWire(wire);
    builder.Add(wire, edge);
    return bare_face(face, wire);
}

class LargeFace {
  public:
    LargeFace(const TopoDS_Face& face, const Progress* progress)
        : face_(TopoDS::Face(face.Oriented(TopAbs_FORWARD))), progress_(progress) {}

    std::vector<Finding> check() {
        for (TopExp_Explorer wires(face_, TopAbs_WIRE); wires.More(); wires.Next()) {
            for (TopExp_Explorer edges(wires.Current(), TopAbs_EDGE); edges.More(); edges.Next()) {
                check_cancelled(progress_);
                if (seen_.FindIndex(edges.Current()) == 0) {
                    seen_.Add(edges.Current());
                    check_edge(TopoDS::Edge(edges.Current()));
                }
            }
        }
        // A wire whose edges have faults gives no further finding.
        for (TopExp_Explorer wires(face_, TopAbs_WIRE); found_.empty() && wires.More(); wires.Next()) {
            check_cancelled(progress_);
            check_wire(TopoDS::Wire(wires.Current()));
        }
        return std::move(found_);
    }

  private:
    void check_edge(const TopoDS_Edge& edge) {
        const TopoDS_Face bare = bare_face(face_, edge);
        const Handle(BRepCheck_Edge) result = new BRepCheck_Edge(edge);
        result->InContext(bare);
        add(edge, result, bare, face_);
        for (TopExp_Explorer ends(edge, TopAbs_VERTEX); ends.More(); ends.Next()) {
            const TopoDS_Vertex vertex = TopoDS::Vertex(ends.Current());
            const Handle(BRepCheck_Vertex) end = new BRepCheck_Vertex(vertex);
            end->InContext(edge);
            end->InContext(bare);
            add(vertex, end, edge, edge);
            add(vertex, end, bare, face_);
        }
    }

    void check_wire(const TopoDS_Wire& wire) {
        const TopoDS_Face bare = bare_face(face_, wire);
        const Handle(BRepCheck_Wire) result = new BRepCheck_Wire(wire);
        for (const BRepCheck_Status status : {result->Closed(), result->Closed2d(bare), result->Orientation(bare)}) {
            add(wire, status, face_);
        }
    }

    void add(const TopoDS_Shape& whose, BRepCheck_Status status, const TopoDS_Shape& context) {
        if (status != BRepCheck_NoError) {
            found_.push_back({whose, context, status});
        }
    }

    void add(const TopoDS_Shape& whose, const Handle(BRepCheck_Result) & result, const TopoDS_Shape& context,
             const TopoDS_Shape& named) {
        for (const BRepCheck_Status status : result->Status()) {
            add(whose, status, TopoDS_Shape());
        }
        for (const BRepCheck_Status status : result->StatusOnShape(context)) {
            add(whose, status, named);
        }
    }

    TopoDS_Face face_;
    const Progress* progress_;
    TopTools_IndexedMapOfShape seen_;
    std::vector<Finding> found_;
};

}  // namespace

std::vector<Finding> check_large_face(const TopoDS_Face& face, const Progress* progress) {
    return LargeFace(face, progress).check();
}

std::vector<Finding> check_large_shell(const TopoDS_Shell& shell, const Progress* progress) {
    TopTools_IndexedMapOfShape edges;
    std::vector<std::array<int, 2>> uses;  // for each edge the number of its uses, forward and reversed
    CancelPace pace(progress);
    for (TopExp_Explorer each(shell, TopAbs_EDGE); each.More(); each.Next()) {
        pace.step();
        const TopoDS_Edge edge = TopoDS::Edge(each.Current());
        const bool forward = edge.Orientation() == TopAbs_FORWARD;
        if ((forward || edge.Orientation() == TopAbs_REVERSED) && !BRep_Tool::Degenerated(edge)) {
            const auto i = static_cast<std::size_t>(edges.Add(edge) - 1);
            uses.resize(std::max(uses.size(), i + 1), {0, 0});
            ++uses[i][forward ? 0 : 1];
        }
    }
    std::vector<Finding> found;
    if (std::any_of(uses.begin(), uses.end(), [](const auto& use) { return use[0] + use[1] == 1; })) {
        found.push_back({shell, TopoDS_Shape(), BRepCheck_NotClosed});
    }
    if (std::any_of(uses.begin(), uses.end(), [](const auto& use) { return use[0] + use[1] == 2 && use[0] != 1; })) {
        found.push_back({shell, TopoDS_Shape(), BRepCheck_BadOrientationOfSubshape});
    }
    return found;
}

}  // namespace mq::geometry
