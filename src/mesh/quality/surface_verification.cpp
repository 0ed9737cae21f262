// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/surface_verification.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/predicates.h"
#include "mesh/corner_table.h"
#include "mesh/intersection/self_intersection.h"
#include "mesh/weld_vertices.h"

namespace mq::mesh {
namespace {

class Verifier {
  public:
    Verifier(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles, std::size_t limit)
        : vertices_(vertices), triangles_(triangles), limit_(limit) {}

    Verification run(const std::vector<std::int32_t>* changed, const Progress* progress) {
        const std::vector<std::int32_t> twins = edge_twins(triangles_, vertices_.size());
        check_cancelled(progress);
        check_edges(twins);
        check_fans(twins);
        check_cancelled(progress);
        check_triangles();
        check_vertices();
        check_cancelled(progress);
        check_contacts(changed, progress);
        measure_volume();
        std::stable_sort(result_.faults.begin(), result_.faults.end(),
                         [](const Fault& a, const Fault& b) { return a.kind < b.kind; });
        return std::move(result_);
    }

  private:
    void add(const Fault& fault) {
        std::size_t& count = result_.count[static_cast<std::size_t>(fault.kind)];
        if (count < limit_) {
            result_.faults.push_back(fault);
        }
        ++count;
    }

    /// Reports one fault for each edge. A triangle that names a vertex twice has no edges; it is degenerate.
    void check_edges(const std::vector<std::int32_t>& twins) {
        struct Entry {
            std::int32_t low;
            std::int32_t high;
            std::int32_t corner;
        };
        std::vector<Entry> entries;
        for (std::size_t h = 0; h < twins.size(); ++h) {
            const Triangle& t = triangles_[h / 3];
            if (twins[h] < 0 && !is_collapsed(t)) {
                const auto [low, high] = std::minmax({t[h % 3], t[(h + 1) % 3]});
                entries.push_back({low, high, static_cast<std::int32_t>(h)});
            }
        }
        std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
            return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.corner < b.corner;
        });
        for (std::size_t i = 0; i < entries.size(); ++i) {
            const Entry& e = entries[i];
            if (i > 0 && e.low == entries[i - 1].low && e.high == entries[i - 1].high) {
                continue;
            }
            const bool open = twins[e.corner] == kBorder;
            const std::int32_t other = open ? -1 : entries[i + 1].corner / 3;
            add({open ? FaultKind::OpenEdge : FaultKind::NonmanifoldEdge,
                 0.5 * (vertices_[e.low] + vertices_[e.high]),
                 {e.corner / 3, other},
                 {e.low, e.high}});
        }
    }

    void check_fans(const std::vector<std::int32_t>& twins) {
        const VertexFans fans = mesh::fans(triangles_, twins);
        if (fans.vertex_of.size() <= used_vertex_count()) {
            return;
        }
        std::vector<std::int32_t> first(vertices_.size(), -1);  // a corner of each vertex
        std::vector<char> reported(vertices_.size(), 0);
        for (std::size_t h = 0; h < fans.fan_of.size(); ++h) {
            const std::int32_t v = triangles_[h / 3][h % 3];
            if (is_collapsed(triangles_[h / 3])) {
                continue;
            }
            if (first[v] < 0) {
                first[v] = static_cast<std::int32_t>(h);
            } else if (fans.fan_of[h] != fans.fan_of[first[v]] && reported[v] == 0) {
                reported[v] = 1;
                add({FaultKind::PinchedVertex,
                     vertices_[v],
                     {first[v] / 3, static_cast<std::int32_t>(h / 3)},
                     {v, -1}});
            }
        }
    }

    std::size_t used_vertex_count() {
        used_.assign(vertices_.size(), 0);
        for (const Triangle& t : triangles_) {
            for (const std::int32_t v : t) {
                used_[v] = 1;
            }
        }
        return static_cast<std::size_t>(std::count(used_.begin(), used_.end(), 1));
    }

    void check_triangles() {
        for (std::size_t k = 0; k < triangles_.size(); ++k) {
            const Triangle& t = triangles_[k];
            if (collinear(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]])) {
                add({FaultKind::DegenerateTriangle, vertices_[t[1]], {static_cast<std::int32_t>(k), -1}, {-1, -1}});
            }
        }
    }

    void check_vertices() {
        const std::vector<std::int32_t> equal = equal_vertices(vertices_);
        std::vector<std::int32_t> known;  // by place with several vertices: the first of them that is used
        for (std::size_t v = 0; v < equal.size(); ++v) {
            if (equal[v] == static_cast<std::int32_t>(v)) {
                continue;
            }
            if (known.empty()) {
                known.assign(vertices_.size(), -1);
                for (std::size_t w = 0; w < equal.size(); ++w) {
                    known[w] = used_[w] != 0 && equal[w] == static_cast<std::int32_t>(w) ? equal[w] : -1;
                }
            }
            if (used_[v] == 0) {
                continue;
            }
            std::int32_t& first = known[equal[v]];
            if (first >= 0) {
                add({FaultKind::CoincidentVertices, vertices_[v], {-1, -1}, {first, static_cast<std::int32_t>(v)}});
            } else {
                first = static_cast<std::int32_t>(v);
            }
        }
    }

    void check_contacts(const std::vector<std::int32_t>* changed, const Progress* progress) {
        const std::size_t limit = 2 * limit_;
        const std::vector<ContactPair> pairs =
            changed == nullptr ? self_intersections(vertices_, triangles_, limit, progress)
                               : self_intersections_with(vertices_, triangles_, *changed, limit, progress);
        for (const ContactPair& pair : pairs) {
            const bool crossing = pair.contact == Contact::Crossing;
            add({crossing ? FaultKind::Crossing : FaultKind::Touching,
                 between(pair.a, pair.b),
                 {pair.a, pair.b},
                 {-1, -1}});
        }
    }

    /// The middle of the intersection of two triangles' boxes.
    Vec3 between(std::int32_t a, std::int32_t b) const {
        Box first;
        Box second;
        for (int i = 0; i < 3; ++i) {
            first.add(vertices_[triangles_[a][i]]);
            second.add(vertices_[triangles_[b][i]]);
        }
        return 0.5 * (first.low.cwiseMax(second.low) + first.high.cwiseMin(second.high));
    }

    void measure_volume() {
        if (triangles_.empty() || result_.count[0] + result_.count[1] > 0) {
            return;
        }
        const Vec3 center = vertices_[triangles_[0][0]];
        double sum = 0.0;
        for (const Triangle& t : triangles_) {
            const Vec3 a = vertices_[t[0]] - center;
            sum += a.dot((vertices_[t[1]] - center).cross(vertices_[t[2]] - center));
        }
        result_.volume = sum / 6.0;
    }

    const std::vector<Vec3>& vertices_;
    const std::vector<Triangle>& triangles_;
    std::size_t limit_;
    std::vector<char> used_;
    Verification result_;
};

}  // namespace

const char* name(FaultKind kind) {
    // The names of the kinds of faults, in their order.
    constexpr const char* kNames[kFaultKinds] = {"open edge",
                                                 "non-manifold edge",
                                                 "pinched vertex",
                                                 "degenerate triangle",
                                                 "coincident vertex",
                                                 "crossing pair of triangles",
                                                 "touching pair of triangles"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::string Verification::summary(const Vec3& origin) const {
    std::string text;
    for (std::size_t k = 0; k < kFaultKinds; ++k) {
        const auto first = std::find_if(faults.begin(), faults.end(),
                                        [k](const Fault& fault) { return static_cast<std::size_t>(fault.kind) == k; });
        if (first == faults.end()) {
            continue;
        }
        const Vec3 p = first->position + origin;
        char line[200];
        std::snprintf(line, sizeof line, "%s%s: %zu, first at (%.6g, %.6g, %.6g) mm", text.empty() ? "" : "; ",
                      name(first->kind), count[k], p.x(), p.y(), p.z());
        text += line;
    }
    return text.empty() ? "none" : text;
}

Verification verify(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles,
                    const std::vector<std::int32_t>* changed, std::size_t limit, const Progress* progress) {
    return Verifier(vertices, triangles, limit).run(changed, progress);
}

}  // namespace mq::mesh
