// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/arrangement.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "base/parallel.h"
#include "boolean/arrangement/triangle_intersection.h"
#include "boolean/arrangement/triangle_subdivision.h"

namespace mq::boolean {

namespace {

/// Joins the pairs of triangles that overlap in a common plane to clusters; each is a list of triangles, ascending.
std::vector<std::vector<std::int32_t>> clusters_of(const std::vector<std::pair<std::int32_t, std::int32_t>>& pairs) {
    std::vector<std::int32_t> members;
    for (const auto& [a, b] : pairs) {
        members.insert(members.end(), {a, b});
    }
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    const auto place = [&](std::int32_t t) {
        return static_cast<std::int32_t>(std::lower_bound(members.begin(), members.end(), t) - members.begin());
    };
    DisjointSets<std::int32_t> sets(members.size());
    for (const auto& [a, b] : pairs) {
        sets.unite(place(a), place(b));
    }
    std::int32_t count = 0;
    const std::vector<std::int32_t> number = sets.number(count);
    std::vector<std::vector<std::int32_t>> result(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < members.size(); ++i) {
        result[static_cast<std::size_t>(number[i])].push_back(members[i]);
    }
    return result;
}

/// The soup's vertices that lie on edges or in faces of other triangles.
std::vector<std::int32_t> vertices_on_others(const PointTable& points, const Incidences& found) {
    std::vector<std::int32_t> result;
    const auto add = [&](const std::vector<std::int32_t>& list) {
        std::copy_if(list.begin(), list.end(), std::back_inserter(result),
                     [&](std::int32_t p) { return points.given(p); });
    };
    for (const auto& entry : found.on_edge) {
        add(entry.second);
    }
    for (const auto& entry : found.in_face) {
        add(entry.second);
    }
    return result;
}

/// Replaces points in the same place by one of them.
void make_canonical(const std::vector<std::int32_t>& canonical, Incidences& found) {
    const auto clean = [&](std::vector<std::int32_t>& list) {
        for (std::int32_t& p : list) {
            p = canonical[static_cast<std::size_t>(p)];
        }
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    };
    for (auto& entry : found.on_edge) {
        clean(entry.second);
    }
    for (auto& entry : found.in_face) {
        clean(entry.second);
    }
    for (auto& entry : found.segments) {
        for (Segment& s : entry.second) {
            s.from = canonical[static_cast<std::size_t>(s.from)];
            s.to = canonical[static_cast<std::size_t>(s.to)];
        }
    }
}

/// Which triangles are divided: those with points or segments in them or on their edges.
std::vector<char> divided_triangles(const Soup& soup, const Incidences& found) {
    std::vector<char> end_of_edge(soup.vertices.size(), 0);
    for (const auto& entry : found.on_edge) {
        for (const std::int32_t v : entry.first) {
            end_of_edge[static_cast<std::size_t>(v)] = 1;
        }
    }
    std::vector<char> divided(soup.triangles.size(), 0);
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const Triangle& t = soup.triangles[i];
        for (std::size_t k = 0; k < 3 && divided[i] == 0; ++k) {
            const std::int32_t a = t[k];
            const std::int32_t b = t[(k + 1) % 3];
            divided[i] = end_of_edge[static_cast<std::size_t>(a)] != 0 &&
                         end_of_edge[static_cast<std::size_t>(b)] != 0 && found.on_edge.count(edge_key(a, b)) > 0;
        }
    }
    for (const auto& entry : found.in_face) {
        divided[static_cast<std::size_t>(entry.first)] = 1;
    }
    for (const auto& entry : found.segments) {
        divided[static_cast<std::size_t>(entry.first)] = 1;
    }
    return divided;
}

/// The pieces of all divided triangles and clusters, and the triangles that stay whole.
class Divider {
  public:
    Divider(const Soup& soup, const Incidences& found, Arrangement& result, const Progress& progress)
        : soup_(soup), found_(found), result_(result), progress_(progress) {}

    void run(std::vector<char> gone, std::vector<std::vector<std::int32_t>> clusters) {
        std::vector<char> divided = divided_triangles(soup_, found_);
        for (const std::vector<std::int32_t>& cluster : clusters) {
            for (const std::int32_t t : cluster) {
                gone[static_cast<std::size_t>(t)] = 1;
            }
        }
        result_.faces.reserve(soup_.triangles.size());
        for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
            if (gone[t] == 0 && divided[t] == 0) {
                result_.faces.push_back({soup_.triangles[t], static_cast<std::int32_t>(t), -1, true});
            }
        }
        std::vector<Task> tasks;
        for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
            if (gone[t] == 0 && divided[t] != 0) {
                tasks.push_back({static_cast<std::int32_t>(t), nullptr});
            }
        }
        for (const std::vector<std::int32_t>& cluster : clusters) {
            tasks.push_back({-1, &cluster});
        }
        divide(tasks);
    }

  private:
    /// The task of one thread: to divide one triangle, or one cluster.
    struct Task {
        std::int32_t triangle;
        const std::vector<std::int32_t>* cluster;
    };

    /// Divides all tasks in parallel, and appends the pieces in the order of the tasks.
    void divide(const std::vector<Task>& tasks) {
        constexpr std::size_t kTasksAtOnce = 16384;  // divided tasks held in memory at once; bounds the memory
        // Tasks in one parallel job: enough that starting a job costs little beside its work.
        constexpr std::size_t kBlock = 64;
        for (std::size_t first = 0; first < tasks.size(); first += kTasksAtOnce) {
            const std::int32_t known = result_.points.size();
            std::vector<FaceDivision> done(std::min(kTasksAtOnce, tasks.size() - first));
            parallel_for(static_cast<int>((done.size() + kBlock - 1) / kBlock), [&](int block) {
                progress_.check();
                const std::size_t from = kBlock * static_cast<std::size_t>(block);
                for (std::size_t i = from; i < std::min(from + kBlock, done.size()); ++i) {
                    const Task& task = tasks[first + i];
                    done[i] = task.cluster != nullptr
                                  ? divide_cluster(soup_, *task.cluster, found_, result_.points, &progress_)
                                  : divide_triangle(soup_, task.triangle, found_, result_.points, &progress_);
                }
            });
            for (FaceDivision& division : done) {
                append(std::move(division), known);
            }
        }
    }

    /// Appends the pieces of one division, which numbered its crossings as if they were the first after the `known`
    /// points.
    void append(FaceDivision&& division, std::int32_t known) {
        const std::int32_t shift = result_.points.size() - known;
        for (ExactPoint& p : division.crossings) {
            result_.points.add(std::move(p));
        }
        for (DividedFace& f : division.faces) {
            for (std::int32_t& p : f.points) {
                p += p >= known ? shift : 0;
            }
        }
        for (DividedFace& f : division.faces) {
            Face face{f.points, f.covers.front().triangle, -1, false};
            if (f.covers.front().turn < 0) {
                std::swap(face.points[1], face.points[2]);
                for (CoplanarCover& cover : f.covers) {
                    cover.turn = -cover.turn;
                }
            }
            if (f.covers.size() > 1) {
                face.stack = static_cast<std::int32_t>(result_.stacks.size());
                result_.stacks.push_back(std::move(f.covers));
            }
            result_.faces.push_back(face);
        }
    }

    const Soup& soup_;
    const Incidences& found_;
    Arrangement& result_;
    const Progress& progress_;
};

/// A coincident triangle covers the faces of the triangle on which it lies.
void add_twins(const std::vector<CoincidentTriangle>& twins, Arrangement& result) {
    std::map<std::int32_t, std::vector<CoplanarCover>> on;
    for (const CoincidentTriangle& twin : twins) {
        on[twin.of].push_back({twin.triangle, twin.turn});
    }
    if (on.empty()) {
        return;
    }
    for (Face& face : result.faces) {
        std::vector<CoplanarCover> covers{{face.source, 1}};
        if (face.stack >= 0) {
            covers = result.stacks[static_cast<std::size_t>(face.stack)];
        }
        const std::size_t before = covers.size();
        for (std::size_t i = 0; i < before; ++i) {
            const auto found = on.find(covers[i].triangle);
            if (found != on.end()) {
                for (const CoplanarCover& twin : found->second) {
                    covers.push_back({twin.triangle, twin.turn * covers[i].turn});
                }
            }
        }
        if (covers.size() > before) {
            face.stack = face.stack >= 0 ? face.stack : static_cast<std::int32_t>(result.stacks.size());
            result.stacks.resize(std::max(result.stacks.size(), static_cast<std::size_t>(face.stack) + 1));
            result.stacks[static_cast<std::size_t>(face.stack)] = std::move(covers);
        }
    }
}

/// Removes the faces whose covers cancel each other, as between two folds of one operand's surface: they divide
/// nothing.
void remove_cancelled(const Soup& soup, Arrangement& result) {
    const auto cancelled = [&](const Face& face) {
        if (face.stack < 0) {
            return false;
        }
        std::map<std::int32_t, int> sum;  // the sum of the covers' turns, by operand
        for (const CoplanarCover& cover : result.stacks[static_cast<std::size_t>(face.stack)]) {
            sum[soup.source[static_cast<std::size_t>(cover.triangle)].operand] += cover.turn;
        }
        return std::all_of(sum.begin(), sum.end(), [](const auto& entry) { return entry.second == 0; });
    };
    result.faces.erase(std::remove_if(result.faces.begin(), result.faces.end(), cancelled), result.faces.end());
}

}  // namespace

Arrangement arrange(const Soup& soup, const std::vector<CoincidentTriangle>& twins,
                    const std::vector<std::array<std::int32_t, 2>>& crossing, const Progress& progress) {
    // Triangles between two checks for cancellation.
    constexpr std::size_t kBetweenChecks = 1024;
    Arrangement result{PointTable(soup), {}, {}};
    std::vector<char> gone(soup.triangles.size(), 0);
    for (const CoincidentTriangle& twin : twins) {
        gone[static_cast<std::size_t>(twin.triangle)] = 1;
    }
    Incidences found;
    for (std::size_t i = 0; i < crossing.size(); ++i) {
        if (i % kBetweenChecks == 0) {
            progress.check();
        }
        intersect(soup, crossing[i][0], crossing[i][1], result.points, found);
    }
    make_canonical(result.points.canonical(vertices_on_others(result.points, found)), found);
    Divider(soup, found, result, progress).run(std::move(gone), clusters_of(found.overlapping));
    const std::vector<std::int32_t> canonical = result.points.canonical();
    for (Face& face : result.faces) {
        for (std::int32_t& p : face.points) {
            p = canonical[static_cast<std::size_t>(p)];
        }
    }
    add_twins(twins, result);
    remove_cancelled(soup, result);
    return result;
}

}  // namespace mq::boolean
