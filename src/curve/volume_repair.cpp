// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume_repair.h"

#include <algorithm>

#include "curve/untangle.h"

namespace mq::curve {

namespace {

/// I = min J / max J below which a tetrahedron is worked on.
constexpr double kGoodTetrahedron = 0.15;
/// The least Bernstein coefficient, relative to the straight element, that the optimisation goes for.
constexpr double kTarget = 0.3;
constexpr int kRounds = 3;
constexpr int kSweeps = 15;

class Repair {
  public:
    Repair(Volume& volume, const Progress& progress) : volume_(volume), progress_(progress) {}

    VolumeRepairs run() {
        volume_.measure(volume_.living());
        done_.invalid_before = invalid();
        for (int round = 0; round < kRounds; ++round) {
            const std::vector<int> bad = bad_ones();
            if (bad.empty()) {
                break;
            }
            curve_inside(bad, 2 + round, round);
        }
        done_.invalid_after = invalid();
        return done_;
    }

  private:
    int invalid() const {
        return static_cast<int>(std::count_if(volume_.tetrahedra.begin(), volume_.tetrahedra.end(),
                                              [](const Tetrahedron& t) { return t.alive && !(t.quality > 0.0); }));
    }

    std::vector<int> bad_ones() const {
        std::vector<int> bad;
        for (std::size_t t = 0; t < volume_.tetrahedra.size(); ++t) {
            if (volume_.tetrahedra[t].alive && volume_.tetrahedra[t].quality < kGoodTetrahedron) {
                bad.push_back(static_cast<int>(t));
            }
        }
        return bad;
    }

    /// Bad ones whose surroundings meet share a patch.
    void curve_inside(const std::vector<int>& bad, int layers, int round) {
        std::vector<char> taken(volume_.tetrahedra.size(), 0);
        std::vector<char> marked(volume_.tetrahedra.size(), 0);
        for (const int t : bad) {
            mark_around(t, layers, marked);
        }
        for (const int t : bad) {
            if (taken[static_cast<std::size_t>(t)]) {
                continue;
            }
            progress_.check();
            work_on(component(t, marked, taken), round);
        }
    }

    void mark_around(int t, int layers, std::vector<char>& marked) const {
        marked[static_cast<std::size_t>(t)] = 1;
        std::vector<int> vertices(volume_.tetrahedra[static_cast<std::size_t>(t)].corners.begin(),
                                  volume_.tetrahedra[static_cast<std::size_t>(t)].corners.end());
        std::unordered_set<int> known(vertices.begin(), vertices.end());
        for (int layer = 0; layer < layers; ++layer) {
            std::vector<int> next;
            for (const int v : vertices) {
                for (const int other : volume_.of_vertex(v)) {
                    marked[static_cast<std::size_t>(other)] = 1;
                    for (const int w : volume_.tetrahedra[static_cast<std::size_t>(other)].corners) {
                        if (known.insert(w).second) {
                            next.push_back(w);
                        }
                    }
                }
            }
            vertices = std::move(next);
        }
    }

    /// The marked tetrahedra that hang together with `start` by vertices.
    std::vector<int> component(int start, const std::vector<char>& marked, std::vector<char>& taken) const {
        std::vector<int> result{start};
        taken[static_cast<std::size_t>(start)] = 1;
        for (std::size_t i = 0; i < result.size(); ++i) {
            for (const int v : volume_.tetrahedra[static_cast<std::size_t>(result[i])].corners) {
                for (const int other : volume_.of_vertex(v)) {
                    const auto k = static_cast<std::size_t>(other);
                    if (marked[k] && !taken[k]) {
                        taken[k] = 1;
                        result.push_back(other);
                    }
                }
            }
        }
        std::sort(result.begin(), result.end());
        return result;
    }

    void work_on(const std::vector<int>& members, int round) {
        Patch patch(volume_, members);
        if (round == 0) {
            patch.spread_bulges(kSweeps);
        }
        untangle(patch, kTarget, progress_);
        patch.store();
        ++done_.patches;
    }

    Volume& volume_;
    const Progress& progress_;
    VolumeRepairs done_;
};

}  // namespace

VolumeRepairs repair_volume(Volume& volume, const Progress& progress) {
    return Repair(volume, progress).run();
}

}  // namespace mq::curve
