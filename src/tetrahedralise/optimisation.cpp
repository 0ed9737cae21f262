// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tetrahedralise/optimisation.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "tetrahedralise/tuning.h"

namespace mq::tetrahedralise {

Optimisation::Optimisation(Tetrahedralisation& mesh, const EndTangents& tangents, int first_inner,
                           const SizeField* field)
    : mesh_(mesh), measure_(mesh, tangents, field), first_inner_(first_inner) {
    tried_.resize(mesh.cells.size(), 0);
    settled_.resize(mesh.points.size(), 0);
    changed_in_.resize(mesh.cells.size(), 0);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
        quality_.push_back(mesh.alive(static_cast<int>(c)) ? measure_.at(mesh.cells[c].v) : 1.0);
    }
    for (int thread = 0; thread < thread_count(); ++thread) {
        planners_.emplace_back(mesh_, measure_, quality_);
    }
}

void Optimisation::run(const Progress& progress) {
    for (int sweep = 0; sweep < TetrahedralisationTuning::kSweeps; ++sweep) {
        const bool flipped = flip_cells(progress);
        const bool moved = move_vertices(progress);
        const bool inserted = sweep >= TetrahedralisationTuning::kFirstInsertion && insert_vertices(progress);
        if (sweep >= TetrahedralisationTuning::kFirstInsertion && !flipped && !moved && !inserted) {
            break;
        }
    }
}

/// Queues changed cells and their neighbours for another attempt.
void Optimisation::note(const std::vector<int>& changed) {
    quality_.resize(mesh_.cells.size(), 1.0);
    tried_.resize(mesh_.cells.size(), 0);
    settled_.resize(mesh_.points.size(), 0);
    changed_in_.resize(mesh_.cells.size(), 0);
    for (const int c : changed) {
        quality_[c] = measure_.at(mesh_.cells[c].v);
        changed_in_[c] = block_;
        tried_[c] = 0;
        for (const int other : mesh_.cells[c].n) {
            if (other >= 0) {
                tried_[other] = 0;
            }
        }
        for (const int v : mesh_.cells[c].v) {
            settled_[v] = 0;
        }
    }
}

/// Plans and applies one change after another for those of the items begin .. end - 1 for which `wanted` is true.
/// Several threads plan a block of changes ahead; a plan is made again if an earlier change of its block has changed
/// cells that it depends on, so that the result is the same for any number of threads.
/// @return whether anything was changed
template <typename Wanted, typename Plan, typename Apply>
bool Optimisation::sweep(std::size_t begin, std::size_t end, const Progress& progress, const Wanted& wanted,
                         const Plan& plan, const Apply& apply) {
    // Least number of plans of a thread in a block, so that starting it pays. Blocks grow until one plan in kAgain has
    // to be made again.
    constexpr std::size_t kLeastPlans = 4;
    constexpr std::size_t kMostPlans = 256;
    constexpr std::size_t kAgain = 8;
    const std::size_t threads = planners_.size();
    std::size_t ahead = threads > 1 ? kLeastPlans * threads : 0;
    std::vector<Change> plans;
    std::vector<std::size_t> planned;
    bool any = false;
    while (begin < end) {
        planned.clear();
        std::size_t last = ahead > 0 ? begin : end;
        for (; last < end && planned.size() < ahead; ++last) {
            if (wanted(last)) {
                planned.push_back(last);
            }
        }
        plans.resize(std::max(plans.size(), planned.size() + 1));  // the last plan is for items without a valid one
        ++block_;
        parallel_for_on_threads(static_cast<int>(planned.size()), [&](int thread, int k) {
            progress.check();
            const auto i = static_cast<std::size_t>(k);
            plan(planners_[static_cast<std::size_t>(thread)], planned[i], plans[i]);
        });
        std::size_t next = 0;
        std::size_t again = 0;
        for (; begin < last; ++begin) {
            const bool has_plan = next < planned.size() && planned[next] == begin;
            Change& change = has_plan ? plans[next++] : plans.back();
            if (!wanted(begin)) {
                continue;
            }
            progress.check();
            const auto changed = [&](int cell) { return changed_in_[cell] == block_; };
            if (!has_plan || std::any_of(change.read.begin(), change.read.end(), changed)) {
                plan(planners_.front(), begin, change);
                ++again;
            }
            apply(begin, change);
            any = change.helps || any;
        }
        ahead = kAgain * again > planned.size() ? std::max(ahead / 2, kLeastPlans * threads)
                                                : std::min(2 * ahead, kMostPlans * threads);
    }
    return any;
}

bool Optimisation::flip_cells(const Progress& progress) {
    const auto wanted = [&](std::size_t c) {
        const int cell = static_cast<int>(c);
        return mesh_.alive(cell) && quality(cell) < TetrahedralisationTuning::kGoodSine && !tried_[c];
    };
    const auto plan = [](ChangePlanner& planner, std::size_t c, Change& change) {
        planner.flip(static_cast<int>(c), change);
    };
    const auto apply = [&](std::size_t c, const Change& change) {
        if (change.helps) {
            replace(change);
        } else {
            tried_[c] = 1;
        }
    };
    bool any = false;
    // Flips append cells to the list.
    for (std::size_t from = 0; from < mesh_.cells.size();) {
        const std::size_t end = mesh_.cells.size();
        any = sweep(from, end, progress, wanted, plan, apply) || any;
        from = end;
    }
    return any;
}

bool Optimisation::move_vertices(const Progress& progress) {
    const auto wanted = [&](std::size_t v) { return settled_[v] == 0; };
    const auto plan = [](ChangePlanner& planner, std::size_t v, Change& change) {
        planner.move(static_cast<int>(v), change);
    };
    const auto apply = [&](std::size_t v, const Change& change) {
        if (change.helps) {
            mesh_.move_point(static_cast<int>(v), change.place);
            note(change.cells);
        } else {
            settled_[v] = 1;
        }
    };
    return sweep(static_cast<std::size_t>(first_inner_), mesh_.points.size(), progress, wanted, plan, apply);
}

bool Optimisation::insert_vertices(const Progress& progress) {
    std::vector<std::pair<double, int>> poor;
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
        const int cell = static_cast<int>(c);
        if (mesh_.alive(cell) && quality(cell) < TetrahedralisationTuning::kPoorSine) {
            poor.emplace_back(quality(cell), cell);
        }
    }
    std::sort(poor.begin(), poor.end());
    const double share = TetrahedralisationTuning::kInsertedShare * static_cast<double>(mesh_.cells.size());
    const auto most = static_cast<std::size_t>(share + TetrahedralisationTuning::kInsertedAlways);
    poor.resize(std::min(poor.size(), most));
    // Other insertions may have changed the cell.
    const auto wanted = [&](std::size_t i) {
        return mesh_.alive(poor[i].second) && quality(poor[i].second) == poor[i].first;
    };
    const auto plan = [&](ChangePlanner& planner, std::size_t i, Change& change) {
        planner.insert(poor[i].second, change);
    };
    const auto apply = [&](std::size_t /*i*/, Change& change) {
        if (change.helps) {
            const int vertex = mesh_.add_point(change.place);
            for (auto& corners : change.added) {
                corners[3] = vertex;
            }
            replace(change);
        }
    };
    return sweep(0, poor.size(), progress, wanted, plan, apply);
}

void Optimisation::replace(const Change& change) {
    for (const int c : change.cells) {
        changed_in_[c] = block_;
    }
    mesh_.replace(change.cells, change.added, created_);
    note(created_);
}

}  // namespace mq::tetrahedralise
