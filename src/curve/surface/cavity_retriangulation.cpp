// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "base/chord_table.h"
#include "base/tuning.h"
#include "curve/surface/editor.h"
#include "curve/surface/tuning.h"

namespace mq::curve {

namespace {

/// Triangles of one face and the loop of vertices around them, in the sense of the triangles.
struct Cavity {
    std::vector<int> triangles;
    std::vector<int> border;
};

/// The loop around triangles that form a disc; empty when they do not, or when a vertex inside must stay.
std::vector<int> border_of(const SurfaceEditor& editor, const std::vector<int>& triangles) {
    std::set<std::pair<int, int>> directed;
    std::set<int> inside;
    for (const int t : triangles) {
        const auto& v = editor.triangle(t).corners;
        for (std::size_t k = 0; k < 3; ++k) {
            directed.emplace(v[k], v[(k + 1) % 3]);
            inside.insert(v[k]);
        }
    }
    std::map<int, int> next;
    for (const auto& [a, b] : directed) {
        if (directed.count({b, a}) == 0 && !next.emplace(a, b).second) {
            return {};
        }
    }
    std::vector<int> loop;
    for (int v = next.empty() ? -1 : next.begin()->first; v >= 0 && loop.size() < next.size();) {
        loop.push_back(v);
        inside.erase(v);
        const auto found = next.find(v);
        v = found == next.end() || found->second == loop.front() ? -1 : found->second;
    }
    const bool free = std::all_of(inside.begin(), inside.end(), [&](int v) {
        return editor.surface.shapes.vertices[static_cast<std::size_t>(v)].entity[0] == 2;
    });
    return loop.size() == next.size() && free ? loop : std::vector<int>{};
}

/// The bad triangles that are connected with the seed by edges inside its face.
std::vector<int> bad_ones_around(const SurfaceEditor& editor, int seed) {
    std::vector<int> result{seed};
    for (std::size_t i = 0; i < result.size() && result.size() < kMostRounds; ++i) {
        const auto v = editor.triangle(result[i]).corners;
        for (std::size_t k = 0; k < 3; ++k) {
            if (editor.surface.segment(v[k], v[(k + 1) % 3]) != nullptr) {
                continue;
            }
            for (const int t : editor.surface.triangles_of_edge(v[k], v[(k + 1) % 3])) {
                if (editor.triangle(t).quality < SurfaceTuning::kGoodTriangle &&
                    editor.triangle(t).face == editor.triangle(seed).face &&
                    std::find(result.begin(), result.end(), t) == result.end()) {
                    result.push_back(t);
                }
            }
        }
    }
    return result;
}

/// Adds all triangles of the face at the seed's vertices.
std::vector<int> with_layer(const SurfaceEditor& editor, std::vector<int> triangles) {
    const int face = editor.triangle(triangles.front()).face;
    for (const int v : editor.triangle(triangles.front()).corners) {
        for (const int t : editor.surface.triangles_of_vertex(v)) {
            if (editor.triangle(t).face == face &&
                std::find(triangles.begin(), triangles.end(), t) == triangles.end()) {
                triangles.push_back(t);
            }
        }
    }
    return triangles;
}

/// Adds the neighbours of the triangles within the face.
std::vector<int> with_neighbours(const SurfaceEditor& editor, const std::vector<int>& triangles) {
    std::vector<int> result = triangles;
    for (const int t : triangles) {
        const auto v = editor.triangle(t).corners;
        for (std::size_t k = 0; k < 3; ++k) {
            for (const int other : editor.surface.triangles_of_edge(v[k], v[(k + 1) % 3])) {
                if (editor.triangle(other).face == editor.triangle(t).face &&
                    std::find(result.begin(), result.end(), other) == result.end()) {
                    result.push_back(other);
                }
            }
        }
    }
    return result;
}

/// The triangulation of a polygon whose worst triangle is best, by dynamic programming over its chords.
class BestTriangulation {
  public:
    BestTriangulation(SurfaceEditor& editor, const Cavity& cavity)
        : editor_(editor), cavity_(cavity), n_(cavity.border.size()), quality_(n_ * n_ * n_, kImpossible) {
        measure_candidates();
    }

    std::vector<SurfaceEditor::Corners> find() const {
        ChordTable<double> table;
        const auto worst = [&](std::size_t i, std::size_t k, std::size_t j, double left, double right, double& best) {
            const double value = std::min({quality_[slot(i, k, j)], left, right});
            const bool better = value > best;
            best = better ? value : best;
            return better;
        };
        std::vector<SurfaceEditor::Corners> result;
        if (table.find(n_, 1.0, kImpossible, worst) > kImpossible) {
            table.for_each_triangle([&](std::size_t i, std::size_t k, std::size_t j) {
                result.push_back({{cavity_.border[i], cavity_.border[k], cavity_.border[j]}, face()});
            });
        }
        return result;
    }

  private:
    /// The quality of a triangulation that is not possible.
    static constexpr double kImpossible = -std::numeric_limits<double>::max();

    std::size_t slot(std::size_t i, std::size_t k, std::size_t j) const { return (i * n_ + k) * n_ + j; }
    int face() const { return editor_.triangle(cavity_.triangles.front()).face; }

    /// Chords must be new to the mesh, or lie in the cavity.
    bool allowed(std::size_t i, std::size_t j) const {
        if (j == i + 1 || (i == 0 && j == n_ - 1)) {
            return true;
        }
        const std::vector<int> beside = editor_.surface.triangles_of_edge(cavity_.border[i], cavity_.border[j]);
        return std::all_of(beside.begin(), beside.end(), [&](int t) {
            return std::find(cavity_.triangles.begin(), cavity_.triangles.end(), t) != cavity_.triangles.end();
        });
    }

    /// Measures all triangles between vertices of the border: each is put into the surface while its nodes are placed.
    void measure_candidates() {
        CurvedSurface& surface = editor_.surface;
        std::vector<std::size_t> slots;
        std::vector<int> candidates;
        std::vector<std::pair<int, int>> fresh;
        for (std::size_t i = 0; i < n_; ++i) {
            for (std::size_t j = i + 1; j < n_; ++j) {
                if (!surface.has_edge(cavity_.border[i], cavity_.border[j])) {
                    fresh.emplace_back(cavity_.border[i], cavity_.border[j]);
                }
                for (std::size_t k = i + 1; k < j && allowed(i, j); ++k) {
                    if (allowed(i, k) && allowed(k, j)) {
                        slots.push_back(slot(i, k, j));
                    }
                }
            }
        }
        for (const std::size_t at : slots) {
            const std::array<int, 3> corners{cavity_.border[at / n_ / n_], cavity_.border[at / n_ % n_],
                                             cavity_.border[at % n_]};
            candidates.push_back(surface.add_triangle(corners, face()));
        }
        editor_.placement.place(candidates);
        for (std::size_t i = slots.size(); i-- > 0;) {
            quality_[slots[i]] = editor_.triangle(candidates[i]).quality;
            surface.shapes.forget_face(editor_.triangle(candidates[i]).corners);
            surface.withdraw_triangle();
        }
        for (const auto& [a, b] : fresh) {
            surface.shapes.forget_edge(a, b);
        }
        editor_.placement.place(cavity_.triangles);
    }

    SurfaceEditor& editor_;
    const Cavity& cavity_;
    std::size_t n_;
    std::vector<double> quality_;
};

bool regrow(SurfaceEditor& editor, const std::vector<int>& triangles) {
    const Cavity cavity{triangles, border_of(editor, triangles)};
    if (cavity.border.size() < 4 || cavity.border.size() > kMostRounds) {
        return false;
    }
    const std::vector<SurfaceEditor::Corners> added = BestTriangulation(editor, cavity).find();
    return !added.empty() && editor.replace(triangles, added, SurfaceEditor::Rule::Improve);
}

}  // namespace

bool retriangulate_cavity(SurfaceEditor& editor, int triangle) {
    const std::vector<int> bad = bad_ones_around(editor, triangle);
    const std::vector<int> beside = with_neighbours(editor, bad);
    return regrow(editor, bad) || regrow(editor, with_layer(editor, {triangle})) ||
           regrow(editor, with_layer(editor, bad)) || regrow(editor, beside) ||
           regrow(editor, with_neighbours(editor, beside));
}

}  // namespace mq::curve
