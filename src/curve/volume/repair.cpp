// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/repair.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "base/tuning.h"
#include "curve/volume/editor.h"
#include "curve/volume/tuning.h"
#include "curve/volume/untangle.h"
#include "elements/bezier/candidate_edges.h"

namespace mq::curve {

namespace {

class Repair {
  public:
    Repair(TetrahedralMesh& volume, const Progress& progress, RepairScope scope)
        : volume_(volume),
          editor_(volume),
          progress_(progress),
          good_(scope == RepairScope::Poor ? VolumeTuning::kGoodTetrahedron : std::numeric_limits<double>::min()),
          freed_(scope == RepairScope::Poor ? 1.0 : good_),
          folded_(volume.surface) {}

    VolumeRepairs run() {
        volume_.measure(volume_.live_tetrahedra(), &progress_);
        done_.invalid_before = invalid();
        for (int round = 0; round < kMostRounds && free_corners(); ++round) {
        }
        curve_single_edges();
        for (int round = 0; round < kMostRounds; ++round) {
            if (round >= moving_round()) {
                improve(bad_ones());
            }
            const std::vector<int> bad = with_attempts_left(bad_ones());
            if (bad.empty()) {
                break;
            }
            curve_inside(bad, round);
        }
        done_.invalid_after = invalid();
        return done_;
    }

  private:
    /// The tetrahedra of a patch, and their vertices that may move.
    struct Around {
        std::vector<int> members;
        std::unordered_set<int> loose;
    };

    /// From this round on the topology may change, and inner vertices of bad elements may move: the mesher knew only
    /// the straight surface, and may have put them between it and the curved one. Orders above 2 have one more round
    /// before it.
    int moving_round() const { return volume_.shapes().order() > 2 ? 2 : 1; }

    int invalid() const { return static_cast<int>(volume_.invalid()); }

    std::vector<int> bad_ones() const {
        std::vector<int> bad;
        for (std::size_t t = 0; t < volume_.tetrahedra.size(); ++t) {
            if (volume_.tetrahedra[t].alive && volume_.tetrahedra[t].quality < good_ &&
                !folded_.has_face_of(volume_.tetrahedra[t].corners)) {
                bad.push_back(static_cast<int>(t));
            }
        }
        return bad;
    }

    /// An element that stays bad although its neighbours are the same is not curved any more. Counts an attempt of each
    /// of the others.
    std::vector<int> with_attempts_left(const std::vector<int>& bad) {
        attempts_.resize(volume_.tetrahedra.size(), 0);
        std::vector<int> result;
        for (const int t : bad) {
            if (attempts_[static_cast<std::size_t>(t)]++ < VolumeTuning::kCurvingAttempts) {
                result.push_back(t);
            }
        }
        return result;
    }

    /// Elements that a single edge or face can repair need no patch. Only where bad elements are few: many together
    /// become better when their edges are curved together.
    void curve_single_edges() {
        const std::vector<int> bad = bad_ones();
        if (static_cast<double>(bad.size()) > VolumeTuning::kFewBad * static_cast<double>(volume_.tetrahedra.size())) {
            return;
        }
        for (const int t : bad) {
            progress_.check();
            const double& quality = volume_.tetrahedra[static_cast<std::size_t>(t)].quality;
            for (int i = 0; i < kMostRounds && quality < good_ && curve_region_edge(editor_, t); ++i) {
                ++done_.curved_edges;
            }
            relocate_faces(t);
        }
    }

    void relocate_faces(int t) {
        const std::array<int, 4> v = editor_.tetrahedron(t).corners;
        for (std::size_t k = 0; k < 4 && editor_.tetrahedron(t).quality < good_; ++k) {
            const bool moved = relocate_face_nodes(editor_, v[(k + 1) % 4], v[(k + 2) % 4], v[(k + 3) % 4]);
            done_.relocated_faces += moved ? 1 : 0;
        }
    }

    /// Bad elements whose surroundings meet share a patch. Patches have no vertex in common.
    void curve_inside(const std::vector<int>& bad, int round) {
        std::vector<char> taken(volume_.tetrahedra.size(), 0);
        std::vector<char> marked(volume_.tetrahedra.size(), 0);
        for (const int t : bad) {
            mark_around(t, round == 0 ? VolumeTuning::kFirstLayers : VolumeTuning::kPatchLayers, marked);
        }
        std::vector<Around> places;
        for (const int t : bad) {
            if (!taken[static_cast<std::size_t>(t)]) {
                Around& place = places.emplace_back();
                place.members = component(t, marked, taken);
                place.loose = round >= moving_round() ? loose_vertices(place.members) : std::unordered_set<int>();
            }
        }
        done_.patches += static_cast<int>(places.size());
        const int order = volume_.shapes().order();
        // Quadratic shapes come first; higher orders start from their result.
        if (order > 2 && round != 1) {
            curve_patches(places, 2, round);
        }
        if (order != 2) {
            const auto left = [&](const Around& place) { return round == 0 || !any_poor(place.members); };
            places.erase(std::remove_if(places.begin(), places.end(), left), places.end());
        }
        curve_patches(places, order, order > 2 ? 1 : round);
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

    /// The marked tetrahedra that are connected with `start` by vertices.
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

    /// Curves patches in parallel, some at a time, as each needs memory. Where there are fewer large ones than threads,
    /// these come one after the other, since several threads work on each.
    void curve_patches(const std::vector<Around>& places, int degree, int round) {
        constexpr std::size_t kLarge = 512;  // tetrahedra
        constexpr std::size_t kOfThread = 16;
        const auto threads = static_cast<std::size_t>(thread_count());
        const auto large = [](const Around& place) { return place.members.size() >= kLarge; };
        const auto count = static_cast<std::size_t>(std::count_if(places.begin(), places.end(), large));
        std::vector<const Around*> together;
        for (const Around& place : places) {
            if (count < threads && large(place)) {
                curve_at_once({&place}, degree, round);
                continue;
            }
            together.push_back(&place);
            if (together.size() == kOfThread * threads) {
                curve_at_once(together, degree, round);
                together.clear();
            }
        }
        curve_at_once(together, degree, round);
    }

    void curve_at_once(const std::vector<const Around*>& places, int degree, int round) {
        std::vector<std::optional<UntanglingPatch>> patches(places.size());
        std::vector<std::size_t> evaluations(places.size());
        parallel_for(static_cast<int>(places.size()), [&](int k) {
            progress_.check();
            const auto i = static_cast<std::size_t>(k);
            UntanglingPatch& patch =
                patches[i].emplace(volume_, places[i]->members, places[i]->loose, degree, progress_);
            if (round == 0) {
                patch.propagate_curvature(VolumeTuning::kInwardSweeps);
            }
            evaluations[i] = untangle(patch, VolumeTuning::kTargetJacobian, progress_);
        });
        for (std::size_t i = 0; i < places.size(); ++i) {
            done_.evaluations += evaluations[i];
            done_.relocations += patches[i]->store(progress_);
        }
    }

    bool any_poor(const std::vector<int>& members) const {
        return std::any_of(members.begin(), members.end(),
                           [&](int t) { return volume_.tetrahedra[static_cast<std::size_t>(t)].quality < good_; });
    }

    /// Inner vertices of bad elements, all of whose elements are members.
    std::unordered_set<int> loose_vertices(const std::vector<int>& members) const {
        std::unordered_set<int> loose;
        for (const int t : members) {
            const Tetrahedron& tetrahedron = volume_.tetrahedra[static_cast<std::size_t>(t)];
            for (const int v : tetrahedron.corners) {
                const bool inner = volume_.shapes().vertices[static_cast<std::size_t>(v)].entity[0] == 3;
                if (inner && tetrahedron.quality < good_) {
                    loose.insert(v);
                }
            }
        }
        return loose;
    }

    /// @return whether anything changed.
    bool free_corners() {
        bool any = false;
        for (std::size_t t = 0; t < volume_.tetrahedra.size(); ++t) {
            const Tetrahedron& tetrahedron = volume_.tetrahedra[t];
            if (tetrahedron.alive && tetrahedron.quality < freed_ && !folded_.has_face_of(tetrahedron.corners) &&
                volume_.curved(tetrahedron.corners) &&
                editor_.fixed_score(tetrahedron.corners) < VolumeTuning::kFreeCorner) {
                progress_.check();
                any = change(static_cast<int>(t), VolumeEditor::Rule::Free) || any;
            }
        }
        return any;
    }

    /// Changes the topology around bad elements, except where that failed before and the neighbours are still the same.
    void improve(const std::vector<int>& bad) {
        for (const int t : bad) {
            const auto k = static_cast<std::size_t>(t);
            settled_.resize(volume_.tetrahedra.size(), 0);
            if (!volume_.tetrahedra[k].alive || settled_[k] != 0) {
                continue;
            }
            progress_.check();
            const std::array<int, 4> v = volume_.tetrahedra[k].corners;
            if (change(t, VolumeEditor::Rule::Improve)) {
                reopen_around(v);
            } else {
                settled_[k] = 1;
            }
        }
    }

    /// The elements around a change may be tried again.
    void reopen_around(const std::array<int, 4>& corners) {
        settled_.resize(volume_.tetrahedra.size(), 0);
        attempts_.resize(volume_.tetrahedra.size(), 0);
        for (const int v : corners) {
            for (const int t : volume_.of_vertex(v)) {
                settled_[static_cast<std::size_t>(t)] = 0;
                attempts_[static_cast<std::size_t>(t)] = 0;
            }
        }
    }

    bool change(int t, VolumeEditor::Rule rule) {
        const std::array<int, 4> v = volume_.tetrahedra[static_cast<std::size_t>(t)].corners;
        return swap(v, rule) || (rule == VolumeEditor::Rule::Improve && collapse(v)) || split(t, v, rule);
    }

    bool swap(const std::array<int, 4>& v, VolumeEditor::Rule rule) {
        // The edges found by the locality rules come first.
        std::vector<Vec3> control;
        volume_.shapes().tetrahedron(v, control);
        const elements::CandidateEdges blamed =
            elements::candidate_edges(elements::Lattice::of(3, volume_.shapes().order()), control);
        for (const bool first : {true, false}) {
            std::size_t edge = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t k = i + 1; k < 4; ++k, ++edge) {
                    if (blamed[edge] == first && swap_region_edge(editor_, v[i], v[k], rule)) {
                        ++done_.edge_swaps;
                        return true;
                    }
                }
            }
        }
        for (std::size_t i = 0; i < 4; ++i) {
            if (swap_region_face(editor_, v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4], rule)) {
                ++done_.face_swaps;
                return true;
            }
        }
        return false;
    }

    bool collapse(const std::array<int, 4>& v) {
        for (const int a : v) {
            for (const int b : v) {
                if (a != b && collapse_region_edge(editor_, a, b)) {
                    ++done_.collapses;
                    return true;
                }
            }
        }
        return false;
    }

    bool split(int t, const std::array<int, 4>& v, VolumeEditor::Rule rule) {
        bool done = false;
        for (std::size_t i = 0; i < 4 && !done; ++i) {
            for (std::size_t k = i + 1; k < 4 && !done; ++k) {
                done = split_region_edge(editor_, v[i], v[k], rule);
            }
        }
        for (std::size_t i = 0; i < 4 && !done; ++i) {
            done = split_region_face(editor_, v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4], rule);
        }
        done = done || split_region(editor_, t, rule);
        done_.splits += done ? 1 : 0;
        return done;
    }

    TetrahedralMesh& volume_;
    VolumeEditor editor_;
    const Progress& progress_;
    double good_;   // quality from which tetrahedra stay as they are
    double freed_;  // quality from which corners with three fixed edges stay as they are
    FoldedTriangles folded_;
    std::vector<int> attempts_;  // by tetrahedron: how often a patch was made for it
    std::vector<char> settled_;  // by tetrahedron: no change of the topology helps
    VolumeRepairs done_;
};

}  // namespace

VolumeRepairs repair_volume(TetrahedralMesh& volume, const Progress& progress, RepairScope scope) {
    return Repair(volume, progress, scope).run();
}

}  // namespace mq::curve
