// SPDX-License-Identifier: LGPL-2.1-or-later
#include <set>
#include <utility>

#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "geometry/occt/live_shape.h"

namespace mq::geometry {

namespace {

const char* describe(BRepCheck_Status status) {
    switch (status) {
        case BRepCheck_NoError:
            return "no error";
        case BRepCheck_InvalidPointOnCurve:
            return "invalid point on curve";
        case BRepCheck_InvalidPointOnCurveOnSurface:
            return "invalid point on curve on surface";
        case BRepCheck_InvalidPointOnSurface:
            return "invalid point on surface";
        case BRepCheck_No3DCurve:
            return "no 3D curve";
        case BRepCheck_Multiple3DCurve:
            return "multiple 3D curves";
        case BRepCheck_Invalid3DCurve:
            return "invalid 3D curve";
        case BRepCheck_NoCurveOnSurface:
            return "no curve on surface";
        case BRepCheck_InvalidCurveOnSurface:
            return "invalid curve on surface";
        case BRepCheck_InvalidCurveOnClosedSurface:
            return "invalid curve on closed surface";
        case BRepCheck_InvalidSameRangeFlag:
            return "invalid same-range flag";
        case BRepCheck_InvalidSameParameterFlag:
            return "invalid same-parameter flag";
        case BRepCheck_InvalidDegeneratedFlag:
            return "invalid degenerated flag";
        case BRepCheck_FreeEdge:
            return "free edge";
        case BRepCheck_InvalidMultiConnexity:
            return "invalid multi-connexity";
        case BRepCheck_InvalidRange:
            return "invalid range";
        case BRepCheck_EmptyWire:
            return "empty wire";
        case BRepCheck_RedundantEdge:
            return "redundant edge";
        case BRepCheck_SelfIntersectingWire:
            return "self-intersecting wire";
        case BRepCheck_NoSurface:
            return "no surface";
        case BRepCheck_InvalidWire:
            return "invalid wire";
        case BRepCheck_RedundantWire:
            return "redundant wire";
        case BRepCheck_IntersectingWires:
            return "intersecting wires";
        case BRepCheck_InvalidImbricationOfWires:
            return "invalid imbrication of wires";
        case BRepCheck_EmptyShell:
            return "empty shell";
        case BRepCheck_RedundantFace:
            return "redundant face";
        case BRepCheck_InvalidImbricationOfShells:
            return "invalid imbrication of shells";
        case BRepCheck_UnorientableShape:
            return "unorientable shape";
        case BRepCheck_NotClosed:
            return "not closed";
        case BRepCheck_NotConnected:
            return "not connected";
        case BRepCheck_SubshapeNotInShape:
            return "sub-shape not in shape";
        case BRepCheck_BadOrientation:
            return "bad orientation";
        case BRepCheck_BadOrientationOfSubshape:
            return "bad orientation of a sub-shape";
        case BRepCheck_InvalidPolygonOnTriangulation:
            return "invalid polygon on triangulation";
        case BRepCheck_InvalidToleranceValue:
            return "invalid tolerance value";
        case BRepCheck_EnclosedRegion:
            return "enclosed region";
        case BRepCheck_CheckFail:
            return "the check failed";
    }
    return "unknown fault";
}

/// Collects the statuses of every sub-shape once. What is wrong with an edge on a face names both.
class FaultList {
  public:
    FaultList(const TopoDS_Shape& shape, const BRepCheck_Analyzer& analyzer) : analyzer_(analyzer) {
        const std::pair<TopAbs_ShapeEnum, const char*> kinds[] = {
            {TopAbs_VERTEX, "Vertex"}, {TopAbs_EDGE, "Edge"},   {TopAbs_WIRE, "Wire"},
            {TopAbs_FACE, "Face"},     {TopAbs_SHELL, "Shell"}, {TopAbs_SOLID, "Solid"}};
        for (const auto& [kind, name] : kinds) {
            kinds_.push_back(Kind{name, {}});
            TopExp::MapShapes(shape, kind, kinds_.back().map);
        }
    }

    std::vector<std::string> collect() {
        for (const Kind& kind : kinds_) {
            for (int i = 1; i <= kind.map.Extent(); ++i) {
                add(kind.map(i));
            }
        }
        return std::move(faults_);
    }

  private:
    struct Kind {
        const char* name;
        TopTools_IndexedMapOfShape map;
    };

    std::string name(const TopoDS_Shape& shape) const {
        for (const Kind& kind : kinds_) {
            if (const int index = kind.map.FindIndex(shape); index > 0) {
                return kind.name + std::to_string(index);
            }
        }
        return std::string();
    }

    void add(const TopoDS_Shape& shape) {
        const Handle(BRepCheck_Result)& result = analyzer_.Result(shape);
        if (result.IsNull()) {
            return;
        }
        add(result->Status(), name(shape));
        for (result->InitContextIterator(); result->MoreShapeInContext(); result->NextShapeInContext()) {
            const std::string context = name(result->ContextualShape());
            if (!result->ContextualShape().IsSame(shape)) {
                add(result->StatusOnShape(), name(shape) + (context.empty() ? "" : " in " + context));
            }
        }
    }

    void add(const BRepCheck_ListOfStatus& statuses, const std::string& whose) {
        for (const BRepCheck_Status status : statuses) {
            const std::string line = whose + ": " + describe(status);
            if (status != BRepCheck_NoError && seen_.insert(line).second) {
                faults_.push_back(line);
            }
        }
    }

    const BRepCheck_Analyzer& analyzer_;
    std::vector<Kind> kinds_;
    std::set<std::string> seen_;
    std::vector<std::string> faults_;
};

/// Solids whose faces look inward. The check of the shape takes them for holes in infinite space.
void add_inverted_solids(const LiveShape& live, const Topology& topology, std::vector<std::string>& faults) {
    for (std::size_t i = 0; i < live.volumes.size(); ++i) {
        if (topology.volumes[i].kind != Volume::Kind::Solid) {
            continue;
        }
        BRepClass3d_SolidClassifier classifier(live.volumes[i].Located(TopLoc_Location()));
        classifier.PerformInfinitePoint(Precision::Confusion());
        if (classifier.State() == TopAbs_IN) {
            faults.push_back("Solid" + std::to_string(i + 1) + ": is turned inside out");
        }
    }
}

}  // namespace

std::vector<std::string> kernel_faults(const TopoDS_Shape& shape, const LiveShape& live, const Topology& topology) {
    try {
        const BRepCheck_Analyzer analyzer(shape);
        std::vector<std::string> faults = FaultList(shape, analyzer).collect();
        add_inverted_solids(live, topology, faults);
        return faults;
    } catch (const Standard_Failure& failure) {
        const char* text = failure.GetMessageString();
        return {std::string("OpenCASCADE's check of the shape ended with an exception: ") +
                (text != nullptr && *text != '\0' ? text : failure.DynamicType()->Name())};
    }
}

}  // namespace mq::geometry
