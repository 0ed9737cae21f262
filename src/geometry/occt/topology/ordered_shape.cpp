// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/topology/ordered_shape.h"

#include <TopAbs_ShapeEnum.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <utility>

#include "geometry/occt/topology/sub_shapes.h"

namespace mq::geometry {

namespace {

using PiecesOf = std::function<TopoDS_Shape(const TopoDS_Shape&)>;

class Numbering {
  public:
    Numbering(const OrderedShape& whole, const TopoDS_Shape& result, const PiecesOf& pieces_of)
        : whole_(whole), pieces_of_(pieces_of) {
        cut_.shape = result;
        cut_.parts_of = whole.parts_of;
        cut_.cut_faces = whole.cut_faces;
        cut_.behind = whole.behind;
    }

    OrderedShape run() {
        number(whole_.faces, TopAbs_FACE, 2, cut_.faces);
        number(whole_.edges, TopAbs_EDGE, 1, cut_.edges);
        number(whole_.vertices, TopAbs_VERTEX, 0, cut_.vertices);
        std::sort(cut_.cut_faces.begin(), cut_.cut_faces.end());
        add_inner_edges();
        add_ends();
        note_unused_edges();
        return std::move(cut_);
    }

  private:
    void number(const TopTools_IndexedMapOfShape& own, TopAbs_ShapeEnum kind, int dimension,
                TopTools_IndexedMapOfShape& numbered) {
        std::vector<std::pair<int, TopoDS_Shape>> further;
        for (int i = 1; i <= own.Extent(); ++i) {
            TopTools_IndexedMapOfShape pieces;
            if (!whole_.replaced.Contains(own(i))) {
                TopExp::MapShapes(pieces_of_(own(i)), kind, pieces);
            }
            int first = 1;
            while (first <= pieces.Extent() && numbered.Contains(pieces(first))) {
                ++first;
            }
            if (first > pieces.Extent()) {
                cut_.replaced.Add(own(i));
            }
            numbered.Add(first > pieces.Extent() ? own(i) : pieces(first));
            for (int k = first + 1; k <= pieces.Extent(); ++k) {
                further.emplace_back(i - 1, pieces(k));
            }
            if (dimension == 2 && pieces.Extent() > 1) {
                cut_.cut_faces.push_back(whole_.of_shape({2, i - 1}).index);
            }
        }
        for (const auto& [of, piece] : further) {
            const auto behind = whole_.behind.find(of);
            if (dimension == 2 && behind != whole_.behind.end() && !numbered.Contains(piece)) {
                cut_.behind.emplace(numbered.Extent(), behind->second);
            }
            add(piece, dimension, whole_.of_shape({dimension, of}), numbered);
        }
    }

    void add(const TopoDS_Shape& piece, int dimension, Entity of, TopTools_IndexedMapOfShape& numbered) {
        if (!numbered.Contains(piece)) {
            numbered.Add(piece);
            cut_.parts_of[static_cast<std::size_t>(dimension)].push_back(of);
        }
    }

    // Adds edges that are no piece of an edge.
    void add_inner_edges() {
        for (int f = 1; f <= cut_.faces.Extent(); ++f) {
            const Entity face = cut_.of_shape({2, f - 1});
            for (TopExp_Explorer it(cut_.faces(f), TopAbs_EDGE); it.More() && !is_replaced(cut_.faces(f)); it.Next()) {
                add(it.Current(), 1, face, cut_.edges);
            }
        }
    }

    // Adds ends of inner edges, which lie on an edge that was cut, or inside a face.
    void add_ends() {
        for (const bool of_edges : {true, false}) {
            for (int e = 1; e <= cut_.edges.Extent(); ++e) {
                const Entity of = cut_.of_shape({1, e - 1});
                if ((of.dimension == 1) != of_edges || is_replaced(cut_.edges(e))) {
                    continue;
                }
                for (TopExp_Explorer it(cut_.edges(e), TopAbs_VERTEX); it.More(); it.Next()) {
                    add(it.Current(), 0, of, cut_.vertices);
                }
            }
        }
    }

    // Records edges of pieces that were merged with others, such as seams.
    void note_unused_edges() {
        TopTools_IndexedMapOfShape used;
        TopExp::MapShapes(cut_.shape, TopAbs_EDGE, used);
        for (int e = 1; e <= cut_.edges.Extent(); ++e) {
            if (!used.Contains(cut_.edges(e)) && !is_replaced(cut_.edges(e))) {
                cut_.replaced.Add(cut_.edges(e));
            }
        }
    }

    bool is_replaced(const TopoDS_Shape& entity) const { return cut_.replaced.Contains(entity); }

    const OrderedShape& whole_;
    const PiecesOf& pieces_of_;
    OrderedShape cut_;
};

void move(TopTools_IndexedMapOfShape& entities, const TopLoc_Location& place) {
    TopTools_IndexedMapOfShape moved;
    for (int i = 1; i <= entities.Extent(); ++i) {
        moved.Add(entities(i).Moved(place, Standard_False));
    }
    entities = moved;
}

}  // namespace

int OrderedShape::number_of(const TopoDS_Shape& entity) const {
    const TopAbs_ShapeEnum kind = entity.ShapeType();
    return (kind == TopAbs_FACE ? faces : kind == TopAbs_EDGE ? edges : vertices).FindIndex(entity) - 1;
}

Entity OrderedShape::of_shape(Entity entity) const {
    const int all = entity.dimension == 2 ? faces.Extent() : entity.dimension == 1 ? edges.Extent() : vertices.Extent();
    const std::vector<Entity>& parts = parts_of[static_cast<std::size_t>(entity.dimension)];
    const int own = all - static_cast<int>(parts.size());
    return entity.index < own ? entity : parts[static_cast<std::size_t>(entity.index - own)];
}

OrderedShape ordered(const TopoDS_Shape& shape, const Progress* progress) {
    OrderedShape result;
    result.shape = shape;
    map_sub_shapes(shape, TopAbs_VERTEX, result.vertices, progress);
    map_sub_shapes(shape, TopAbs_EDGE, result.edges, progress);
    map_sub_shapes(shape, TopAbs_FACE, result.faces, progress);
    return result;
}

OrderedShape moved(OrderedShape shape, const TopLoc_Location& place) {
    shape.shape = shape.shape.Moved(place, Standard_False);
    move(shape.vertices, place);
    move(shape.edges, place);
    move(shape.faces, place);
    move(shape.replaced, place);
    return shape;
}

OrderedShape number_pieces(const OrderedShape& whole, const TopoDS_Shape& result, const PiecesOf& pieces_of) {
    return Numbering(whole, result, pieces_of).run();
}

}  // namespace mq::geometry
