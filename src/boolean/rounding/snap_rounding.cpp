// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/rounding/snap_rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/tuning.h"
#include "boolean/arrangement/arrangement.h"
#include "boolean/arrangement/cells.h"
#include "boolean/rounding/separate_copies.h"
#include "boolean/rounding/tuning.h"
#include "boolean/rounding/vertex_relocation.h"
#include "mesh/weld_vertices.h"

namespace mq::boolean {

namespace {

/// Relative spacing of single-precision numbers.
constexpr double kSingleUnit = std::numeric_limits<float>::epsilon();

class SnapRounder {
  public:
    SnapRounder(Extraction& extraction, const RoundingOptions& options, const Progress& progress)
        : extraction_(extraction), options_(options), progress_(progress) {
        double farthest = std::numeric_limits<float>::min();
        for (const Vec3& p : extraction.draft.vertices) {
            farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
        }
        unit_ = count_.unit = kSingleUnit * std::exp2(std::floor(std::log2(farthest)));
    }

    RoundingCount run() {
        const double reach =
            std::min(RoundingTuning::kRelocationUnits * unit_, RoundingTuning::kRelocationShare * options_.tolerance);
        const RelocationOptions relocation{unit_, std::max(reach, unit_), [&](const Vec3& p) { return on_grid(p); }};
        for (;;) {
            separate();
            round_vertices();
            close_short_edges();
            const EmbeddingFaults faults = relocate_vertices(extraction_.draft, relocation, progress_);
            const std::vector<double>& displaced = extraction_.draft.displacement;
            largest_ = std::accumulate(displaced.begin(), displaced.end(), largest_,
                                       [](double a, double b) { return std::max(a, b); });
            count_.error_bound = count_.rounds == 0 ? largest_ : 2.0 * largest_;
            if (faults.size() == 0 && !faults.may_have_turned) {
                break;
            }
            const bool used_up = count_.rounds >= kMostRounds || faults.is_tangle;
            // A surface that is embedded stays so when it is only classified again.
            if (faults.size() > 0 && used_up) {
                give_up(faults);
                break;
            }
            rearrange(faults);
            ++count_.rounds;
        }
        return count_;
    }

  private:
    void separate() {
        const double distance =
            std::min(RoundingTuning::kSeparationUnits * kSingleUnit * options_.size, 0.05 * options_.tolerance);
        count_.separated += separate_copies(extraction_, std::max(distance, 4.0 * unit_), 4.0 * unit_);
    }

    Vec3 rounded(const Vec3& p) const { return options_.in_single ? to_single(p) : p; }
    /// Double-precision coordinates get the spacing of single-precision ones at places that must be told apart.
    Vec3 on_grid(const Vec3& p) const {
        return options_.in_single ? to_single(p) : Vec3(unit_ * (p / unit_).array().round().matrix());
    }

    void round_vertices() {
        ResultMesh& draft = extraction_.draft;
        std::vector<double> moved(draft.vertices.size(), 0.0);
        for (std::size_t v = 0; v < draft.vertices.size(); ++v) {
            if (draft.made[v] != kConstructed) {
                continue;
            }
            const Vec3 exact = draft.vertices[v];
            draft.vertices[v] = rounded(exact);
            moved[v] = (draft.vertices[v] - exact).norm();
        }
        add_displacements(draft, moved);
    }

    /// Moves constructed vertices that single precision cannot separate from a neighbour to that neighbour, where they
    /// are merged afterwards: near a plane through the origin single-precision numbers are so dense that edges of 1e-19
    /// mm would remain. Each vertex moves at most once, and a vertex to which another one has moved stays.
    void close_short_edges() {
        ResultMesh& draft = extraction_.draft;
        std::vector<double> moved(draft.vertices.size(), 0.0);
        std::vector<char> fixed(draft.vertices.size(), 0);
        for (const Triangle& c : draft.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                auto from = static_cast<std::size_t>(c[k]);
                auto to = static_cast<std::size_t>(c[(k + 1) % 3]);
                if (draft.made[from] != kConstructed || fixed[from] != 0) {
                    std::swap(from, to);
                }
                const double length = (draft.vertices[to] - draft.vertices[from]).norm();
                if (draft.made[from] == kConstructed && fixed[from] == 0 && length > 0.0 && length < unit_) {
                    draft.vertices[from] = draft.vertices[to];
                    moved[from] = length;
                    fixed[from] = fixed[to] = 1;
                }
            }
        }
        add_displacements(draft, moved);
    }

    /// The surface as one operand of a Boolean: vertices in one place are merged, triangles without area are left out.
    /// @param index  by triangle of the draft: its index in the soup; -1: it is left out
    Soup soup_of(const ResultMesh& draft, const std::vector<std::int32_t>& flat, std::vector<std::int32_t>& index,
                 std::vector<CoincidentTriangle>& twins) const {
        Soup soup;
        soup.operands = 1;
        soup.vertices = draft.vertices;
        soup.moved.resize(soup.vertices.size());
        soup.shared.resize(soup.vertices.size());
        const std::vector<std::int32_t> first = mesh::equal_vertices(soup.vertices);
        for (std::size_t v = 0; v < first.size(); ++v) {
            const auto place = static_cast<std::size_t>(first[v]);
            if (draft.made[v] == kConstructed || place != v) {
                soup.moved[place] = 1;
            }
            if (place != v) {
                soup.shared[place] = 1;
            }
        }
        index.assign(draft.triangles.size(), -1);
        std::vector<std::int32_t> touched;
        for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
            Triangle c = draft.triangles[t];
            for (std::int32_t& v : c) {
                v = first[static_cast<std::size_t>(v)];
            }
            const auto moved = [&](std::int32_t v) { return soup.moved[static_cast<std::size_t>(v)] != 0; };
            if (std::binary_search(flat.begin(), flat.end(), static_cast<std::int32_t>(t))) {
                for (const std::int32_t v : c) {
                    soup.moved[static_cast<std::size_t>(v)] = 1;
                }
                continue;
            }
            index[t] = static_cast<std::int32_t>(soup.triangles.size());
            if (std::any_of(c.begin(), c.end(), moved)) {
                touched.push_back(index[t]);
            }
            soup.triangles.push_back(c);
            soup.source.push_back({0, static_cast<std::int32_t>(t)});
        }
        twins = find_twins(soup, touched);
        // If coinciding faces cancel each other, a vertex may be left with several fans.
        for (const CoincidentTriangle& twin : twins) {
            for (const std::int32_t v : soup.triangles[static_cast<std::size_t>(twin.triangle)]) {
                soup.moved[static_cast<std::size_t>(v)] = 1;
            }
        }
        return soup;
    }

    /// Divides the triangles in contact where they cross, and takes the boundary of what the surface winds around.
    void rearrange(const EmbeddingFaults& faults) {
        std::vector<std::int32_t> index;
        std::vector<CoincidentTriangle> twins;
        const Soup soup = soup_of(extraction_.draft, faults.flat, index, twins);
        std::vector<char> twin(soup.triangles.size(), 0);
        for (const CoincidentTriangle& t : twins) {
            twin[static_cast<std::size_t>(t.triangle)] = 1;
        }
        std::vector<std::array<std::int32_t, 2>> crossing;
        for (const auto& pair : faults.contacts) {
            const std::array<std::int32_t, 2> here{index[static_cast<std::size_t>(pair[0])],
                                                   index[static_cast<std::size_t>(pair[1])]};
            // A triangle that touches one without area also touches the neighbours of that.
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
            const auto before = static_cast<std::size_t>(soup.source[static_cast<std::size_t>(draft.from[t])].triangle);
            draft.from[t] = old.from[before];
            draft.displacement[t] = old.displacement[before];
            draft.source[t] = draft.source[t].operand >= 0 ? old.source[before] : Source{};
        }
    }

    /// Lists the sources of the triangles at faults.
    void give_up(const EmbeddingFaults& faults) {
        const auto add = [&](std::int32_t t) {
            count_.faulty.push_back(extraction_.draft.from[static_cast<std::size_t>(t)]);
        };
        for (const auto& pair : faults.contacts) {
            add(pair[0]);
            add(pair[1]);
        }
        std::for_each(faults.flat.begin(), faults.flat.end(), add);
        std::sort(count_.faulty.begin(), count_.faulty.end());
        count_.faulty.erase(std::unique(count_.faulty.begin(), count_.faulty.end()), count_.faulty.end());
    }

    Extraction& extraction_;
    const RoundingOptions& options_;
    const Progress& progress_;
    double largest_ = 0.0;  ///< displacement of any triangle in all rounds, mm
    double unit_ = 0.0;     ///< spacing of single-precision numbers at the farthest vertex, mm
    RoundingCount count_;
};

}  // namespace

RoundingCount snap_round(Extraction& extraction, const RoundingOptions& options, const Progress& progress) {
    return SnapRounder(extraction, options, progress).run();
}

}  // namespace mq::boolean
