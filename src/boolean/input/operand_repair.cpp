// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/input/operand_repair.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "base/predicates.h"
#include "boolean/input/operand_mesh.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/corner_table.h"
#include "mesh/quality/exemptions.h"
#include "mesh/weld_vertices.h"

namespace mq::boolean {
namespace {

/// The largest coordinate, mm, for which predicates are exact (base/predicates.h). Beyond it exact numbers overflow,
/// and grow without end.
constexpr double kLargest = 1e15;

void require_usable(const mesh::TriangleMesh& mesh, const std::string& name) {
    if (mesh.triangles.empty()) {
        throw InvalidInput(phrases::kNoTriangles, {{"name", name}});
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (!mesh.vertices[v].allFinite()) {
            throw InvalidInput(phrases::kNamed,
                               {{"name", name}, {"phrase", Message(phrases::kVertexNotFinite, {{"count", v}})}});
        }
        if (mesh.vertices[v].cwiseAbs().maxCoeff() > kLargest) {
            throw InvalidInput(phrases::kFarVertex, {{"name", name}, {"count", v}, {"length", in_mm(kLargest)}});
        }
    }
    const auto count = static_cast<std::int64_t>(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (const std::int32_t v : mesh.triangles[t]) {
            if (v < 0 || v >= count) {
                throw InvalidInput(
                    phrases::kNamed,
                    {{"name", name},
                     {"phrase", Message(phrases::kNoSuchVertex, {{"count", t}, {"count2", v}, {"count3", count}})}});
            }
        }
    }
}

OperandMesh draft_of(const mesh::TriangleMesh& mesh, const std::string& name) {
    OperandMesh draft;
    draft.vertices = mesh.vertices;
    draft.triangles = mesh.triangles;
    draft.source.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < draft.source.size(); ++t) {
        draft.source[t] = static_cast<std::int32_t>(t);
    }
    draft.name = name;
    draft.origin = mesh.origin;
    return draft;
}

/// Gives equal vertices one index, and removes triangles that name a vertex twice.
void weld(OperandMesh& draft) {
    const std::vector<std::int32_t> equal = mesh::equal_vertices(draft.vertices);
    for (std::size_t v = 0; v < equal.size(); ++v) {
        draft.repairs.welded += equal[v] != static_cast<std::int32_t>(v) ? 1 : 0;
    }
    if (draft.repairs.welded > 0) {
        for (mesh::Triangle& t : draft.triangles) {
            t = {equal[t[0]], equal[t[1]], equal[t[2]]};
        }
    }
    std::vector<char> marked(draft.triangles.size(), 0);
    std::size_t collapsed = 0;
    for (std::size_t k = 0; k < marked.size(); ++k) {
        marked[k] = static_cast<char>(mesh::is_collapsed(draft.triangles[k]));
        collapsed += marked[k];
    }
    if (collapsed > 0) {
        draft.repairs.degenerate += collapsed;
        draft.remove(marked);
    }
}

bool all_paired(const OperandMesh& draft) {
    return std::all_of(draft.mates.begin(), draft.mates.end(), [](std::int32_t mate) { return mate >= 0; });
}

/// Whether a triangle and its neighbour along the edge of this corner lie on the same three vertices.
bool is_fold(const OperandMesh& draft, std::int32_t h) {
    const std::int32_t mate = draft.mates[h];
    return mate >= 0 && draft.tail(mesh::previous_corner(h)) == draft.tail(mesh::previous_corner(mate));
}

bool has_fold(const OperandMesh& draft) {
    for (std::size_t h = 0; h < draft.mates.size(); ++h) {
        if (is_fold(draft, static_cast<std::int32_t>(h))) {
            return true;
        }
    }
    return false;
}

/// Removes pairs of triangles that lie on each other and are neighbours, until there are none: they bound nothing. The
/// neighbours of both along their other edges become neighbours. Needs triangles that agree on the outside, each corner
/// with a mate. Ends, as each step has two triangles less.
void remove_folds(OperandMesh& draft) {
    std::vector<char> marked(draft.triangles.size(), 0);
    std::vector<std::int32_t> to_do(draft.mates.size());
    std::iota(to_do.begin(), to_do.end(), 0);
    std::size_t gone = 0;
    while (!to_do.empty()) {
        const std::int32_t h = to_do.back();
        to_do.pop_back();
        if (marked[h / 3] != 0 || !is_fold(draft, h)) {
            continue;
        }
        const std::int32_t g = draft.mates[h];
        marked[h / 3] = marked[g / 3] = 1;
        gone += 2;
        for (const auto& [side, other] : {std::pair(mesh::next_corner(h), mesh::previous_corner(g)),
                                          std::pair(mesh::previous_corner(h), mesh::next_corner(g))}) {
            if (draft.mates[side] != other) {
                to_do.push_back(draft.mates[side]);
                draft.pair(draft.mates[side], draft.mates[other]);
            }
        }
    }
    if (gone > 0) {
        draft.repairs.duplicate += gone;
        draft.remove(marked);
    }
}

bool has_degenerate(const OperandMesh& draft) {
    return std::any_of(draft.triangles.begin(), draft.triangles.end(), [&](const mesh::Triangle& t) {
        return collinear(draft.vertices[t[0]], draft.vertices[t[1]], draft.vertices[t[2]]);
    });
}

bool single_fans(const OperandMesh& draft) {
    std::vector<char> met(draft.vertices.size(), 0);
    for (const std::int32_t v : mesh::fans(draft.triangles, draft.mates).vertex_of) {
        if (met[v] != 0) {
            return false;
        }
        met[v] = 1;
    }
    return true;
}

bool is_fit(const OperandMesh& draft) {
    return all_paired(draft) && !has_fold(draft) && !has_degenerate(draft) && single_fans(draft);
}

/// Puts a vertex in the middle of the edge of h and its mate: (u, v, x) and (v, u, y) become (u, m, x), (m, v, x) and
/// (v, m, y), (m, u, y).
void split_edge(OperandMesh& draft, std::int32_t h) {
    const std::array<std::int32_t, 2> sides{h, draft.mates[h]};
    const auto middle = static_cast<std::int32_t>(draft.vertices.size());
    const Vec3 point = 0.5 * (draft.point(sides[0]) + draft.point(sides[1]));
    const bool single = is_single(draft.point(sides[0])) && is_single(draft.point(sides[1]));
    draft.vertices.push_back(single ? to_single(point) : point);
    std::array<std::int32_t, 2> halves{};
    for (int i = 0; i < 2; ++i) {
        const std::int32_t side = sides[i];
        const std::int32_t half = 3 * static_cast<std::int32_t>(draft.triangles.size()) + side % 3;
        mesh::Triangle triangle = draft.triangles[side / 3];
        draft.triangles[side / 3][mesh::next_corner(side) % 3] = middle;
        triangle[side % 3] = middle;
        draft.triangles.push_back(triangle);
        const std::int32_t source = draft.source[side / 3];
        draft.source.push_back(source);
        draft.mates.resize(3 * draft.triangles.size(), mesh::kBorder);
        const std::int32_t beyond = draft.mates[mesh::next_corner(side)];
        draft.pair(mesh::next_corner(half), beyond);
        draft.pair(mesh::next_corner(side), mesh::previous_corner(half));
        halves[i] = half;
    }
    draft.pair(sides[0], halves[1]);
    draft.pair(sides[1], halves[0]);
}

/// Edges that two pairs of triangles still share, as the triangles at each of their ends form one fan, get a vertex in
/// their middle: one for each pair but the first. Every corner has a mate afterwards. This terminates, as there are no
/// folds: all edges of the new vertex have two triangles, so that each division leaves one pair less.
void part_edges(OperandMesh& draft) {
    bool again = true;
    while (again) {
        again = false;
        const std::vector<std::int32_t> twins = mesh::edge_twins(draft.triangles, draft.vertices.size());
        std::vector<std::array<std::int32_t, 3>> shared;  // low vertex, high vertex, a corner of each pair
        for (std::size_t h = 0; h < twins.size(); ++h) {
            const auto corner = static_cast<std::int32_t>(h);
            if (twins[h] == mesh::kIrregular && corner < draft.mates[h]) {
                const auto [low, high] = std::minmax({draft.tail(corner), draft.head(corner)});
                shared.push_back({low, high, corner});
            }
        }
        std::sort(shared.begin(), shared.end());
        std::vector<char> changed(draft.triangles.size(), 0);  // triangles whose corners may have moved
        for (std::size_t i = 1; i < shared.size(); ++i) {
            const std::int32_t h = shared[i][2];
            if (shared[i][0] != shared[i - 1][0] || shared[i][1] != shared[i - 1][1]) {
                continue;
            }
            again = true;
            if (changed[h / 3] == 0 && changed[draft.mates[h] / 3] == 0) {
                changed[h / 3] = 1;
                changed[draft.mates[h] / 3] = 1;
                split_edge(draft, h);
                changed.resize(draft.triangles.size(), 1);
            }
        }
    }
}

/// How many triangles run opposite to the input.
std::size_t count_flipped(const OperandMesh& draft, const mesh::TriangleMesh& mesh) {
    std::size_t flipped = 0;
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        if (draft.source[t] < 0) {
            continue;
        }
        const mesh::Triangle& now = draft.triangles[t];
        const mesh::Triangle& then = mesh.triangles[draft.source[t]];
        for (int i = 0; i < 3; ++i) {
            flipped += draft.vertices[now[0]] == mesh.vertices[then[i]] &&
                               draft.vertices[now[1]] == mesh.vertices[then[(i + 2) % 3]] &&
                               draft.vertices[now[2]] == mesh.vertices[then[(i + 1) % 3]]
                           ? 1
                           : 0;
        }
    }
    return flipped;
}

/// Removes duplicates and triangles without area.
void remove_doubles(OperandMesh& draft, const Progress* progress) {
    // A swap may make duplicates, and the triangles covered by these may be swapped afterwards.
    for (int round = 0; round < 3; ++round) {
        remove_duplicates(draft);
        draft.find_twins();
        const std::size_t gone = remove_degenerate(draft);
        draft.repairs.degenerate += gone;
        check_cancelled(progress);
        if (gone == 0) {
            break;
        }
        draft.find_twins();
    }
}

void repair(OperandMesh& draft, const Progress* progress) {
    remove_doubles(draft, progress);
    pair_and_orient(draft);
    check_cancelled(progress);
    close_holes(draft, progress);
    check_cancelled(progress);
    draft.repairs.degenerate += remove_degenerate(draft);
    remove_folds(draft);
    split_fans(draft);
    part_edges(draft);
}

/// Closes cracks and repairs. Joined borders that do not make a solid are separated again.
void repair_with_cracks(OperandMesh& draft, double reach, const Progress* progress) {
    OperandMesh apart = draft;
    if (reach > 0.0) {
        close_cracks(draft, reach, progress);
        check_cancelled(progress);
    }
    const std::size_t joined = draft.repairs.cracks;
    try {
        repair(draft, progress);
        return;
    } catch (const InvalidInput&) {
        if (joined == 0) {
            throw;
        }
    }
    draft = std::move(apart);
    repair(draft, progress);
}

}  // namespace

bool Repairs::any() const {
    return welded + degenerate + duplicate + flipped + nonmanifold_edges + nonmanifold_vertices + cracks + holes +
               scraps >
           0;
}

Message Repairs::summary() const {
    const std::size_t counts[] = {welded, degenerate, duplicate, flipped, nonmanifold_edges, nonmanifold_vertices,
                                  cracks, holes,      scraps};
    static_assert(std::size(counts) == std::size(phrases::kRepairs), "two phrases for each kind");
    constexpr std::size_t kHoles = 7;  // in their order
    std::vector<Message> done;
    for (std::size_t k = 0; k < std::size(counts); ++k) {
        if (k == kHoles && holes == 1 && hole_triangles == 1) {
            done.emplace_back(phrases::kOneHole);
        } else if (counts[k] > 0) {
            done.push_back(counted(phrases::kRepairs[k], counts[k], {{"count2", hole_triangles}}));
        }
    }
    return done.empty() ? Message(phrases::kNoRepairs) : mesh::list_of(done);
}

Message Repairs::of_operand(const std::string& name) const {
    return any() ? Message(phrases::kNamed, {{"name", name}, {"phrase", summary()}}) : Message();
}

std::string operand_name(std::size_t index, std::size_t count) {
    return count <= 26 ? std::string("operand ") + static_cast<char>('A' + index)
                       : "operand " + std::to_string(index + 1);
}

bool has_corners_of(const Operand& operand, std::size_t triangle, const mesh::TriangleMesh& input) {
    const std::int32_t source = operand.source[triangle];
    const auto is_corner = [&](std::int32_t v) {
        const mesh::Triangle& c = input.triangles[static_cast<std::size_t>(source)];
        return std::any_of(c.begin(), c.end(), [&](std::int32_t w) {
            return input.vertices[static_cast<std::size_t>(w)] == operand.vertices[static_cast<std::size_t>(v)];
        });
    };
    const mesh::Triangle& corners = operand.triangles[triangle];
    return source >= 0 && std::all_of(corners.begin(), corners.end(), is_corner);
}

namespace {

/// The draft of an operand with its vertices welded.
OperandMesh welded_draft(const mesh::TriangleMesh& mesh, const std::string& name, const Progress* progress) {
    require_usable(mesh, name);
    check_cancelled(progress);
    OperandMesh draft = draft_of(mesh, name);
    check_cancelled(progress);
    weld(draft);
    check_cancelled(progress);
    draft.find_twins();
    check_cancelled(progress);
    return draft;
}

Operand operand_of(OperandMesh& draft, const mesh::TriangleMesh& mesh) {
    if (draft.repairs.flipped > 0) {
        draft.repairs.flipped = count_flipped(draft, mesh);
    }
    return {std::move(draft.vertices), std::move(draft.triangles),
            std::move(draft.source),   draft.repairs,
            draft.largest_move,        {}};
}

/// Components and Euler number of a closed manifold surface: each edge has two triangles.
mesh::SurfaceTopology topology_of(const OperandMesh& draft, std::size_t components) {
    std::vector<char> used(draft.vertices.size(), 0);
    for (const mesh::Triangle& t : draft.triangles) {
        used[t[0]] = used[t[1]] = used[t[2]] = 1;
    }
    const auto faces = static_cast<long>(draft.triangles.size());
    return {components, std::count(used.begin(), used.end(), 1) - faces / 2};
}

void require_some(const OperandMesh& draft) {
    if (draft.triangles.empty()) {
        throw InvalidInput(phrases::kNoEnclosedVolume, {{"name", draft.name}});
    }
}

}  // namespace

Operand prepare_operand(const mesh::TriangleMesh& mesh, const std::string& name, double reach, const Progress* progress,
                        bool oriented) {
    OperandMesh draft = welded_draft(mesh, name, progress);
    if (!is_fit(draft)) {
        repair_with_cracks(draft, reach, progress);
    }
    check_cancelled(progress);
    require_some(draft);
    mesh::SurfaceTopology topology;
    if (!oriented) {
        const std::size_t components = orient_to_bound_volume(draft);
        if (!draft.repairs.any()) {
            topology = topology_of(draft, components);
        }
    }
    Operand operand = operand_of(draft, mesh);
    operand.topology = topology;
    return operand;
}

Operand prepare_open_operand(const mesh::TriangleMesh& mesh, const std::string& name, const Progress* progress) {
    OperandMesh draft = welded_draft(mesh, name, progress);
    remove_doubles(draft, progress);
    require_some(draft);
    OperandMesh turned = draft;
    try {
        pair_and_orient(turned);
        orient_to_bound_volume(turned);
        orient_open_sheets(turned, progress);
        draft = std::move(turned);
        draft.repairs.nonmanifold_edges = 0;  // open operands keep nonmanifold edges
    } catch (const OpenOperand&) {
        check_cancelled(progress);  // a one-sided surface keeps the orientation of its triangles
    }
    return operand_of(draft, mesh);
}

}  // namespace mq::boolean
