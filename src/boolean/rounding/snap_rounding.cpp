// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/snap_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "boolean/arrangement/arrangement.h"
#include "boolean/arrangement/cells.h"
#include "boolean/rounding/contact_separation.h"
#include "boolean/rounding/rounded_surface.h"
#include "boolean/rounding/tuning.h"
#include "boolean/rounding/vertex_snapping.h"
#include "mesh/intersection/self_intersection.h"

namespace mq::boolean {

namespace {

/// Relative spacing of single-precision numbers.
constexpr double kSingleUnit = std::numeric_limits<float>::epsilon();

/// Whether the triangles around each touched vertex are one closed fan of at least three.
bool manifold_where_touched(const RoundedSurface& surface) {
    std::unordered_map<std::int32_t, std::vector<std::array<std::int32_t, 2>>> links;  // (from, to) of each triangle
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(surface.triangles().size()); ++t) {
        const Triangle& c = surface.triangle(t);
        for (std::size_t k = 0; k < 3 && surface.alive(t); ++k) {
            if (surface.touched(c[k])) {
                links[c[k]].push_back({c[(k + 1) % 3], c[(k + 2) % 3]});
            }
        }
    }
    return std::all_of(links.begin(), links.end(), [](auto& entry) {
        auto& link = entry.second;
        std::sort(link.begin(), link.end());
        const auto from = [&](std::int32_t v) {
            return std::lower_bound(link.begin(), link.end(), std::array<std::int32_t, 2>{v, -1});
        };
        std::size_t length = 0;
        std::int32_t v = link.front()[0];
        do {
            const auto here = from(v);
            if (here == link.end() || (*here)[0] != v || ++length > link.size()) {
                return false;
            }
            v = (*here)[1];
        } while (v != link.front()[0]);
        return length == link.size() && length >= 3;
    });
}

class SnapRounder {
  public:
    SnapRounder(Extraction& extraction, const RoundingOptions& options, const Progress& progress)
        : extraction_(extraction), options_(options), progress_(progress) {
        double farthest = std::numeric_limits<float>::min();
        for (const Vec3& p : extraction.draft.vertices) {
            farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
        }
        grid_ = kSingleUnit * std::exp2(std::floor(std::log2(farthest)));
    }

    RoundingCount run() {
        for (std::size_t round = 0;; ++round) {
            separate();
            round_vertices(round == 0 ? 0.0 : grid_);
            RoundedSurface surface(extraction_.draft);
            const std::vector<TrianglePair> contacts = snapped(surface);
            const bool embedded = contacts.empty() && surface.flat().empty();
            largest_ = std::max(largest_, surface.largest_displacement());
            count_.error_bound = round == 0 ? largest_ : 2.0 * largest_;
            if (embedded && !surface.edited()) {
                break;
            }
            if (embedded && manifold_where_touched(surface)) {
                take(surface);
                break;
            }
            if (round == RoundingTuning::kRoundingRounds || contacts.size() > limit_ ||
                count_.error_bound > RoundingTuning::kMostRoundingMove * options_.tolerance) {
                give_up(surface, contacts);
                break;
            }
            grid_ *= 2 * contacts.size() > left_ ? RoundingTuning::kCoarser : 1.0;
            left_ = contacts.size();
            rearrange(surface, contacts);
            ++count_.rounds;
        }
        return count_;
    }

  private:
    void separate() {
        const double distance =
            std::min(RoundingTuning::kSeparationUnits * kSingleUnit * options_.size, 0.05 * options_.tolerance);
        count_.separated += separate_copies(extraction_, std::max(distance, 4.0 * grid_), 4.0 * grid_);
    }

    Vec3 rounded(const Vec3& p, double grid) const {
        const Vec3 on_grid = grid > 0.0 ? Vec3(grid * (p / grid).array().round().matrix()) : p;
        return options_.in_single ? to_single(on_grid) : on_grid;
    }

    void round_vertices(double grid) {
        ResultMesh& draft = extraction_.draft;
        std::vector<double> moved(draft.vertices.size(), 0.0);
        for (std::size_t v = 0; v < draft.vertices.size(); ++v) {
            if (draft.made[v] != kConstructed) {
                continue;
            }
            const Vec3 exact = draft.vertices[v];
            draft.vertices[v] = rounded(exact, grid);
            moved[v] = (draft.vertices[v] - exact).norm();
        }
        add_displacements(draft, moved);
    }

    /// Snaps what is in contact; returns the contacts that stay.
    std::vector<TrianglePair> snapped(RoundedSurface& surface) {
        // A vertex and what it is near have each moved by at most 0.87 units.
        const double reach = 2.0 * grid_;
        std::vector<TrianglePair> contacts = all_contacts(surface);
        limit_ = std::min(limit_, RoundingTuning::kMoreContacts * contacts.size() + RoundingTuning::kManyContacts);
        std::size_t flat = surface.flat().size();
        if (contacts.empty() && flat == 0) {
            return contacts;
        }
        surface.index_added();
        std::size_t fewest = std::numeric_limits<std::size_t>::max();
        for (std::size_t pass = 0; contacts.size() + flat > 0 && pass < RoundingTuning::kSnappingPasses; ++pass) {
            if (contacts.size() > limit_ || (pass >= RoundingTuning::kFreePasses && contacts.size() + flat >= fewest)) {
                break;
            }
            fewest = std::min(fewest, contacts.size() + flat);
            const std::size_t known = surface.triangles().size();
            const std::size_t events = snap_vertices(
                surface, contacts, reach, [&](const Vec3& p) { return rounded(p, grid_); }, progress_);
            if (events == 0) {
                break;
            }
            count_.snapped += events;
            update(surface, known, contacts);
            flat = surface.flat().size();
        }
        return contacts;
    }

    std::vector<TrianglePair> all_contacts(const RoundedSurface& surface) const {
        std::vector<TrianglePair> result;
        for (const mesh::ContactPair& pair : mesh::self_intersections_with(
                 surface.vertices(), surface.triangles(), surface.changed(), mesh::kAllPairs, &progress_)) {
            Triangle a = surface.triangle(pair.a);
            Triangle b = surface.triangle(pair.b);
            std::sort(a.begin(), a.end());
            std::sort(b.begin(), b.end());
            if (a != b) {
                result.push_back({pair.a, pair.b});
            }
        }
        return result;
    }

    /// Brings the contacts up to date with the triangles added after the `known` ones.
    void update(const RoundedSurface& surface, std::size_t known, std::vector<TrianglePair>& contacts) const {
        contacts.erase(std::remove_if(contacts.begin(), contacts.end(),
                                      [&](const TrianglePair& pair) {
                                          return !surface.alive(pair[0]) || !surface.alive(pair[1]);
                                      }),
                       contacts.end());
        std::vector<std::int32_t> fresh;
        for (std::size_t t = known; t < surface.triangles().size(); ++t) {
            fresh.push_back(static_cast<std::int32_t>(t));
        }
        const std::vector<TrianglePair> added = contacts_of(surface, fresh, progress_);
        contacts.insert(contacts.end(), added.begin(), added.end());
    }

    /// The surface as one operand of a Boolean.
    Soup soup_of(const RoundedSurface& surface, std::vector<std::int32_t>& index,
                 std::vector<CoincidentTriangle>& twins) const {
        Soup soup;
        soup.operands = 1;
        soup.vertices = surface.vertices();
        soup.moved.resize(soup.vertices.size());
        for (std::size_t v = 0; v < soup.moved.size(); ++v) {
            soup.moved[v] = surface.touched(static_cast<std::int32_t>(v)) ? 1 : 0;
        }
        index.assign(surface.triangles().size(), -1);
        for (std::int32_t t = 0; t < static_cast<std::int32_t>(surface.triangles().size()); ++t) {
            if (surface.alive(t) && !surface.flat(t)) {
                index[static_cast<std::size_t>(t)] = static_cast<std::int32_t>(soup.triangles.size());
                soup.triangles.push_back(surface.triangle(t));
                soup.source.push_back({0, t});
            }
        }
        std::vector<std::int32_t> touched;
        for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
            const Triangle& c = soup.triangles[t];
            if (surface.touched(c[0]) || surface.touched(c[1]) || surface.touched(c[2])) {
                touched.push_back(static_cast<std::int32_t>(t));
            }
        }
        twins = find_twins(soup, touched);
        // Where faces on top of each other cancel, the surface may be left with several fans.
        for (const CoincidentTriangle& twin : twins) {
            for (const std::int32_t v : soup.triangles[static_cast<std::size_t>(twin.triangle)]) {
                soup.moved[static_cast<std::size_t>(v)] = 1;
            }
        }
        return soup;
    }

    void rearrange(const RoundedSurface& surface, const std::vector<TrianglePair>& contacts) {
        std::vector<std::int32_t> index;
        std::vector<CoincidentTriangle> twins;
        const Soup soup = soup_of(surface, index, twins);
        std::vector<char> twin(soup.triangles.size(), 0);
        for (const CoincidentTriangle& t : twins) {
            twin[static_cast<std::size_t>(t.triangle)] = 1;
        }
        std::vector<TrianglePair> crossing;
        for (const TrianglePair& pair : contacts) {
            const TrianglePair here{index[static_cast<std::size_t>(pair[0])], index[static_cast<std::size_t>(pair[1])]};
            // What a triangle without area touches is touched by its neighbours, too.
            const bool flat = here[0] < 0 || here[1] < 0;
            if (!flat && twin[static_cast<std::size_t>(here[0])] == 0 && twin[static_cast<std::size_t>(here[1])] == 0) {
                crossing.push_back(here);
            }
        }
        const Arrangement arrangement = arrange(soup, twins, crossing, progress_);
        const Cells cells = find_cells(soup, arrangement, progress_);
        const ResultMesh old = std::move(extraction_.draft);
        extraction_ = extract(soup, arrangement, cells, Expression::chain(Operation::Union, 1), progress_);
        ResultMesh& draft = extraction_.draft;
        for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
            const std::int32_t piece = soup.source[static_cast<std::size_t>(draft.from[t])].triangle;
            const auto before = static_cast<std::size_t>(surface.origin(piece));
            const bool own = draft.source[t].operand >= 0 && surface.whole(piece);
            draft.from[t] = old.from[before];
            draft.displacement[t] = surface.displacement(piece);
            draft.source[t] = own ? old.source[before] : Source{};
        }
    }

    /// Makes the surface, which is embedded, the result.
    void take(const RoundedSurface& surface) {
        ResultMesh& draft = extraction_.draft;
        const ResultMesh old = draft;
        draft.vertices = surface.vertices();
        draft.made.resize(draft.vertices.size(), kRounded);
        draft.triangles.clear();
        draft.source.clear();
        draft.from.clear();
        draft.displacement.clear();
        for (std::int32_t t = 0; t < static_cast<std::int32_t>(surface.triangles().size()); ++t) {
            if (surface.alive(t)) {
                const auto before = static_cast<std::size_t>(surface.origin(t));
                draft.triangles.push_back(surface.triangle(t));
                draft.source.push_back(surface.whole(t) ? old.source[before] : Source{});
                draft.from.push_back(old.from[before]);
                draft.displacement.push_back(surface.displacement(t));
            }
        }
        remove_unused_vertices(draft);
    }

    /// Lists the sources of the triangles that are in contact, or at vertices where the surface is no manifold.
    void give_up(const RoundedSurface& surface, const std::vector<TrianglePair>& contacts) {
        const auto add = [&](std::int32_t t) {
            count_.faulty.push_back(extraction_.draft.from[static_cast<std::size_t>(surface.origin(t))]);
        };
        for (const TrianglePair& pair : contacts) {
            add(pair[0]);
            add(pair[1]);
        }
        for (const std::int32_t t : surface.changed()) {
            if (contacts.empty() && surface.alive(t)) {
                add(t);
            }
        }
        std::sort(count_.faulty.begin(), count_.faulty.end());
        count_.faulty.erase(std::unique(count_.faulty.begin(), count_.faulty.end()), count_.faulty.end());
    }

    Extraction& extraction_;
    const RoundingOptions& options_;
    const Progress& progress_;
    double largest_ = 0.0;  ///< displacement of any triangle in all rounds, mm
    double grid_ = 0.0;     ///< grid of this round, at first single precision's, mm
    std::size_t left_ = std::numeric_limits<std::size_t>::max() / 2;  ///< contacts that the last round left
    std::size_t limit_ = mesh::kAllPairs;                             ///< contacts beyond which the rounds are given up
    RoundingCount count_;
};

}  // namespace

RoundingCount snap_round(Extraction& extraction, const RoundingOptions& options, const Progress& progress) {
    return SnapRounder(extraction, options, progress).run();
}

}  // namespace mq::boolean
