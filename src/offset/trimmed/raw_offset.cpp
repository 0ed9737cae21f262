// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/trimmed/raw_offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/parallel.h"
#include "mesh/corner_table.h"
#include "mesh/proof/distance_bounds.h"
#include "offset/trimmed/direction_cap.h"
#include "offset/trimmed/tuning.h"

namespace mq::offset {

namespace {

using mesh::next_corner;
using mesh::previous_corner;

/// An arc of more than this angle (radians) gets a direction between its ends that decides on which side it runs.
constexpr double kHalfTurn = 2.9;
/// The cosine of the largest angle between the direction at a vertex and a normal there, whatever the tolerance.
const double kLeastCosine = std::cos(0.5);
/// The largest angle of a step on an arc, whatever the tolerance, radians.
constexpr double kLargestStep = 1.0;

/// The triangles around a vertex in their order, each given by its corner at the vertex.
using Fan = std::vector<std::int32_t>;

class RawOffsetBuilder {
  public:
    RawOffsetBuilder(const ClosedSurface& surface, const RawOffsetOptions& options)
        : surface_(surface), options_(options) {
        const double share = options.tolerance / options.distance;
        least_cosine_ = std::max(1.0 - share, kLeastCosine);
        least_face_cosine_ = std::max(1.0 - options.face_tolerance / options.distance, kLeastCosine);
        // A triangle inscribed in a sphere whose sides have this angle has its centre within the tolerance of the
        // sphere.
        step_ = std::min(std::sqrt(3.0) * std::acos(std::max(1.0 - share, 0.0)), kLargestStep);
    }

    RawOffset run() {
        for (const mesh::Triangle& t : surface_.triangles) {
            const Vec3 cross = (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0]));
            normals_.push_back(cross.normalized());
        }
        node_.assign(surface_.twins.size(), -1);
        arc_.assign(surface_.twins.size(), -1);
        CancelPace pace(options_.progress);
        for (std::int32_t c = 0; c < static_cast<std::int32_t>(node_.size()); ++c) {
            pace.step();
            if (node_[static_cast<std::size_t>(c)] < 0) {
                round_off(fan_of(c));
            }
        }
        for (std::int32_t t = 0; t < static_cast<std::int32_t>(surface_.triangles.size()); ++t) {
            add({node(3 * t), node(3 * t + 1), node(3 * t + 2)}, t);
        }
        for (std::int32_t h = 0; h < static_cast<std::int32_t>(node_.size()); ++h) {
            if (h < twin(h)) {
                add_strip(h);
            }
        }
        draw_in();
        return std::move(result_);
    }

  private:
    const Vec3& point(std::int32_t v) const { return surface_.points[static_cast<std::size_t>(v)]; }
    const Vec3& tail(std::int32_t c) const {
        return point(surface_.triangles[static_cast<std::size_t>(c / 3)][static_cast<std::size_t>(c % 3)]);
    }
    std::int32_t twin(std::int32_t c) const { return surface_.twins[static_cast<std::size_t>(c)]; }
    std::int32_t node(std::int32_t c) const { return node_[static_cast<std::size_t>(c)]; }
    const Vec3& normal(std::int32_t c) const { return normals_[static_cast<std::size_t>(c / 3)]; }
    /// The normal of the CAD face at a corner, that of the triangle where it is not known.
    const Vec3& face_normal(std::int32_t c) const {
        const bool known = !surface_.normals.empty() && !surface_.normals[static_cast<std::size_t>(c)].isZero(0.0);
        return known ? surface_.normals[static_cast<std::size_t>(c)] : normal(c);
    }
    /// The angle of the triangle at a corner.
    double angle(std::int32_t c) const {
        const Vec3 one = tail(next_corner(c)) - tail(c);
        const Vec3 two = tail(previous_corner(c)) - tail(c);
        return std::atan2(one.cross(two).norm(), one.dot(two));
    }

    Fan fan_of(std::int32_t first) const {
        Fan fan;
        std::int32_t c = first;
        do {
            fan.push_back(c);
            c = twin(previous_corner(c));
        } while (c != first);
        return fan;
    }

    void add(const mesh::Triangle& nodes, std::int32_t triangle) {
        if (!mesh::is_collapsed(nodes)) {
            result_.triangles.push_back(nodes);
            result_.source.push_back(surface_.source[static_cast<std::size_t>(triangle)]);
        }
    }

    std::int32_t add_node(const Vec3& place, const Vec3& direction) {
        result_.vertices.push_back(to_single(place + options_.distance * direction));
        base_.push_back(place);
        return static_cast<std::int32_t>(result_.vertices.size()) - 1;
    }

    /// Gives the corners of a fan their directions, joins the directions by arcs, and closes the gap between the arcs.
    void round_off(const Fan& fan) {
        const Runs runs = runs_of(fan);
        const Vec3 place = tail(fan.front()) + options_.extension * conormal(fan);
        for (std::size_t k = 0; k < runs.direction.size(); ++k) {
            run_node_.resize(runs.direction.size());
            run_node_[k] = add_node(place, runs.direction[k]);
        }
        for (std::size_t i = 0; i < fan.size(); ++i) {
            node_[static_cast<std::size_t>(fan[i])] = run_node_[static_cast<std::size_t>(runs.of[i])];
        }
        if (runs.direction.size() > 1) {
            join(fan, runs, place);
        }
    }

    /// The direction in which the border of a sheet is extended at a vertex: the mean of the directions that lead out
    /// of the sheet across its border edges, in which both of its sides meet. Zero at vertices inside.
    Vec3 conormal(const Fan& fan) const {
        Vec3 sum = Vec3::Zero();
        if (options_.extension > 0.0) {
            for (std::size_t i = 0; i < fan.size(); ++i) {
                const std::int32_t h = previous_corner(fan[i]);
                if (is_border(h)) {
                    sum += (tail(next_corner(h)) - tail(h)).normalized().cross(normal(h));
                }
            }
        }
        return sum.isZero(1e-9) ? Vec3(Vec3::Zero()) : Vec3(sum.normalized());
    }

    /// Whether both sides of a sheet meet in the edge of half-edge h.
    bool is_border(std::int32_t h) const { return normal(h).dot(normal(twin(h))) < std::cos(kHalfTurn); }

    /// Groups of consecutive triangles of a fan; each group has one direction.
    struct Runs {
        std::vector<std::int32_t> of;  ///< the run of each triangle of the fan
        std::vector<Vec3> direction;
    };

    /// Divides a fan at its sharpest edges until the direction of each run is near enough to all normals of the run.
    Runs runs_of(const Fan& fan) const {
        const auto count = fan.size();
        std::vector<double> cosine(count);  // cosine of the dihedral angle at the edge before each triangle
        for (std::size_t i = 0; i < count; ++i) {
            cosine[i] = normal(fan[i]).dot(normal(fan[(i + count - 1) % count]));
        }
        Runs runs;
        runs.of.assign(count, 0);
        std::vector<char> cut(count, 0);
        if (std::optional<Vec3> one = direction_of(fan, 0, count)) {
            runs.direction.push_back(*one);
            return runs;
        }
        cut[static_cast<std::size_t>(std::min_element(cosine.begin(), cosine.end()) - cosine.begin())] = 1;
        for (bool again = true; again;) {
            again = false;
            runs.direction.clear();
            const auto start = static_cast<std::size_t>(std::find(cut.begin(), cut.end(), 1) - cut.begin());
            for (std::size_t i = 0; i < count;) {
                std::size_t end = i + 1;
                while (end < count && cut[(start + end) % count] == 0) {
                    ++end;
                }
                if (std::optional<Vec3> one = direction_of(fan, start + i, end - i)) {
                    runs.direction.push_back(*one);
                } else {
                    std::size_t sharpest = i + 1;
                    for (std::size_t k = i + 2; k < end; ++k) {
                        if (cosine[(start + k) % count] < cosine[(start + sharpest) % count]) {
                            sharpest = k;
                        }
                    }
                    cut[(start + sharpest) % count] = 1;
                    again = true;
                }
                for (std::size_t k = i; k < end && !again; ++k) {
                    runs.of[(start + k) % count] = static_cast<std::int32_t>(runs.direction.size()) - 1;
                }
                i = end;
            }
        }
        return runs;
    }

    /// The mean of the normals of CAD faces at a run's corners, weighted by angle, or the direction nearest to that
    /// which the normals of the run's triangles allow; nothing if the mean of these is too far from one of several.
    std::optional<Vec3> direction_of(const Fan& fan, std::size_t first, std::size_t count) const {
        Vec3 of_faces = Vec3::Zero();
        Vec3 of_triangles = Vec3::Zero();
        double length = 0.0;  // mean length of the edges at the vertex
        for (std::size_t i = 0; i < count; ++i) {
            const std::int32_t c = fan[(first + i) % fan.size()];
            of_faces += angle(c) * face_normal(c);
            of_triangles += angle(c) * normal(c);
            length += (tail(next_corner(c)) - tail(c)).norm() / static_cast<double>(count);
        }
        const double sine = std::min(OffsetTuning::kLargestShift * length / options_.distance, 1.0);
        const double shifted = std::sqrt(1.0 - sine * sine);
        const double least_cosine = std::max(least_cosine_, shifted);
        const double of_face = std::min(least_cosine, std::max(least_face_cosine_, shifted));
        of_faces.normalize();
        of_triangles.normalize();
        // At the border of a face all of its triangles may lean to one side of its normal.
        constexpr int kArcSteps = 16;
        for (int step = surface_.normals.empty() ? kArcSteps : 0; step <= kArcSteps; ++step) {
            const Vec3 direction = on_arc(of_faces, of_triangles, static_cast<double>(step) / kArcSteps);
            bool is_near = true;
            for (std::size_t i = 0; i < count && is_near; ++i) {
                is_near = direction.dot(normal(fan[(first + i) % fan.size()])) >= (step == 0 ? of_face : least_cosine);
            }
            if (is_near) {
                return direction;
            }
        }
        return count == 1 ? std::optional<Vec3>(of_triangles) : std::nullopt;
    }

    void join(const Fan& fan, const Runs& runs, const Vec3& place) {
        struct Joint {
            std::int32_t from;
            std::int32_t to;
            std::int32_t edge;  // half-edge towards the vertex, of the triangle before the joint
        };
        std::vector<Joint> joints;
        for (std::size_t i = 0; i < fan.size(); ++i) {
            const std::int32_t from = runs.of[i];
            const std::int32_t to = runs.of[(i + 1) % fan.size()];
            if (from != to) {
                joints.push_back({from, to, previous_corner(fan[i])});
            }
        }
        // Two runs have one arc between them, which the strips at both edges share. If all edges are concave, all that
        // is added at the vertex lies within the offset and is trimmed off: a coarse arc is enough.
        const bool one_arc = joints.size() == 2;
        const bool round =
            std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) { return is_convex(joint.edge); });
        std::vector<Vec3> loop;
        std::vector<std::int32_t> loop_node;
        for (std::size_t j = 0; j < (one_arc ? 1 : joints.size()); ++j) {
            std::vector<std::int32_t> edges{joints[j].edge};
            if (one_arc) {
                edges.push_back(joints[1].edge);
            }
            const Vec3& from = runs.direction[static_cast<std::size_t>(joints[j].from)];
            const Vec3& to = runs.direction[static_cast<std::size_t>(joints[j].to)];
            std::vector<std::int32_t> nodes{run_node_[static_cast<std::size_t>(joints[j].from)]};
            loop.push_back(from);
            loop_node.push_back(nodes.front());
            for (const Vec3& between : round ? arc_between(from, to, edges) : std::vector<Vec3>()) {
                nodes.push_back(add_node(place, between));
                loop.push_back(between);
                loop_node.push_back(nodes.back());
            }
            nodes.push_back(run_node_[static_cast<std::size_t>(joints[j].to)]);
            arc_[static_cast<std::size_t>(joints[j].edge)] = static_cast<std::int32_t>(arcs_.size());
            arcs_.push_back(std::move(nodes));
            if (one_arc) {
                arc_[static_cast<std::size_t>(joints[1].edge)] = static_cast<std::int32_t>(arcs_.size());
                arcs_.emplace_back(arcs_.back().rbegin(), arcs_.back().rend());
            }
        }
        if (!one_arc) {
            close(fan, place, loop, loop_node, round ? step_ : 2.0 * M_PI);
        }
    }

    bool is_convex(std::int32_t h) const {
        const Vec3 along = tail(next_corner(h)) - tail(h);
        return along.dot(normal(h).cross(normal(twin(h)))) > 0.0 || is_border(h);
    }

    /// Directions between two others, in steps that keep the tolerance.
    std::vector<Vec3> arc_between(const Vec3& from, const Vec3& to, const std::vector<std::int32_t>& edges) const {
        Vec3 out = Vec3::Zero();
        for (const std::int32_t h : edges) {
            const Vec3 along = (tail(next_corner(h)) - tail(h)).normalized();
            out += along.cross(normal(h)) - along.cross(normal(twin(h)));
        }
        std::vector<Vec3> result;
        const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
        if (angle > kHalfTurn) {
            const Vec3 middle = out.normalized();
            append_arc(from, middle, result);
            result.push_back(middle);
            append_arc(middle, to, result);
        } else {
            append_arc(from, to, result);
        }
        return result;
    }

    void append_arc(const Vec3& from, const Vec3& to, std::vector<Vec3>& result) const {
        const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
        const int steps = std::max(1, static_cast<int>(std::ceil(angle / step_)));
        for (int i = 1; i < steps; ++i) {
            result.push_back(on_arc(from, to, static_cast<double>(i) / steps));
        }
    }

    /// Closes the loop of arcs around a vertex by a cap on the sphere around it.
    void close(const Fan& fan, const Vec3& place, const std::vector<Vec3>& loop,
               const std::vector<std::int32_t>& loop_node, double step) {
        Vec3 mean = Vec3::Zero();
        double curvature = 2.0 * M_PI;
        for (const std::int32_t c : fan) {
            mean += angle(c) * normal(c);
            curvature -= angle(c);
        }
        const DirectionCap cap = cap_over(loop, mean, curvature, step, options_.progress);
        std::vector<std::int32_t> nodes = loop_node;
        for (std::size_t i = loop.size(); i < cap.directions.size(); ++i) {
            nodes.push_back(add_node(place, cap.directions[i]));
        }
        for (const mesh::Triangle& t : cap.triangles) {
            add({nodes[static_cast<std::size_t>(t[0])], nodes[static_cast<std::size_t>(t[1])],
                 nodes[static_cast<std::size_t>(t[2])]},
                fan.front() / 3);
        }
    }

    /// Adds the strip along an edge that closes the gap between the offsets of its two triangles.
    void add_strip(std::int32_t h) {
        const std::int32_t g = twin(h);
        const std::vector<std::int32_t> at_head = arc_at(h);
        std::vector<std::int32_t> at_tail = arc_at(g);
        std::reverse(at_tail.begin(), at_tail.end());
        std::size_t i = 0;
        std::size_t j = 0;
        while (i + 1 < at_tail.size() || j + 1 < at_head.size()) {
            const bool tail_next =
                j + 1 == at_head.size() ||
                (i + 1 < at_tail.size() && (i + 1) * (at_head.size() - 1) <= (j + 1) * (at_tail.size() - 1));
            add({at_head[j], at_tail[i], tail_next ? at_tail[i + 1] : at_head[j + 1]}, h / 3);
            ++(tail_next ? i : j);
        }
    }

    /// The arc at the head of a half-edge, from the direction of its triangle to that of its twin's; one node if they
    /// are equal.
    std::vector<std::int32_t> arc_at(std::int32_t h) const {
        const std::int32_t arc = arc_[static_cast<std::size_t>(h)];
        return arc < 0 ? std::vector<std::int32_t>{node(next_corner(h))} : arcs_[static_cast<std::size_t>(arc)];
    }

    /// Moves vertices back to the surface if all triangles around them lie within the offset, before and after the
    /// move: nothing of the boundary is lost, and the offsets of small features and folds no longer cross anything.
    void draw_in() {
        const double deep = options_.deep;
        const auto count = static_cast<int>(result_.triangles.size());
        std::vector<char> near(result_.vertices.size(), 0);
        for_chunks(static_cast<int>(near.size()), [&](int v) {
            if (v % 64 == 0) {
                check_cancelled(options_.progress);
            }
            const auto i = static_cast<std::size_t>(v);
            near[i] = options_.searched->tree.any_within(result_.vertices[i], deep, 0) >= 0 ? 1 : 0;
        });
        const std::vector<Vec3> offset = result_.vertices;
        std::vector<char> drawn = near;
        // Triangles with some vertices moved back are tested again; in the first round all triangles are tested.
        std::vector<char> shallow(result_.triangles.size(), 0);
        for (bool first = true, again = true; again; first = false) {
            for_chunks(count, [&](int t) {
                if (t % 64 == 0) {
                    check_cancelled(options_.progress);
                }
                const mesh::Triangle& c = result_.triangles[static_cast<std::size_t>(t)];
                const auto marked = [](const std::vector<char>& list) {
                    return [&list](std::int32_t v) { return list[static_cast<std::size_t>(v)] != 0; };
                };
                bool is_shallow = false;
                if (first) {
                    is_shallow = !std::all_of(c.begin(), c.end(), marked(near)) || !is_deep(c, deep);
                } else if (std::any_of(c.begin(), c.end(), marked(drawn)) &&
                           !std::all_of(c.begin(), c.end(), marked(drawn))) {
                    is_shallow = !is_deep(c, deep);
                }
                shallow[static_cast<std::size_t>(t)] = is_shallow ? 1 : 0;
            });
            again = first;
            for (std::size_t t = 0; t < shallow.size(); ++t) {
                for (const std::int32_t v : result_.triangles[t]) {
                    if (shallow[t] != 0 && drawn[static_cast<std::size_t>(v)] != 0) {
                        drawn[static_cast<std::size_t>(v)] = 0;
                        again = true;
                    }
                }
            }
            for (std::size_t v = 0; v < drawn.size(); ++v) {
                result_.vertices[v] = drawn[v] != 0 ? to_single(base_[v]) : offset[v];
            }
        }
    }

    bool is_deep(const mesh::Triangle& t, double deep) const {
        return mesh::all_nearer(
            {result_.vertices[static_cast<std::size_t>(t[0])], result_.vertices[static_cast<std::size_t>(t[1])],
             result_.vertices[static_cast<std::size_t>(t[2])]},
            *options_.searched, deep);
    }

    const ClosedSurface& surface_;
    const RawOffsetOptions options_;
    double least_cosine_ = 1.0;
    double least_face_cosine_ = 1.0;
    double step_ = 0.0;  ///< largest angle between neighbours on an arc, radians
    std::vector<Vec3> normals_;
    std::vector<std::int32_t> node_;      ///< by corner: its vertex
    std::vector<Vec3> base_;              ///< by vertex: its point on the surface
    std::vector<std::int32_t> run_node_;  ///< by run of the current fan: its vertex
    std::vector<std::int32_t> arc_;       ///< by half-edge: the arc at its head; -1: none
    std::vector<std::vector<std::int32_t>> arcs_;
    RawOffset result_;
};

}  // namespace

RawOffset raw_offset(const ClosedSurface& surface, const RawOffsetOptions& options) {
    return RawOffsetBuilder(surface, options).run();
}

}  // namespace mq::offset
