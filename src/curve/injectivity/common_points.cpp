// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/common_points.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/injectivity/curved_winding.h"
#include "elements/product/element_derivatives.h"
#include "elements/product/node_cells.h"
#include "elements/product/reference_nodes.h"
#include "mesh/intersection/aabb_tree.h"

namespace mq::curve {

using elements::GridPoint;

namespace {

/// A plane with a normal of length 1: points behind it have normal . p <= offset.
struct Plane {
    Vec3 normal;
    double offset;

    double before(const Vec3& p) const { return offset - normal.dot(p); }
};

/// The planes of the faces of a tetrahedron, which lies behind all of them; none if it has no volume.
std::vector<Plane> planes_of(const std::array<Vec3, 4>& corners) {
    std::vector<Plane> planes;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3& a = corners[(k + 1) % 4];
        Vec3 normal = (corners[(k + 2) % 4] - a).cross(corners[(k + 3) % 4] - a);
        const double length = normal.norm();
        if (!(length > 0.0)) {
            return {};
        }
        normal /= normal.dot(corners[k] - a) > 0.0 ? -length : length;
        planes.push_back({normal, normal.dot(a)});
    }
    return planes;
}

/// The mean of the vertices of the intersection of two tetrahedra, if it is farther than `depth` from all of their
/// faces.
std::optional<Vec3> middle_in_common(const std::array<Vec3, 4>& first, const std::array<Vec3, 4>& second,
                                     double depth) {
    std::vector<Plane> planes = planes_of(first);
    const std::vector<Plane> others = planes_of(second);
    if (planes.empty() || others.empty()) {
        return std::nullopt;
    }
    const auto apart = [&](const std::vector<Plane>& some, const std::array<Vec3, 4>& corners) {
        return std::any_of(some.begin(), some.end(), [&](const Plane& plane) {
            return std::none_of(corners.begin(), corners.end(), [&](const Vec3& p) { return plane.before(p) > depth; });
        });
    };
    if (apart(planes, second) || apart(others, first)) {
        return std::nullopt;
    }
    planes.insert(planes.end(), others.begin(), others.end());
    const auto before_all = [&](const Vec3& p, double least) {
        return std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) { return plane.before(p) > least; });
    };
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        for (std::size_t j = i + 1; j < planes.size(); ++j) {
            const Vec3 line = planes[i].normal.cross(planes[j].normal);
            for (std::size_t k = j + 1; k < planes.size(); ++k) {
                const double volume = line.dot(planes[k].normal);
                const Vec3 corner =
                    (planes[i].offset * planes[j].normal.cross(planes[k].normal) +
                     planes[j].offset * planes[k].normal.cross(planes[i].normal) + planes[k].offset * line) /
                    volume;
                if (corner.allFinite() && before_all(corner, -0.5 * depth)) {
                    sum += corner;
                    ++count;
                }
            }
        }
    }
    const Vec3 middle = sum / std::max(count, 1);
    return count > 3 && before_all(middle, depth) ? std::optional<Vec3>(middle) : std::nullopt;
}

/// The elements of all blocks.
class Elements {
  public:
    Elements(const std::vector<Vec3>& nodes, const std::vector<SolidBlock>& blocks) : nodes_(nodes), blocks_(blocks) {
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            const auto per = static_cast<std::size_t>(blocks[b].nodes_per_element);
            if (elements::dimension_of(blocks[b].kind) != 3 || per == 0 || blocks[b].nodes.size() % per != 0) {
                throw InvalidInput(phrases::kNoSolidElements, {{"count", b}, {"count2", per}});
            }
            for (std::size_t first = 0; first < blocks[b].nodes.size(); first += per) {
                place_.emplace_back(b, first);
                add_box(blocks[b].nodes.data() + first, per);
            }
        }
        depth_ = kTouching * (all_.empty() ? 0.0 : all_.largest_side());
    }

    std::size_t size() const { return place_.size(); }
    const std::vector<Vec3>& ends() const { return ends_; }
    const std::vector<mesh::Triangle>& boxes() const { return boxes_; }

    /// A point that is proven to be inside of two elements.
    std::optional<Vec3> common_point(std::int32_t a, std::int32_t b) const {
        const std::vector<Cell> others = cells(b, box(a));
        for (const Cell& first : cells(a, box(b))) {
            for (const Cell& second : others) {
                if (!overlap(first.box, second.box)) {
                    continue;
                }
                const std::optional<Vec3> point = middle_in_common(first.corners, second.corners, depth_);
                if (point && has_inside(a, *point) && has_inside(b, *point)) {
                    return *point + all_.center();
                }
            }
        }
        return std::nullopt;
    }

  private:
    struct Cell {
        std::array<Vec3, 4> corners;
        Box box;
    };

    void add_box(const std::int32_t* element, std::size_t per) {
        Box box;
        for (std::size_t i = 0; i < per; ++i) {
            const std::int32_t node = element[i];
            if (node < 0 || node >= static_cast<std::int32_t>(nodes_.size()) ||
                !nodes_[static_cast<std::size_t>(node)].allFinite()) {
                throw InvalidInput(phrases::kNodeMissing, {{"count", node}});
            }
            box.add(nodes_[static_cast<std::size_t>(node)]);
        }
        all_.add(box.low);
        all_.add(box.high);
        const auto number = static_cast<std::int32_t>(ends_.size());
        ends_.push_back(box.low);
        ends_.push_back(box.high);
        boxes_.push_back(
            {number, number + 1, number});  // a triangle of three corners that has the box between two points
    }
    const SolidBlock& block(std::int32_t e) const { return blocks_[place_[static_cast<std::size_t>(e)].first]; }
    Vec3 node(std::int32_t e, std::int32_t i) const {
        const auto at = place_[static_cast<std::size_t>(e)].second + static_cast<std::size_t>(i);
        return nodes_[static_cast<std::size_t>(block(e).nodes[at])] - all_.center();
    }
    Box box(std::int32_t e) const {
        Box found;
        for (std::int32_t i = 0; i < block(e).nodes_per_element; ++i) {
            found.add(node(e, i));
        }
        return found;
    }
    /// Whether the intersection of two boxes is thicker than `depth_` along each axis.
    bool overlap(const Box& a, const Box& b) const {
        return (a.high.cwiseMin(b.high) - a.low.cwiseMax(b.low)).minCoeff() > depth_;
    }
    /// The tetrahedra of an element that reach into a box. Sides of elements of order 1 may be curved, too.
    std::vector<Cell> cells(std::int32_t e, const Box& within) const {
        const SolidBlock& of = block(e);
        std::vector<Vec3> own;
        for (std::int32_t i = 0; i < of.nodes_per_element; ++i) {
            own.push_back(node(e, i));
        }
        int order = of.order;
        own = elements::all_nodes(of.kind, order, own);
        if (order == 1 && of.kind != elements::ElementKind::Tetrahedron) {
            order = 2;
            own = of_corners(of.kind, own);
        }
        std::vector<Cell> found;
        for (const std::array<int, 4>& part : elements::node_cells(of.kind, order)) {
            Cell cell;
            for (std::size_t k = 0; k < 4; ++k) {
                cell.corners[k] = own[static_cast<std::size_t>(part[k])];
                cell.box.add(cell.corners[k]);
            }
            if (overlap(cell.box, within)) {
                found.push_back(cell);
            }
        }
        return found;
    }
    /// The nodes of order 2 of an element of order 1: each is the mean of the corners that lie symmetrically around it.
    static std::vector<Vec3> of_corners(elements::ElementKind kind, const std::vector<Vec3>& corners) {
        const std::vector<GridPoint> places = elements::gmsh_nodes(kind, 2);
        const auto end = places.begin() + static_cast<std::ptrdiff_t>(corners.size());
        std::vector<Vec3> found;
        for (const GridPoint& p : places) {
            Vec3 sum = Vec3::Zero();
            int count = 0;
            for (std::size_t c = 0; c < corners.size(); ++c) {
                const GridPoint& q = places[c];
                if (std::find(places.begin(), end, GridPoint{2 * p[0] - q[0], 2 * p[1] - q[1], 2 * p[2] - q[2]}) !=
                    end) {
                    sum += corners[c];
                    ++count;
                }
            }
            found.emplace_back(sum / count);
        }
        return found;
    }
    bool has_inside(std::int32_t e, const Vec3& point) const {
        std::vector<Vec3> nodes;
        for (std::int32_t i = 0; i < block(e).nodes_per_element; ++i) {
            nodes.push_back(node(e, i));
        }
        std::vector<SideBlock> sides;
        for (const SolidBlock::Face& face : block(e).faces) {
            sides.push_back({face.kind, face.order, static_cast<int>(face.nodes.size()), face.nodes});
        }
        const SurfacePatches patches(nodes, sides);
        std::vector<std::vector<Vec3>> control;
        for (std::int32_t t = 0; t < static_cast<std::int32_t>(patches.size()); ++t) {
            control.push_back(patches.control(t));
        }
        const std::optional<int> turns =
            curved_winding(patches.lattice(), control, point - patches.middle(), 0.5 * depth_ + patches.rounding());
        return turns && *turns != 0;
    }

    const std::vector<Vec3>& nodes_;
    const std::vector<SolidBlock>& blocks_;
    std::vector<std::pair<std::size_t, std::size_t>> place_;  // by element: its block, and the index of its first node
    std::vector<Vec3> ends_;
    std::vector<mesh::Triangle> boxes_;
    Box all_;
    double depth_ = 0.0;
};

}  // namespace

std::vector<CommonPoint> common_points(const std::vector<Vec3>& nodes, const std::vector<SolidBlock>& blocks,
                                       const std::vector<std::int32_t>& body, Progress* progress) {
    const Elements elements(nodes, blocks);
    if (body.size() != elements.size()) {
        throw InvalidInput(phrases::kOneForEach,
                           {{"name", "body"}, {"count", body.size()}, {"count2", elements.size()}});
    }
    mesh::AabbTree tree(elements.ends(), elements.boxes());
    tree.set_groups(body);
    std::vector<CommonPoint> found;
    std::set<std::pair<std::int32_t, std::int32_t>> known;
    CancelPace pace(progress);
    tree.for_each_own_pair([&](std::int32_t i, std::int32_t j) {
        pace.step();
        const auto a = std::min(i, j);
        const auto b = std::max(i, j);
        const std::int32_t body_a = body[static_cast<std::size_t>(a)];
        const std::int32_t body_b = body[static_cast<std::size_t>(b)];
        const std::pair<std::int32_t, std::int32_t> bodies = std::minmax(body_a, body_b);
        if (body_a == body_b || known.count(bodies) > 0) {
            return;
        }
        if (const std::optional<Vec3> point = elements.common_point(a, b)) {
            known.insert(bodies);
            found.push_back({{a, b}, *point});
        }
    });
    std::sort(found.begin(), found.end(), [](const auto& x, const auto& y) { return x.elements < y.elements; });
    return found;
}

}  // namespace mq::curve
