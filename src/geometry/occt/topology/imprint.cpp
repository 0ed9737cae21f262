// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/imprint.h"

#include <BOPAlgo_Builder.hxx>
#include <BOPTools_AlgoTools.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <IntTools_Context.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>
#include <set>
#include <utility>

namespace mq::geometry {

namespace {

using Bodies = std::set<int>;  // numbers of solids, from 1 on

/// Asks OpenCASCADE to stop once the operation is cancelled.
class StopWhenCancelled final : public Message_ProgressIndicator {
  public:
    explicit StopWhenCancelled(const Progress* progress) : progress_(progress) {}
    Standard_Boolean UserBreak() override { return progress_ != nullptr && progress_->cancelled(); }

  private:
    void Show(const Message_ProgressScope& /*scope*/, const Standard_Boolean /*force*/) override {}

    const Progress* progress_;
};

bool bounds_a_solid(const TopoDS_Shape& face) {
    return face.Orientation() == TopAbs_FORWARD || face.Orientation() == TopAbs_REVERSED;
}

TopoDS_Compound new_compound() {
    TopoDS_Compound compound;
    BRep_Builder().MakeCompound(compound);
    return compound;
}

bool has_inner_edge(const TopoDS_Shape& part) {
    for (TopExp_Explorer it(part, TopAbs_EDGE); it.More(); it.Next()) {
        if (it.Current().Orientation() == TopAbs_INTERNAL) {
            return true;
        }
    }
    return false;
}

/// The faces of some solids after the general fuse.
class Fuse {
  public:
    Fuse(const TopTools_IndexedMapOfShape& solids, const Bodies& bodies, double within, const Progress* progress) {
        // Faces, not solids, as solids that overlap would be cut into the regions that they share.
        TopTools_ListOfShape arguments;
        for (const int body : bodies) {
            const TopoDS_Compound faces = new_compound();
            TopoDS_Shape all = faces;
            for (TopExp_Explorer it(solids(body), TopAbs_FACE); it.More(); it.Next()) {
                BRep_Builder().Add(all, it.Current());
            }
            arguments.Append(all);
        }
        fuse_.SetArguments(arguments);
        fuse_.SetNonDestructive(true);
        fuse_.SetRunParallel(false);
        fuse_.SetGlue(BOPAlgo_GlueShift);
        fuse_.SetFuzzyValue(within);
        fuse_.SetToFillHistory(false);
        const Handle(StopWhenCancelled) stop = new StopWhenCancelled(progress);
        fuse_.Perform(stop->Start());
        check_cancelled(progress);
    }

    bool failed() const { return fuse_.HasErrors(); }

    /// The pieces into which a face, an edge or a vertex was divided, oriented as it is.
    TopoDS_Shape pieces_of(const TopoDS_Shape& entity) {
        const TopTools_ListOfShape* images = fuse_.Images().Seek(entity);
        TopTools_ListOfShape pieces;
        if (images != nullptr) {
            pieces = *images;
        } else {
            pieces.Append(entity);
        }
        TopoDS_Shape result = new_compound();
        for (TopoDS_Shape piece : pieces) {
            const TopoDS_Shape* same = fuse_.ShapesSD().Seek(piece);
            piece = same != nullptr ? *same : piece;
            if (entity.ShapeType() == TopAbs_FACE) {
                piece = turned(TopoDS::Face(without_inner_edges(piece, entity)), TopoDS::Face(entity));
            }
            BRep_Builder().Add(result, piece);
        }
        return result;
    }

  private:
    /// The piece without inner edges that its face does not have: seams of the other face, and edges of bodies that
    /// touch it along a line.
    TopoDS_Shape without_inner_edges(const TopoDS_Shape& piece, const TopoDS_Shape& face) {
        if (!has_inner_edge(piece) || has_inner_edge(face)) {
            return piece;
        }
        if (!cleared_.IsBound(piece)) {
            TopoDS_Shape cleared = piece.EmptyCopied();
            for (TopoDS_Iterator it(piece.Oriented(TopAbs_FORWARD)); it.More(); it.Next()) {
                if (!has_inner_edge(it.Value())) {
                    BRep_Builder().Add(cleared, it.Value());
                }
            }
            cleared_.Bind(piece, cleared);
        }
        return cleared_.Find(piece).Oriented(piece.Orientation());
    }
    TopoDS_Shape turned(const TopoDS_Face& piece, const TopoDS_Face& face) {
        const bool other_way = BOPTools_AlgoTools::IsSplitToReverse(piece, face, context_);
        return other_way ? piece.Reversed() : TopoDS_Shape(piece);
    }

    BOPAlgo_Builder fuse_;
    TopTools_DataMapOfShapeShape cleared_;
    Handle(IntTools_Context) context_ = new IntTools_Context;
};

double area_of(const TopoDS_Shape& faces) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(faces, properties);
    return std::abs(properties.Mass());
}

double perimeter_of(const TopoDS_Shape& face) {
    GProp_GProps properties;
    BRepGProp::LinearProperties(face, properties);
    return properties.Mass();
}

/// Whether the pieces cover the face, as far as its tolerance tells.
bool covered(const TopoDS_Shape& face, const TopoDS_Shape& pieces) {
    // Largest relative change of the area by a correct division.
    constexpr double kOfArea = 1e-3;
    const double area = area_of(face);
    const double change = std::abs(area_of(pieces) - area);
    return change <= kOfArea * area || change <= BRep_Tool::Tolerance(TopoDS::Face(face)) * perimeter_of(face);
}

bool is_valid(const TopoDS_Shape& faces) {
    return BRepCheck_Analyzer(faces).IsValid();
}

/// The solids of which boxes meet.
Bodies close_bodies(const TopTools_IndexedMapOfShape& solids, double within, const Progress* progress) {
    std::vector<Bnd_Box> boxes(static_cast<std::size_t>(solids.Extent()));
    Bodies result;
    for (int i = 1; i <= solids.Extent(); ++i) {
        check_cancelled(progress);
        Bnd_Box& box = boxes[static_cast<std::size_t>(i - 1)];
        BRepBndLib::Add(solids(i), box, Standard_False);
        box.Enlarge(within);
        for (int k = 1; k < i; ++k) {
            if (!box.IsOut(boxes[static_cast<std::size_t>(k - 1)])) {
                result.insert({i, k});
            }
        }
    }
    return result;
}

/// The solids that share faces after the fuse, and those whose faces it damaged.
struct Outcome {
    Bodies in_contact;
    Bodies damaged;
};

Outcome outcome_of(Fuse& fuse, const TopTools_IndexedMapOfShape& solids, const Bodies& bodies,
                   const Progress* progress) {
    Outcome outcome;
    TopTools_IndexedMapOfShape pieces;
    std::vector<int> first_owner;
    for (const int body : bodies) {
        for (TopExp_Explorer it(solids(body), TopAbs_FACE); it.More(); it.Next()) {
            check_cancelled(progress);
            const TopoDS_Shape here = fuse.pieces_of(it.Current());
            for (TopExp_Explorer piece(here, TopAbs_FACE); piece.More(); piece.Next()) {
                const auto index = static_cast<std::size_t>(pieces.Add(piece.Current()) - 1);
                if (index == first_owner.size()) {
                    first_owner.push_back(body);
                } else if (pieces(static_cast<int>(index) + 1).Orientation() == piece.Current().Orientation()) {
                    outcome.damaged.insert(body);  // both lie on the same side: they overlap
                } else if (first_owner[index] != body) {
                    outcome.in_contact.insert({first_owner[index], body});
                }
            }
            TopExp_Explorer only(here, TopAbs_FACE);
            const bool unchanged = only.More() && only.Current().IsSame(it.Current());
            if (!unchanged && bounds_a_solid(it.Current()) &&
                (!covered(it.Current(), here) || (is_valid(it.Current()) && !is_valid(here)))) {
                outcome.damaged.insert(body);
            }
        }
    }
    return outcome;
}

void add_pieces(TopoDS_Shape& to, const TopoDS_Shape& face, Fuse& fuse) {
    if (!bounds_a_solid(face)) {
        BRep_Builder().Add(to, face);
        return;
    }
    for (TopExp_Explorer piece(fuse.pieces_of(face), TopAbs_FACE); piece.More(); piece.Next()) {
        BRep_Builder().Add(to, piece.Current());
    }
}

TopoDS_Shape rebuilt(const TopoDS_Shape& solid, Fuse& fuse) {
    TopoDS_Solid result;
    BRep_Builder().MakeSolid(result);
    for (TopExp_Explorer shells(solid, TopAbs_SHELL); shells.More(); shells.Next()) {
        TopoDS_Shell shell;
        BRep_Builder().MakeShell(shell);
        for (TopExp_Explorer faces(shells.Current(), TopAbs_FACE); faces.More(); faces.Next()) {
            add_pieces(shell, faces.Current(), fuse);
        }
        BRep_Builder().Add(result, shell);
    }
    return result;
}

TopoDS_Shape rebuilt(const TopoDS_Shape& whole, const TopTools_IndexedMapOfShape& solids, const Bodies& bodies,
                     Fuse& fuse) {
    TopoDS_Shape result = new_compound();
    for (int i = 1; i <= solids.Extent(); ++i) {
        BRep_Builder().Add(result, bodies.count(i) > 0 ? rebuilt(solids(i), fuse) : solids(i));
    }
    for (TopExp_Explorer it(whole, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next()) {
        BRep_Builder().Add(result, it.Current());
    }
    for (TopExp_Explorer it(whole, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next()) {
        BRep_Builder().Add(result, it.Current());
    }
    return result;
}

/// Records for each face between two solids the face of the other solid, which sees it from its other side.
void note_faces_behind(OrderedShape& cut, const OrderedShape& whole, const TopTools_IndexedMapOfShape& solids,
                       const Bodies& bodies, Fuse& fuse) {
    for (const int body : bodies) {
        for (TopExp_Explorer it(solids(body), TopAbs_FACE); it.More(); it.Next()) {
            const int own = whole.of_shape({2, whole.number_of(it.Current())}).index;
            for (TopExp_Explorer piece(fuse.pieces_of(it.Current()), TopAbs_FACE); piece.More(); piece.Next()) {
                const int number = cut.number_of(piece.Current());
                const bool flipped = piece.Current().Orientation() != cut.faces(number + 1).Orientation();
                if (flipped && own != cut.of_shape({2, number}).index) {
                    cut.behind[number] = own;
                }
            }
        }
    }
}

std::string names_of(const Bodies& bodies) {
    std::string names;
    for (const int body : bodies) {
        names += (names.empty() ? "Solid" : ", Solid") + std::to_string(body);
    }
    return names;
}

}  // namespace

OrderedShape imprint_contacts(OrderedShape whole, double within, std::vector<std::string>& faults,
                              const Progress* progress) {
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(whole.shape, TopAbs_SOLID, solids);
    Bodies bodies = close_bodies(solids, within, progress);
    Bodies left;
    try {
        // Only bodies in contact are divided, as edges would else be divided where they cross bodies that stay as they
        // are.
        while (bodies.size() > 1) {
            Fuse fuse(solids, bodies, within, progress);
            if (fuse.failed()) {
                left.insert(bodies.begin(), bodies.end());
                break;
            }
            Outcome outcome = outcome_of(fuse, solids, bodies, progress);
            for (const int body : outcome.damaged) {
                left.insert(body);
                outcome.in_contact.erase(body);
            }
            if (outcome.in_contact == bodies) {
                const TopoDS_Shape result = rebuilt(whole.shape, solids, bodies, fuse);
                OrderedShape cut =
                    number_pieces(whole, result, [&](const TopoDS_Shape& part) { return fuse.pieces_of(part); });
                note_faces_behind(cut, whole, solids, bodies, fuse);
                whole = std::move(cut);
                break;
            }
            bodies = outcome.in_contact;
        }
    } catch (const Standard_Failure&) {
        left.insert(bodies.begin(), bodies.end());
    }
    if (!left.empty()) {
        faults.push_back(
            "bodies are not joined where they touch: they overlap there, or OpenCASCADE cannot divide their faces (" +
            names_of(left) + ")");
    }
    return whole;
}

}  // namespace mq::geometry
