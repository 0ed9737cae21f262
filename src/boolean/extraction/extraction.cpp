// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/extraction/extraction.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "base/disjoint_sets.h"
#include "boolean/arrangement/radial_order.h"
#include "mesh/corner_table.h"

namespace mq::boolean {

namespace {

/// Two triangles on both sides of a piece of material, each by the corner where their common edge starts: 3 t + k.
using Wedge = std::array<std::size_t, 2>;

/// Joins the corners of triangles around suspicious points to fans, and gives each fan but the first at a point a copy
/// of the point.
class FanOpener {
  public:
    /// @param source  the soup's triangle in whose plane each triangle lies
    FanOpener(const PointTable& points, std::vector<Triangle>& triangles, const std::vector<std::int32_t>& source)
        : points_(points), triangles_(triangles), source_(source) {}

    /// The wedges at each edge of more than two triangles.
    const std::vector<std::vector<Wedge>>& wedges() const { return wedges_; }

    /// @return the points with several fans, each with its copies; the first copy is the point itself
    std::map<std::int32_t, std::vector<std::int32_t>> run(const std::vector<char>& suspicious) {
        gather(suspicious);
        join();
        std::map<std::int32_t, std::vector<std::int32_t>> copies;
        std::unordered_map<std::size_t, std::int32_t> copy_of;  // by the fan's first slot
        std::int32_t fresh = points_.size();
        for (std::size_t i = 0; i < corner_.size(); ++i) {
            if (suspicious[static_cast<std::size_t>(point_[i])] == 0) {
                continue;
            }
            std::vector<std::int32_t>& list = copies[point_[i]];
            const std::size_t fan = fans_.find(i);
            if (copy_of.count(fan) == 0) {
                copy_of[fan] = list.empty() ? point_[i] : fresh++;
                list.push_back(copy_of[fan]);
            }
            triangles_[corner_[i] / 3][corner_[i] % 3] = copy_of[fan];
        }
        for (auto it = copies.begin(); it != copies.end();) {
            it = it->second.size() < 2 ? copies.erase(it) : std::next(it);
        }
        return copies;
    }

  private:
    /// Gathers the corners of triangles with a suspicious point, three slots for each triangle.
    void gather(const std::vector<char>& suspicious) {
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            const Triangle& c = triangles_[t];
            if (std::any_of(c.begin(), c.end(), [&](int p) { return suspicious[static_cast<std::size_t>(p)] != 0; })) {
                for (std::size_t k = 0; k < 3; ++k) {
                    corner_.push_back(3 * t + k);
                    point_.push_back(c[k]);
                }
            }
        }
        fans_ = DisjointSets<std::size_t>(corner_.size());
    }

    void join() {
        std::vector<std::pair<EdgeKey, std::size_t>> edges;  // with the slot where the edge starts
        for (std::size_t i = 0; i < corner_.size(); ++i) {
            edges.emplace_back(edge_key(point_[i], point_[mesh::next_corner(i)]), i);
        }
        std::sort(edges.begin(), edges.end());
        for (std::size_t i = 0; i < edges.size();) {
            std::size_t j = i;
            while (j < edges.size() && edges[j].first == edges[i].first) {
                ++j;
            }
            if (j - i == 2) {
                join_sides(edges[i].second, edges[i + 1].second, edges[i].first);
            } else if (j - i > 2) {
                join_around(edges[i].first, edges, i, j);
            }
            i = j;
        }
    }

    /// The triangles with the directed edges at slots a and b are neighbours at that edge.
    void join_sides(std::size_t a, std::size_t b, const EdgeKey& edge) {
        const bool a_up = point_[a] == edge[0];
        const bool b_up = point_[b] == edge[0];
        fans_.unite(a_up ? a : mesh::next_corner(a), b_up ? b : mesh::next_corner(b));
        fans_.unite(a_up ? mesh::next_corner(a) : a, b_up ? mesh::next_corner(b) : b);
    }

    /// More than two triangles at an edge are neighbours across the material between them.
    void join_around(const EdgeKey& edge, const std::vector<std::pair<EdgeKey, std::size_t>>& edges, std::size_t first,
                     std::size_t last) {
        std::vector<RadialFace> around;
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t slot = edges[i].second;
            around.push_back({static_cast<std::int32_t>(slot), point_[mesh::previous_corner(slot)],
                              point_[slot] == edge[0], source_[corner_[slot] / 3]});
        }
        sort_radially(points_, edge[0], edge[1], around);
        wedges_.emplace_back();
        for (std::size_t i = 0; i < around.size(); ++i) {
            // A face that runs up has the outside on its counter-clockwise side; a face that runs down has the material
            // there.
            if (!around[i].runs_up) {
                const RadialFace& beyond = around[(i + 1) % around.size()];
                const auto one = static_cast<std::size_t>(around[i].face);
                const auto two = static_cast<std::size_t>(beyond.face);
                join_sides(one, two, edge);
                wedges_.back().push_back({corner_[one], corner_[two]});
            }
        }
    }

    const PointTable& points_;
    std::vector<Triangle>& triangles_;
    const std::vector<std::int32_t>& source_;
    std::vector<std::size_t> corner_;  ///< corner 3 triangle + k of each slot
    std::vector<std::int32_t> point_;  ///< point of each slot
    DisjointSets<std::size_t> fans_{0};
    std::vector<std::vector<Wedge>> wedges_;
};

/// Where material touches along an edge but is connected around both of its ends, the edge stays double. Each wedge
/// then gets a vertex of its own in the middle.
class DoubleEdges {
  public:
    explicit DoubleEdges(Extraction& extraction) : extraction_(extraction), draft_(extraction.draft) {}

    void run(const std::vector<std::vector<Wedge>>& wedges) {
        for (const std::vector<Wedge>& around : wedges) {
            std::map<EdgeKey, std::vector<Wedge>> by_ends;
            for (const Wedge& wedge : around) {
                const Triangle t = corners(wedge[0] / 3);
                const std::size_t k = wedge[0] % 3;
                by_ends[edge_key(t[k], t[(k + 1) % 3])].push_back(wedge);
            }
            for (const auto& [ends, list] : by_ends) {
                if (list.size() > 1) {
                    split(ends, list);
                }
            }
        }
    }

  private:
    /// The corners of a triangle before anything was split.
    Triangle corners(std::size_t t) const {
        const auto known = first_.find(t);
        return known != first_.end() ? known->second : draft_.triangles[t];
    }

    void split(const EdgeKey& ends, const std::vector<Wedge>& wedges) {
        const Vec3 middle = 0.5 * (draft_.vertices[static_cast<std::size_t>(ends[0])] +
                                   draft_.vertices[static_cast<std::size_t>(ends[1])]);
        std::vector<std::int32_t> copies;
        for (const Wedge& wedge : wedges) {
            copies.push_back(static_cast<std::int32_t>(draft_.vertices.size()));
            draft_.vertices.push_back(middle);
            draft_.made.push_back(kConstructed);
            for (const std::size_t corner : wedge) {
                split(corner / 3, ends, copies.back());
            }
        }
        extraction_.copies.push_back(std::move(copies));
    }

    /// Splits the piece of a triangle that has the edge.
    void split(std::size_t triangle, const EdgeKey& ends, std::int32_t middle) {
        first_.emplace(triangle, draft_.triangles[triangle]);
        std::vector<std::size_t>& pieces = pieces_[triangle];
        if (pieces.empty()) {
            pieces.push_back(triangle);
        }
        for (const std::size_t piece : pieces) {
            const Triangle c = draft_.triangles[piece];
            for (std::size_t k = 0; k < 3; ++k) {
                if (edge_key(c[k], c[(k + 1) % 3]) == ends) {
                    draft_.triangles[piece] = {c[k], middle, c[(k + 2) % 3]};
                    draft_.source[piece] = Source{};
                    draft_.triangles.push_back({middle, c[(k + 1) % 3], c[(k + 2) % 3]});
                    draft_.source.push_back(Source{});
                    draft_.from.push_back(draft_.from[piece]);
                    pieces.push_back(draft_.triangles.size() - 1);
                    return;
                }
            }
        }
    }

    Extraction& extraction_;
    ResultMesh& draft_;
    std::map<std::size_t, Triangle> first_;
    std::map<std::size_t, std::vector<std::size_t>> pieces_;
};

/// Whether a vertex is marked in a list that may be empty.
bool marked(const std::vector<char>& list, const PointTable& points, std::int32_t p) {
    return points.given(p) && !list.empty() && list[static_cast<std::size_t>(p)] != 0;
}

/// Points at which the result may touch itself: all but single vertices of one operand among whole triangles.
std::vector<char> suspicious_points(const Soup& soup, const Arrangement& arrangement,
                                    const std::vector<std::int32_t>& kept) {
    // No operand has used the vertex yet.
    constexpr std::int32_t kUnused = -1;
    std::vector<char> result(static_cast<std::size_t>(arrangement.points.size()), 0);
    std::vector<std::int32_t> operand(result.size(), kUnused);
    for (const std::int32_t f : kept) {
        const Face& face = arrangement.faces[static_cast<std::size_t>(f)];
        const std::int32_t own = soup.source[static_cast<std::size_t>(face.source)].operand;
        // Several sheets may also meet along an edge to a point where sheets meet, and not all of them are kept.
        const bool beside_shared = std::any_of(face.points.begin(), face.points.end(), [&](std::int32_t p) {
            return marked(soup.shared, arrangement.points, p);
        });
        for (const std::int32_t p : face.points) {
            const auto i = static_cast<std::size_t>(p);
            if (!face.whole || face.stack >= 0 || (operand[i] != kUnused && operand[i] != own) || beside_shared ||
                marked(soup.moved, arrangement.points, p)) {
                result[i] = 1;
            }
            operand[i] = own;
        }
    }
    return result;
}

/// Takes the vertices in the order of their first use, and leaves unused ones out.
void add_vertices(const Soup& soup, const PointTable& points,
                  const std::map<std::int32_t, std::vector<std::int32_t>>& copies, Extraction& result) {
    std::int32_t all = points.size();
    std::vector<std::int32_t> place;  // for each copy beyond the table's points the point where it lies
    for (const auto& entry : copies) {
        all += static_cast<std::int32_t>(entry.second.size()) - 1;
    }
    place.resize(static_cast<std::size_t>(all - points.size()));
    for (const auto& [point, list] : copies) {
        for (std::size_t i = 1; i < list.size(); ++i) {
            place[static_cast<std::size_t>(list[i] - points.size())] = point;
        }
    }
    std::vector<std::int32_t> index(static_cast<std::size_t>(all), -1);
    ResultMesh& draft = result.draft;
    for (Triangle& t : draft.triangles) {
        for (std::int32_t& v : t) {
            std::int32_t& at = index[static_cast<std::size_t>(v)];
            if (at < 0) {
                at = static_cast<std::int32_t>(draft.vertices.size());
                const std::int32_t p = v < points.size() ? v : place[static_cast<std::size_t>(v - points.size())];
                draft.vertices.push_back(points.approx(p));
                draft.made.push_back(!points.given(p)                ? kConstructed
                                     : marked(soup.moved, points, p) ? kRounded
                                                                     : kFromOperand);
            }
            v = at;
        }
    }
    for (const auto& entry : copies) {
        std::vector<std::int32_t> list;
        for (const std::int32_t copy : entry.second) {
            list.push_back(index[static_cast<std::size_t>(copy)]);
        }
        std::sort(list.begin(), list.end());
        result.copies.push_back(std::move(list));
    }
}

}  // namespace

Extraction extract(const Soup& soup, const Arrangement& arrangement, const Cells& cells, const Expression& expression,
                   const Progress& progress) {
    Extraction result;
    std::vector<std::int32_t> kept;
    std::vector<char> in_cell(cells.windings.size());
    std::vector<std::int32_t> winding(expression.operands(), 0);
    for (std::size_t c = 0; c < in_cell.size(); ++c) {
        for (const Winding& w : cells.windings[c]) {
            winding[static_cast<std::size_t>(w.operand)] = w.times;
        }
        in_cell[c] = expression.contains(winding.data()) ? 1 : 0;
        for (const Winding& w : cells.windings[c]) {
            winding[static_cast<std::size_t>(w.operand)] = 0;
        }
    }
    for (std::size_t f = 0; f < arrangement.faces.size(); ++f) {
        const bool front = in_cell[static_cast<std::size_t>(cells.front[f])] != 0;
        const bool back = in_cell[static_cast<std::size_t>(cells.back[f])] != 0;
        if (front == back) {
            continue;
        }
        const Face& face = arrangement.faces[f];
        kept.push_back(static_cast<std::int32_t>(f));
        result.draft.triangles.push_back(face.points);
        if (front) {
            std::swap(result.draft.triangles.back()[1], result.draft.triangles.back()[2]);
        }
        result.draft.from.push_back(face.source);
        const Source& source = soup.source[static_cast<std::size_t>(face.source)];
        result.draft.source.push_back(face.whole && source.triangle >= 0 ? source : Source{});
    }
    progress.check();
    FanOpener opener(arrangement.points, result.draft.triangles, result.draft.from);
    const auto copies = opener.run(suspicious_points(soup, arrangement, kept));
    progress.check();
    add_vertices(soup, arrangement.points, copies, result);
    DoubleEdges(result).run(opener.wedges());
    result.draft.displacement.assign(result.draft.triangles.size(), 0.0);
    return result;
}

}  // namespace mq::boolean
