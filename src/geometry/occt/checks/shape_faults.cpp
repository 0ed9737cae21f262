// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <BRepCheck_Shell.hxx>
#include <BRepCheck_Solid.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <gp_Trsf.hxx>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "base/waits.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/checks/linear_time_checks.h"
#include "geometry/occt/checks/valid_face.h"
#include "geometry/occt/evaluation/conversion.h"
#include "geometry/occt/evaluation/failure_text.h"
#include "geometry/occt/evaluation/inside_out.h"
#include "geometry/occt/topology/shape_map.h"
#include "geometry/occt/topology/sub_shapes.h"

namespace mq::geometry {

namespace {

/// The description of a status, as in FreeCAD's check of a geometry.
struct Wording {
    BRepCheck_Status status;
    const char* text;
};
/// The descriptions of all statuses.
constexpr Wording kWordings[] = {
    {BRepCheck_InvalidPointOnCurve, "invalid point on curve"},
    {BRepCheck_InvalidPointOnCurveOnSurface, "invalid point on curve on surface"},
    {BRepCheck_InvalidPointOnSurface, "invalid point on surface"},
    {BRepCheck_No3DCurve, "no 3D curve"},
    {BRepCheck_Multiple3DCurve, "multiple 3D curves"},
    {BRepCheck_Invalid3DCurve, "invalid 3D curve"},
    {BRepCheck_NoCurveOnSurface, "no curve on surface"},
    {BRepCheck_InvalidCurveOnSurface, "invalid curve on surface"},
    {BRepCheck_InvalidCurveOnClosedSurface, "invalid curve on closed surface"},
    {BRepCheck_InvalidSameRangeFlag, "invalid same-range flag"},
    {BRepCheck_InvalidSameParameterFlag, "invalid same-parameter flag"},
    {BRepCheck_InvalidDegeneratedFlag, "invalid degenerated flag"},
    {BRepCheck_FreeEdge, "free edge"},
    {BRepCheck_InvalidMultiConnexity, "invalid multi-connexity"},
    {BRepCheck_InvalidRange, "invalid range"},
    {BRepCheck_EmptyWire, "empty wire"},
    {BRepCheck_RedundantEdge, "redundant edge"},
    {BRepCheck_SelfIntersectingWire, "self-intersecting wire"},
    {BRepCheck_NoSurface, "no surface"},
    {BRepCheck_InvalidWire, "invalid wire"},
    {BRepCheck_RedundantWire, "redundant wire"},
    {BRepCheck_IntersectingWires, "intersecting wires"},
    {BRepCheck_InvalidImbricationOfWires, "invalid imbrication of wires"},
    {BRepCheck_EmptyShell, "empty shell"},
    {BRepCheck_RedundantFace, "redundant face"},
    {BRepCheck_InvalidImbricationOfShells, "invalid imbrication of shells"},
    {BRepCheck_UnorientableShape, "unorientable shape"},
    {BRepCheck_NotClosed, "not closed"},
    {BRepCheck_NotConnected, "not connected"},
    {BRepCheck_SubshapeNotInShape, "sub-shape not in shape"},
    {BRepCheck_BadOrientation, "bad orientation"},
    {BRepCheck_BadOrientationOfSubshape, "bad orientation of a sub-shape"},
    {BRepCheck_InvalidToleranceValue, "invalid tolerance value"},
    {BRepCheck_EnclosedRegion, "enclosed region"},
    {BRepCheck_CheckFail, "the check failed"},
};

const char* describe(BRepCheck_Status status) {
    for (const Wording& wording : kWordings) {
        if (wording.status == status) {
            return wording.text;
        }
    }
    return "unknown fault";
}

// Edges of a face, and faces of a shell, up to which OpenCASCADE checks them at once: no longer than a watcher waits
// for an answer.
constexpr int kMostAtOnce = 512;

bool more_than(int count, const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    TopExp_Explorer parts(shape, kind);
    while (parts.More() && count >= 0) {
        parts.Next();
        --count;
    }
    return count < 0;
}

/// Collects the statuses of every sub-shape once. A fault of an edge on a face names both.
///
/// The faces are checked one by one: the check of a whole shape cannot be cancelled, and takes twice as long. The same
/// is true for a face with many edges.
class FaultList {
  public:
    FaultList(const TopoDS_Shape& shape, const Progress* progress) : shape_(shape), progress_(progress) {}

    /// Wires, edges and vertices are checked with their faces, shells with their solids.
    std::vector<std::string> collect() {
        for (const TopAbs_ShapeEnum kind : {TopAbs_FACE, TopAbs_SOLID}) {
            const TopTools_IndexedMapOfShape& entities = numbered(kind);
            for (int i = 1; i <= entities.Extent(); ++i) {
                check_cancelled(progress_);
                const OpenCascadeWait wait(progress_, Message(phrases::kChecking, {{"name", name(entities(i))}}));
                check(entities(i));
            }
        }
        return std::move(faults_);
    }

  private:
    /// The entities of a kind in the order of their numbers, found when they are first asked for.
    const TopTools_IndexedMapOfShape& numbered(TopAbs_ShapeEnum kind) {
        const auto [entry, first] = numbered_.try_emplace(kind);
        if (first) {
            map_sub_shapes(shape_, kind, entry->second, progress_);
        }
        return entry->second;
    }

    std::string name(const TopoDS_Shape& shape) {
        const char* const names[] = {"Solid", "Shell", "Face", "Wire", "Edge", "Vertex"};
        if (shape.IsNull() || shape.ShapeType() < TopAbs_SOLID || shape.ShapeType() > TopAbs_VERTEX) {
            return std::string();
        }
        const int index = numbered(shape.ShapeType()).FindIndex(shape);
        return index > 0 ? names[shape.ShapeType() - TopAbs_SOLID] + std::to_string(index) : std::string();
    }

    void check(const TopoDS_Shape& shape) {
        try {
            if (shape.ShapeType() == TopAbs_FACE) {
                check_face(TopoDS::Face(shape));
            } else {
                check_solid(TopoDS::Solid(shape));
            }
        } catch (const Standard_Failure& failure) {
            add_line(name(shape) + ": OpenCASCADE's check ended with an exception: " + failure_text(failure));
        }
    }

    void check_face(const TopoDS_Face& face) {
        if (more_than(kMostAtOnce, face, TopAbs_EDGE)) {
            add(check_large_face(face, progress_));
            return;
        }
        if (is_known_to_be_valid(face)) {
            return;
        }
        const BRepCheck_Analyzer analyzer(face);
        for (const TopAbs_ShapeEnum part : {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_WIRE, TopAbs_FACE}) {
            TopTools_IndexedMapOfShape parts;
            TopExp::MapShapes(face, part, parts);
            for (int i = 1; i <= parts.Extent(); ++i) {
                add(parts(i), analyzer.Result(parts(i)));
            }
        }
    }

    /// A face at several places is looked at once, where it was defined. Where the proof fails, nothing is known.
    bool is_known_to_be_valid(const TopoDS_Face& face) {
        const auto [known, first] = valid_.emplace(face.TShape().get(), false);
        if (first) {
            try {
                known->second = is_proved_valid(TopoDS::Face(face.Located(TopLoc_Location())));
            } catch (const Standard_Failure&) {
                known->second = false;
            }
        }
        return known->second && is_rigid(face.Location().Transformation());
    }

    void check_solid(const TopoDS_Solid& solid) {
        const Handle(BRepCheck_Solid) result = new BRepCheck_Solid(solid);
        result->Blind();
        add(solid, result);
        for (TopExp_Explorer shells(solid, TopAbs_SHELL); shells.More(); shells.Next()) {
            if (more_than(kMostAtOnce, shells.Current(), TopAbs_FACE)) {
                add(check_large_shell(TopoDS::Shell(shells.Current()), progress_));
                continue;
            }
            const Handle(BRepCheck_Shell) shell = new BRepCheck_Shell(TopoDS::Shell(shells.Current()));
            shell->Blind();
            shell->InContext(solid);
            add(shells.Current(), shell);
        }
    }

    void add(const std::vector<Finding>& findings) {
        for (const Finding& finding : findings) {
            add(finding.status, finding.whose, finding.context);
        }
    }

    void add(const TopoDS_Shape& shape, const Handle(BRepCheck_Result) & result) {
        if (result.IsNull()) {
            return;
        }
        add(result->Status(), shape, TopoDS_Shape());
        for (result->InitContextIterator(); result->MoreShapeInContext(); result->NextShapeInContext()) {
            if (!result->ContextualShape().IsSame(shape)) {
                add(result->StatusOnShape(), shape, result->ContextualShape());
            }
        }
    }

    void add(const BRepCheck_ListOfStatus& statuses, const TopoDS_Shape& whose, const TopoDS_Shape& context) {
        for (const BRepCheck_Status status : statuses) {
            add(status, whose, context);
        }
    }

    void add(BRepCheck_Status status, const TopoDS_Shape& whose, const TopoDS_Shape& context) {
        // Triangulations are what FreeCAD shows; shapes that come as a stream have none.
        if (status != BRepCheck_NoError && status != BRepCheck_InvalidPolygonOnTriangulation) {
            const std::string in = name(context);
            add_line(name(whose) + (in.empty() ? "" : " in " + in) + ": " + describe(status));
        }
    }

    void add_line(const std::string& line) {
        if (seen_.insert(line).second) {
            faults_.push_back(line);
        }
    }

    const TopoDS_Shape& shape_;
    const Progress* progress_;
    std::map<TopAbs_ShapeEnum, TopTools_IndexedMapOfShape> numbered_;
    std::unordered_map<const void*, bool> valid_;  // by definition of a face
    std::set<std::string> seen_;
    std::vector<std::string> faults_;
};

/// Solids whose faces look inward. The check of the shape takes them for holes in infinite space. A solid at several
/// places is looked at once. If the shape has no other fault, a ray from one face may decide.
void add_inverted_solids(const ShapeMap& live, const Topology& topology, std::vector<std::string>& faults,
                         const Progress* progress) {
    const bool valid = faults.empty();
    std::map<std::pair<const void*, TopAbs_Orientation>, bool> known;
    for (std::size_t i = 0; i < live.volumes.size(); ++i) {
        check_cancelled(progress);
        if (topology.volumes[i].kind != Volume::Kind::Solid) {
            continue;
        }
        const std::string name = "Solid" + std::to_string(i + 1);
        const OpenCascadeWait wait(progress, Message(phrases::kChecking, {{"name", name}}));
        const TopoDS_Shape solid = live.volumes[i].Located(TopLoc_Location());
        const auto [entry, first] = known.emplace(std::pair(solid.TShape().get(), solid.Orientation()), false);
        if (first) {
            entry->second = !(valid && looks_outward(solid)) && is_inside_out(solid);
        }
        if (entry->second) {
            faults.push_back(name + ": is turned inside out");
        }
    }
}

bool at_one_place(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    const gp_Trsf there = a.Location().Transformation();
    const gp_Trsf here = b.Location().Transformation();
    for (int row = 1; row <= 3; ++row) {
        for (int column = 1; column <= 4; ++column) {
            if (there.Value(row, column) != here.Value(row, column)) {
                return false;
            }
        }
    }
    return true;
}

/// Solids that a shape lists several times at one place by locations that OpenCASCADE takes for different ones, as
/// FreeCAD's shape of a container does with what lies in a group in it.
void add_repeated_solids(const ShapeMap& live, const Topology& topology, std::vector<std::string>& faults) {
    std::map<const void*, std::vector<std::size_t>> known;
    for (std::size_t i = 0; i < live.volumes.size(); ++i) {
        if (topology.volumes[i].kind != Volume::Kind::Solid) {
            continue;
        }
        std::vector<std::size_t>& alike = known[live.volumes[i].TShape().get()];
        const auto first = std::find_if(alike.begin(), alike.end(),
                                        [&](std::size_t k) { return at_one_place(live.volumes[k], live.volumes[i]); });
        if (first != alike.end()) {
            faults.push_back("Solid" + std::to_string(i + 1) + ": is Solid" + std::to_string(*first + 1) +
                             " again, at the same place");
        } else {
            alike.push_back(i);
        }
    }
}

/// Edges and vertices beside the faces, e.g. axes and sketches in a STEP file, which no mesh of the faces follows.
void add_lines_beside_faces(const TopoDS_Shape& shape, std::vector<std::string>& faults, const Progress* progress) {
    TopTools_IndexedMapOfShape on_faces;
    for (const auto& [kind, name] : {std::pair(TopAbs_EDGE, "Edge"), std::pair(TopAbs_VERTEX, "Vertex")}) {
        TopExp_Explorer beside(shape, kind, kind == TopAbs_EDGE ? TopAbs_FACE : TopAbs_EDGE);
        if (!beside.More()) {
            continue;
        }
        for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
            map_sub_shapes(faces.Current(), kind, on_faces, progress);
        }
        TopTools_IndexedMapOfShape all;
        map_sub_shapes(shape, kind, all, progress);
        TopTools_IndexedMapOfShape found;
        for (; beside.More(); beside.Next()) {
            if (!on_faces.Contains(beside.Current())) {
                found.Add(beside.Current());
            }
        }
        if (!found.IsEmpty()) {
            const int others = found.Extent() - 1;
            faults.push_back(name + std::to_string(all.FindIndex(found(1))) +
                             (others > 0 ? " and " + std::to_string(others) + " more" : std::string()) +
                             ": of no face, so that no mesh has it");
        }
    }
}

}  // namespace

std::vector<std::string> kernel_faults(const TopoDS_Shape& shape, const ShapeMap& live, const Topology& topology,
                                       const Progress* progress) {
    std::vector<std::string> faults = FaultList(shape, progress).collect();
    add_inverted_solids(live, topology, faults, progress);
    add_repeated_solids(live, topology, faults);
    add_lines_beside_faces(shape, faults, progress);
    return faults;
}

}  // namespace mq::geometry
