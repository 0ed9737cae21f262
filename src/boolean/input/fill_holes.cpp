// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/error.h"
#include "base/key_set.h"
#include "base/tuning.h"
#include "boolean/input/operand_mesh.h"
#include "boolean/input/tuning.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/intersection/aabb_tree.h"
#include "mesh/intersection/triangle_contact.h"
#include "mesh/polygon_triangulation.h"
#include "mesh/vertex_stars.h"

namespace mq::boolean {
namespace {

/// The corners of a border in the order of the walk along it, and the first triangle of its filling.
struct Hole {
    std::vector<std::int32_t> border;
    std::int32_t first_triangle = -1;
    bool fan = false;  ///< filled around a new vertex in its middle

    std::size_t triangle_count() const { return fan ? border.size() : border.size() - 2; }
};

class HoleClosing {
  public:
    HoleClosing(OperandMesh& draft, const Progress* progress)
        : draft_(draft), progress_(progress), kept_(draft.triangles.size()) {}

    void run() {
        find_holes();
        const mesh::VertexStars stars(draft_.triangles, draft_.vertices.size());
        for (Hole& hole : holes_) {
            check_cancelled(progress_);
            note_edges(hole, stars);
            fill(hole, {});
        }
        avoid_crossings();
        remove_open_components();
    }

  private:
    // ---- borders ----

    /// The border corner that follows within the fan of the head of `h`.
    std::int32_t next_on_border(std::int32_t h) const {
        std::int32_t g = mesh::next_corner(h);
        while (draft_.mates[g] >= 0) {
            g = mesh::next_corner(draft_.mates[g]);
        }
        return g;
    }

    /// Walks along every border, and cuts off a hole whenever a vertex is met again.
    void find_holes() {
        std::vector<char> visited(draft_.mates.size(), 0);
        std::unordered_map<std::int32_t, std::size_t> place;
        for (std::size_t start = 0; start < draft_.mates.size(); ++start) {
            if (draft_.mates[start] != mesh::kBorder || visited[start] != 0) {
                continue;
            }
            std::vector<std::int32_t> path;
            place.clear();
            auto h = static_cast<std::int32_t>(start);
            while (visited[h] == 0) {
                visited[h] = 1;
                place[draft_.tail(h)] = path.size();
                path.push_back(h);
                const std::int32_t next = next_on_border(h);  // read first, as closing a border of two edges changes it
                const auto met = place.find(draft_.head(h));
                if (met != place.end()) {
                    const auto first = path.begin() + static_cast<std::ptrdiff_t>(met->second);
                    std::vector<std::int32_t> border(first, path.end());
                    for (const std::int32_t e : border) {
                        place.erase(draft_.tail(e));
                    }
                    path.erase(first, path.end());
                    add_hole(std::move(border));
                }
                h = next;
            }
        }
    }

    void add_hole(std::vector<std::int32_t> border) {
        if (border.size() == 2) {
            draft_.pair(border[0], border[1]);
        } else {
            holes_.push_back({std::move(border)});
        }
    }

    // ---- filling ----

    /// Position i of the loop is the tail of border corner -i: the loop runs against the border.
    std::int32_t border_at(const Hole& hole, std::int32_t i) const {
        const auto count = static_cast<std::int32_t>(hole.border.size());
        return hole.border[(count - i) % count];
    }
    /// The border corner opposite to the loop's edge from position i.
    std::int32_t border_of_edge(const Hole& hole, std::int32_t i) const {
        return hole.border[hole.border.size() - 1 - i];
    }

    /// Records which pairs of the hole's vertices the surface joins by edges already.
    void note_edges(const Hole& hole, const mesh::VertexStars& stars) {
        std::unordered_set<std::int32_t> rim;
        for (const std::int32_t h : hole.border) {
            rim.insert(draft_.tail(h));
        }
        for (const std::int32_t h : hole.border) {
            for (const std::uint32_t corner : stars[draft_.tail(h)]) {
                const std::int32_t g = mesh::next_corner(static_cast<std::int32_t>(corner));
                for (const std::int32_t v : {draft_.tail(g), draft_.head(g)}) {
                    if (rim.count(v) > 0) {
                        edges_.insert(pair_key(draft_.tail(h), v));
                    }
                }
            }
        }
    }

    /// A chord of the loop that is an edge of the surface already would get too many triangles.
    bool has_taken_chord(const Hole& hole, const mesh::Triangle& t) const {
        const auto count = static_cast<std::int32_t>(hole.border.size());
        for (int i = 0; i < 3; ++i) {
            const std::int32_t a = t[i];
            const std::int32_t b = t[(i + 1) % 3];
            const bool chord = (a + 1) % count != b && (b + 1) % count != a;
            if (chord && edges_.count(pair_key(draft_.tail(border_at(hole, a)), draft_.tail(border_at(hole, b)))) > 0) {
                return true;
            }
        }
        return false;
    }

    std::vector<Vec3> loop_of(const Hole& hole) const {
        std::vector<Vec3> loop;
        for (std::size_t i = 0; i < hole.border.size(); ++i) {
            loop.push_back(draft_.point(border_at(hole, static_cast<std::int32_t>(i))));
        }
        return loop;
    }

    void fill(Hole& hole, const mesh::AvoidTriangle& avoid) {
        std::vector<mesh::Triangle> filling = mesh::fill_hole(
            loop_of(hole), [&](const mesh::Triangle& t) { return has_taken_chord(hole, t) || (avoid && avoid(t)); },
            progress_);
        const bool taken = std::any_of(filling.begin(), filling.end(),
                                       [&](const mesh::Triangle& t) { return has_taken_chord(hole, t); });
        if (taken && hole.first_triangle < 0) {
            hole.fan = true;
            filling = fan_filling(hole);
        } else if (taken) {
            return;  // the present filling is better
        }
        put(hole, filling);
    }

    /// Triangles from the middle of the loop, whose index is the loop's length.
    static std::vector<mesh::Triangle> fan_filling(const Hole& hole) {
        const auto count = static_cast<std::int32_t>(hole.border.size());
        std::vector<mesh::Triangle> filling;
        for (std::int32_t i = 0; i < count; ++i) {
            filling.push_back({i, (i + 1) % count, count});
        }
        return filling;
    }

    /// Writes the triangles of a filling to the draft, in the place of an earlier one, and joins them.
    void put(Hole& hole, const std::vector<mesh::Triangle>& filling) {
        if (hole.first_triangle < 0) {
            hole.first_triangle = static_cast<std::int32_t>(draft_.triangles.size());
            draft_.triangles.resize(draft_.triangles.size() + filling.size());
            draft_.source.resize(draft_.triangles.size(), -1);
            draft_.mates.resize(3 * draft_.triangles.size(), mesh::kBorder);
        }
        const auto count = static_cast<std::int32_t>(hole.border.size());
        std::int32_t middle = -1;
        if (hole.fan) {
            Vec3 sum = Vec3::Zero();
            for (const std::int32_t h : hole.border) {
                sum += draft_.point(h) / double(count);
            }
            middle = static_cast<std::int32_t>(draft_.vertices.size());
            draft_.vertices.push_back(to_single(sum));
        }
        std::unordered_map<std::uint64_t, std::int32_t> open;
        for (std::size_t k = 0; k < filling.size(); ++k) {
            const std::int32_t t = hole.first_triangle + static_cast<std::int32_t>(k);
            for (int i = 0; i < 3; ++i) {
                const std::int32_t a = filling[k][i];
                const std::int32_t b = filling[k][(i + 1) % 3];
                draft_.triangles[t][i] = a == count ? middle : draft_.tail(border_at(hole, a));
                if (a < count && b == (a + 1) % count) {
                    draft_.pair(3 * t + i, border_of_edge(hole, a));
                    continue;
                }
                const auto [other, fresh] = open.emplace(pair_key(a, b), 3 * t + i);
                if (!fresh) {
                    draft_.pair(3 * t + i, other->second);
                }
            }
        }
        for (std::int32_t t = hole.first_triangle; t < hole.first_triangle + int(filling.size()); ++t) {
            for (int i = 0; i < 3; ++i) {
                edges_.insert(pair_key(draft_.triangles[t][i], draft_.triangles[t][(i + 1) % 3]));
            }
        }
    }

    // ---- fillings that cross the surface ----

    /// Fills holes again whose filling crosses the surface, now avoiding triangles that would cross it. In long loops
    /// only those triangles are avoided that were found to cross, in a few rounds.
    void avoid_crossings() {
        if (holes_.empty()) {
            return;
        }
        std::vector<std::int32_t> kept(kept_);
        std::iota(kept.begin(), kept.end(), 0);
        const mesh::AabbTree tree(draft_.vertices, draft_.triangles, kept);
        std::vector<std::unordered_set<std::uint64_t>> refused(holes_.size());
        for (int round = 0; round < kMostRounds; ++round) {
            const std::vector<std::size_t> crossed = holes_that_cross(tree, refused);
            for (const std::size_t k : crossed) {
                check_cancelled(progress_);
                Hole& hole = holes_[k];
                const bool test = hole.border.size() <= InputTuning::kTestedLoop;
                refill(hole, [&](const mesh::Triangle& t) {
                    return refused[k].count(triple_key(t)) > 0 || (test && crosses(tree, corners_at(hole, t)));
                });
            }
            if (crossed.empty()) {
                return;
            }
        }
    }

    void refill(Hole& hole, const mesh::AvoidTriangle& avoid) {
        if (hole.fan) {
            return;
        }
        for (std::int32_t t = hole.first_triangle; t < hole.first_triangle + int(hole.triangle_count()); ++t) {
            for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h) {
                if (draft_.mates[h] / 3 >= hole.first_triangle) {
                    edges_.erase(pair_key(draft_.tail(h), draft_.head(h)));
                }
            }
        }
        fill(hole, avoid);
    }

    static std::uint64_t triple_key(mesh::Triangle t) {
        std::sort(t.begin(), t.end());
        return (static_cast<std::uint64_t>(t[0]) << 42) | (static_cast<std::uint64_t>(t[1]) << 21) |
               static_cast<std::uint64_t>(t[2]);
    }

    /// The holes with crossing fillings; notes the triangles that cross, by positions in the loop.
    std::vector<std::size_t> holes_that_cross(const mesh::AabbTree& tree,
                                              std::vector<std::unordered_set<std::uint64_t>>& refused) const {
        std::vector<std::int32_t> filling;
        std::vector<std::size_t> hole_of;
        for (std::size_t k = 0; k < holes_.size(); ++k) {
            for (std::size_t i = 0; i < holes_[k].triangle_count(); ++i) {
                filling.push_back(holes_[k].first_triangle + static_cast<std::int32_t>(i));
                hole_of.push_back(k);
            }
        }
        std::set<std::size_t> crossed;
        const auto note = [&](std::int32_t t) {
            const std::size_t k = hole_of[t - filling[0]];
            refused[k].insert(triple_key(places_of(holes_[k], draft_.triangles[t])));
            crossed.insert(k);
        };
        for (const std::int32_t t : filling) {
            if (crosses(tree, draft_.triangles[t])) {
                note(t);
            }
        }
        const mesh::AabbTree fillings(draft_.vertices, draft_.triangles, filling);
        fillings.for_each_own_pair([&](std::int32_t a, std::int32_t b) {
            if (mesh::contact(draft_.vertices, draft_.triangles[a], draft_.triangles[b]) == mesh::Contact::Crossing) {
                note(a);
                note(b);
            }
        });
        return {crossed.begin(), crossed.end()};
    }

    mesh::Triangle corners_at(const Hole& hole, const mesh::Triangle& places) const {
        return {draft_.tail(border_at(hole, places[0])), draft_.tail(border_at(hole, places[1])),
                draft_.tail(border_at(hole, places[2]))};
    }
    mesh::Triangle places_of(const Hole& hole, const mesh::Triangle& corners) const {
        mesh::Triangle places{};
        for (std::int32_t p = 0; p < static_cast<std::int32_t>(hole.border.size()); ++p) {
            for (int i = 0; i < 3; ++i) {
                places[i] = draft_.tail(border_at(hole, p)) == corners[i] ? p : places[i];
            }
        }
        return places;
    }

    bool crosses(const mesh::AabbTree& tree, const mesh::Triangle& candidate) const {
        Box box;
        for (const std::int32_t v : candidate) {
            box.add(draft_.vertices[v]);
        }
        bool found = false;
        tree.for_each_in_box(box, [&](std::int32_t s) {
            found = mesh::contact(draft_.vertices, candidate, draft_.triangles[s]) == mesh::Contact::Crossing;
            return !found;
        });
        return found;
    }

    // ---- components that are too open to close ----

    void remove_open_components() {
        const mesh::Components components = mesh::components(draft_.mates);
        std::vector<double> own(components.count, 0.0);
        std::vector<double> added(components.count, 0.0);
        double whole = 0.0;
        for (std::size_t t = 0; t < draft_.triangles.size(); ++t) {
            const double area = draft_.area(static_cast<std::int32_t>(t));
            (t < kept_ ? own : added)[components.component_of[t]] += area;
            whole += t < kept_ ? area : 0.0;
        }
        std::vector<char> attached(components.count, 0);
        for (const std::int32_t t : draft_.attached) {
            attached[components.component_of[t]] = 1;
        }
        std::vector<char> open(components.count, 0);
        double scrap = 0.0;  // area of open components that may or may not bound a volume
        double removed = 0.0;
        for (std::int32_t c = 0; c < components.count; ++c) {
            open[c] = static_cast<char>(added[c] > InputTuning::kLargestFilledShare * own[c]);
            removed += open[c] != 0 ? own[c] : 0.0;
            const bool sheet = added[c] >= InputTuning::kLeastSheetShare * own[c];
            scrap += open[c] != 0 && !sheet && attached[c] == 0 ? own[c] : 0.0;
        }
        if (scrap > InputTuning::kLargestScrapShare * whole || removed > 0.5 * whole) {
            refuse(components, open);
        }
        count_holes(components, open);
        if (removed > 0.0) {
            std::vector<char> marked(draft_.triangles.size(), 0);
            for (std::size_t t = 0; t < marked.size(); ++t) {
                marked[t] = open[components.component_of[t]];
                draft_.repairs.scraps += marked[t] != 0 && t < kept_ ? 1 : 0;
            }
            draft_.remove(marked);
        }
    }

    void count_holes(const mesh::Components& components, const std::vector<char>& open) {
        for (const Hole& hole : holes_) {
            if (open[components.component_of[hole.first_triangle]] == 0) {
                ++draft_.repairs.holes;
                draft_.repairs.hole_triangles += hole.triangle_count();
            }
        }
    }

    /// Names the longest border of the components that are too open to close.
    [[noreturn]] void refuse(const mesh::Components& components, const std::vector<char>& open) const {
        const Hole* longest = nullptr;
        for (const Hole& hole : holes_) {
            const bool relevant = open[components.component_of[hole.first_triangle]] != 0;
            if (relevant && (longest == nullptr || hole.border.size() > longest->border.size())) {
                longest = &hole;
            }
        }
        Vec3 middle = Vec3::Zero();
        for (const std::int32_t h : longest->border) {
            middle += draft_.point(h) / double(longest->border.size());
        }
        throw OpenOperand(
            phrases::kOpenSurface,
            {{"name", draft_.name}, {"count", longest->border.size()}, {"point", draft_.position(middle)}});
    }

    OperandMesh& draft_;
    const Progress* progress_;
    std::size_t kept_;  ///< triangles from here on are fillings
    std::vector<Hole> holes_;
    std::unordered_set<std::uint64_t> edges_;  ///< edges at the rims of holes, and of fillings
};

}  // namespace

void close_holes(OperandMesh& draft, const Progress* progress) {
    if (std::find(draft.mates.begin(), draft.mates.end(), mesh::kBorder) != draft.mates.end()) {
        HoleClosing(draft, progress).run();
    }
}

}  // namespace mq::boolean
