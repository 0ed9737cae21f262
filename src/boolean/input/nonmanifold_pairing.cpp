// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "boolean/input/operand_mesh.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::boolean {
namespace {

/// The corners of one undirected edge.
using EdgeGroup = std::vector<std::int32_t>;

std::vector<EdgeGroup> irregular_edges(const OperandMesh& draft) {
    struct Entry {
        std::int32_t low;
        std::int32_t high;
        std::int32_t corner;
    };
    std::vector<Entry> entries;
    for (std::size_t h = 0; h < draft.mates.size(); ++h) {
        if (draft.mates[h] == mesh::kIrregular) {
            const auto corner = static_cast<std::int32_t>(h);
            const auto [low, high] = std::minmax({draft.tail(corner), draft.head(corner)});
            entries.push_back({low, high, corner});
        }
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.corner < b.corner;
    });
    std::vector<EdgeGroup> groups;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i == 0 || entries[i].low != entries[i - 1].low || entries[i].high != entries[i - 1].high) {
            groups.emplace_back();
        }
        groups.back().push_back(entries[i].corner);
    }
    return groups;
}

/// Reverses the triangles of each patch (connected over mates) so that they agree; the majority stays unchanged.
class PatchOrientation {
  public:
    explicit PatchOrientation(OperandMesh& draft) : draft_(draft), turn_(draft.triangles.size(), kUnknown) {}

    /// @return corners whose orientation contradicts that of their mates, as the surface is one-sided; one corner of
    /// each pair.
    std::vector<std::int32_t> run() {
        std::vector<std::int32_t> conflicts;
        for (std::size_t t = 0; t < turn_.size(); ++t) {
            if (turn_[t] == kUnknown) {
                flood(static_cast<std::int32_t>(t), conflicts);
            }
        }
        draft_.turn(turn_);
        for (std::int32_t& h : conflicts) {
            h = turn_[h / 3] != 0 ? OperandMesh::turned(h) : h;
        }
        return conflicts;
    }

  private:
    /// The orientation of the triangle is not decided yet.
    static constexpr char kUnknown = 2;

    bool same_way(std::int32_t h, std::int32_t g) const { return draft_.tail(h) == draft_.tail(g); }

    void flood(std::int32_t start, std::vector<std::int32_t>& conflicts) {
        std::vector<std::int32_t> patch{start};
        std::size_t turned = 0;
        turn_[start] = 0;
        for (std::size_t i = 0; i < patch.size(); ++i) {
            for (std::int32_t h = 3 * patch[i]; h < 3 * patch[i] + 3; ++h) {
                const std::int32_t g = draft_.mates[h];
                if (g < 0) {
                    continue;
                }
                const char wanted = static_cast<char>(turn_[patch[i]] ^ static_cast<char>(same_way(h, g)));
                if (turn_[g / 3] == kUnknown) {
                    turn_[g / 3] = wanted;
                    turned += wanted;
                    patch.push_back(g / 3);
                } else if (turn_[g / 3] != wanted && h < g) {
                    conflicts.push_back(h);
                }
            }
        }
        if (2 * turned > patch.size()) {
            for (const std::int32_t t : patch) {
                turn_[t] ^= 1;
            }
        }
    }

    OperandMesh& draft_;
    std::vector<char> turn_;
};

/// A triangle at an edge, as seen on the way around the edge.
struct Leaf {
    double angle;
    bool upward;  ///< runs along the edge from the lower to the higher vertex: the solid lies at smaller angles
    std::int32_t corner;
    double raggedness;  ///< raggedness of its patch
};

/// The raggedness of each triangle's patch: (length of its free border)^2 / area.
std::vector<double> raggedness(const OperandMesh& draft) {
    const mesh::Components patches = mesh::components(draft.mates);
    std::vector<double> border(patches.count, 0.0);
    std::vector<double> area(patches.count, 0.0);
    for (std::size_t h = 0; h < draft.mates.size(); ++h) {
        const auto corner = static_cast<std::int32_t>(h);
        if (draft.mates[h] == mesh::kBorder) {
            border[patches.component_of[h / 3]] +=
                (draft.point(mesh::next_corner(corner)) - draft.point(corner)).norm();
        }
        if (h % 3 == 0) {
            area[patches.component_of[h / 3]] += draft.area(corner / 3);
        }
    }
    std::vector<double> result(draft.triangles.size());
    for (std::size_t t = 0; t < result.size(); ++t) {
        const std::int32_t patch = patches.component_of[t];
        result[t] = border[patch] * border[patch] / area[patch];
    }
    return result;
}

std::vector<Leaf> leaves_around(const OperandMesh& draft, const EdgeGroup& group, const std::vector<double>& ragged) {
    const auto [low, high] = std::minmax({draft.tail(group[0]), draft.head(group[0])});
    const Vec3 axis = (draft.vertices[high] - draft.vertices[low]).normalized();
    Vec3 x = Vec3::Zero();
    std::vector<Leaf> leaves;
    for (const std::int32_t h : group) {
        const Vec3 arm = draft.point(mesh::previous_corner(h)) - draft.vertices[low];
        const Vec3 out = arm - arm.dot(axis) * axis;
        if (x.isZero(0.0)) {
            x = out.normalized();
        }
        leaves.push_back({std::atan2(axis.cross(x).dot(out), x.dot(out)), draft.tail(h) == low, h, ragged[h / 3]});
    }
    // At equal angles triangles that end a solid come first, so that no sheet without thickness arises.
    std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
        return a.angle != b.angle ? a.angle < b.angle : a.upward != b.upward ? a.upward : a.corner < b.corner;
    });
    return leaves;
}

/// The surplus leaf among those that run `way`: the leaf of a fin, whose border is by far the most ragged; if there is
/// none, and two consecutive leaves both begin a solid or both end one, the inner leaf of the two, for example an inner
/// wall.
std::size_t surplus_leaf(const std::vector<Leaf>& leaves, bool way) {
    std::size_t inside = leaves.size();
    std::size_t most = leaves.size();
    double second = 0.0;
    for (std::size_t k = 0; k < leaves.size(); ++k) {
        if (leaves[k].upward != way) {
            continue;
        }
        const std::size_t before = (k + leaves.size() - 1) % leaves.size();
        if (inside == leaves.size() && leaves[before].upward == way) {
            inside = way ? before : k;
        }
        if (most == leaves.size() || leaves[k].raggedness > leaves[most].raggedness) {
            second = most == leaves.size() ? 0.0 : leaves[most].raggedness;
            most = k;
        } else {
            second = std::max(second, leaves[k].raggedness);
        }
    }
    return leaves[most].raggedness > 2.0 * second ? most : inside;
}

/// Removes leaves until as many run in one direction as in the other.
std::vector<Leaf> remove_surplus(std::vector<Leaf>& leaves) {
    std::vector<Leaf> surplus;
    const auto upward = std::count_if(leaves.begin(), leaves.end(), [](const Leaf& leaf) { return leaf.upward; });
    const bool way = 2 * upward > static_cast<std::ptrdiff_t>(leaves.size());
    for (auto excess = std::abs(2 * upward - static_cast<std::ptrdiff_t>(leaves.size())); excess > 0; --excess) {
        const auto k = static_cast<std::ptrdiff_t>(surplus_leaf(leaves, way));
        surplus.push_back(leaves[k]);
        leaves.erase(leaves.begin() + k);
    }
    return surplus;
}

/// Going around the edge, a triangle behind which the solid begins (running downward) pairs with the next one, not yet
/// taken, that ends it (running upward): like brackets on a circle. As many run up as down.
void pair_brackets(OperandMesh& draft, const std::vector<Leaf>& leaves) {
    std::vector<std::int32_t> open;
    std::vector<char> taken(leaves.size(), 0);
    for (std::size_t i = 0; i < 2 * leaves.size(); ++i) {
        const std::size_t k = i % leaves.size();
        if (!leaves[k].upward) {
            if (i < leaves.size()) {
                open.push_back(leaves[k].corner);
            }
        } else if (taken[k] == 0 && !open.empty()) {
            taken[k] = 1;
            draft.pair(open.back(), leaves[k].corner);
            open.pop_back();
        }
    }
}

/// Two remaining triangles are paired, too, whatever their directions; three or more are on the border.
void pair_leaves(OperandMesh& draft, std::vector<Leaf> leaves) {
    const std::vector<Leaf> surplus = remove_surplus(leaves);
    pair_brackets(draft, leaves);
    if (surplus.size() == 2) {
        draft.pair(surplus[0].corner, surplus[1].corner);
        return;
    }
    for (const Leaf& leaf : surplus) {
        draft.mates[leaf.corner] = mesh::kBorder;
        if (!leaves.empty()) {
            draft.attached.push_back(leaf.corner / 3);
        }
    }
}

}  // namespace

void pair_and_orient(OperandMesh& draft) {
    const std::vector<EdgeGroup> groups = irregular_edges(draft);
    if (groups.empty()) {
        return;
    }
    bool crowded = false;
    for (const EdgeGroup& group : groups) {
        if (group.size() == 2) {
            draft.pair(group[0], group[1]);
        } else {
            crowded = true;
        }
    }
    const std::vector<std::int32_t> one_sided = PatchOrientation(draft).run();
    if (!one_sided.empty()) {
        throw OpenOperand(phrases::kOneSided,
                          {{"name", draft.name}, {"point", draft.position(draft.point(one_sided[0]))}});
    }
    if (!crowded) {
        return;
    }
    const std::vector<double> ragged = raggedness(draft);
    for (const EdgeGroup& group : irregular_edges(draft)) {
        ++draft.repairs.nonmanifold_edges;
        pair_leaves(draft, leaves_around(draft, group, ragged));
    }
    for (const std::int32_t h : PatchOrientation(draft).run()) {
        if (draft.mates[h] >= 0) {
            draft.mates[draft.mates[h]] = mesh::kBorder;
            draft.mates[h] = mesh::kBorder;
        }
    }
}

}  // namespace mq::boolean
