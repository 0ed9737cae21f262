// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/initial/face_triangulator.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/angle.h"
#include "base/predicates.h"
#include "triangulate/initial/degenerate_sides.h"
#include "triangulate/initial/degenerate_triangles.h"
#include "triangulate/initial/face_boundary.h"
#include "triangulate/initial/inverted_loops.h"
#include "triangulate/initial/surface_flips.h"
#include "triangulate/initial/triangle_fidelity.h"
#include "triangulate/initial/tuning.h"

namespace mq::triangulate {

namespace {

using VertexUse = FaceMesh::VertexUse;
using Link = FaceMesh::Link;
using Fault = TriangleFault;
using Corners = std::array<int, 3>;
using Side = std::array<int, 2>;  // its ends, the smaller number first

class FaceMesher {
  public:
    FaceMesher(geometry::Oracle& oracle, const EdgeDiscretisation& chains, const SinglePrecisionGrid& grid, int face,
               bool border_may_change, const std::vector<VertexUse>& inner)
        : oracle_(oracle),
          chains_(chains),
          grid_(grid),
          face_(face),
          border_may_change_(border_may_change),
          inner_(inner) {}

    FaceMesh run();

  private:
    bool long_enough();
    bool insert_border();
    bool add_constraint(int piece);
    void mark_piece(int piece);
    void mark_crossing(int piece, int other);
    void mark_around(int planar_vertex);
    double length_of(int piece) const;
    bool much_longer(int a, int b) const { return length_of(a) > InitialTuning::kMuchLonger * length_of(b); }
    bool request_halving(int piece);
    void find_inside();
    void insert_inside(const VertexUse& site);
    void insert_inner();
    void check_loops(const std::vector<std::optional<Vec2>>& middles);
    void reject_useless_halving(const std::vector<std::optional<Vec2>>& middles);
    void request_border_split(int piece, int side);
    geometry::Engine::Answers at_centroids(const std::vector<int>& triangles);
    bool refine_round();
    int side_to_split(int t, Fault fault) const;
    Fault fault(int t, const geometry::Answer& at_centroid) const;
    void ask_to_split(int t, Fault fault, std::vector<Side>& sides);
    bool crowds(int a, int b, const Vec3& p) const;
    bool insert_midpoints(const std::vector<Side>& sides);
    void assemble();
    Link link_of(int h, const std::vector<int>& number) const;
    bool close(const std::vector<Corners>& triangles, std::vector<std::array<Link, 3>> links);

    const VertexUse& site_at(int corner_vertex) const { return result_.sites[site_of_[corner_vertex]]; }
    const VertexUse& corner_site(int h) const { return site_at(tri_->corner(h)); }
    int kept_site(int h) const {
        const auto s = static_cast<std::size_t>(site_of_[tri_->corner(h)]);
        return s < stands_for_.size() ? stands_for_[s] : static_cast<int>(s);
    }
    Corners corners_of(int t) const { return {tri_->corner(3 * t), tri_->corner(3 * t + 1), tri_->corner(3 * t + 2)}; }
    int level(int planar_vertex) const { return level_[site_of_[planar_vertex]]; }
    double reach() const { return grid_.shortest_side(); }

    geometry::Oracle& oracle_;
    const EdgeDiscretisation& chains_;
    const SinglePrecisionGrid& grid_;
    int face_;
    // Whether pieces may be halved to follow the surface, not only to keep the border from crossing itself.
    bool border_may_change_;
    const std::vector<VertexUse>& inner_;
    FaceBoundary border_;
    std::vector<int> stands_for_;  // see divide_degenerate_sides
    std::unique_ptr<ConstrainedDelaunay> tri_;
    std::vector<int> planar_of_;              // by site: its vertex in the planar triangulation
    std::vector<int> site_of_;                // by vertex of the planar triangulation: its site
    std::vector<std::vector<int>> overlaps_;  // by piece: further pieces on the same edge, as the other side of a slit
    std::vector<int> level_;                  // by site: number of halvings that led to it, 0 on the border
    std::vector<char> inside_;
    std::vector<Corners> fine_;  // by triangle: its corners when it passed the test
    bool late_ = false;
    double smallest_ = 0.0;  // mm; smaller triangles need not follow the surface, which may fold at that size
    FaceMesh result_;
};

FaceMesh FaceMesher::run() {
    border_ = face_boundary(oracle_, chains_, grid_, face_, result_.failure);
    if (result_.failure.empty()) {
        stands_for_ = divide_degenerate_sides(oracle_, face_, border_);
    }
    result_.sites = border_.sites;
    if (!result_.failure.empty() || !long_enough() || !insert_border()) {
        return result_;
    }
    find_inside();
    if (!result_.failure.empty()) {
        return result_;
    }
    insert_inner();
    const std::vector<std::optional<Vec2>> middles = middles_of_pieces(oracle_, chains_, border_);
    check_loops(middles);
    reject_useless_halving(middles);
    for (int round = 0; round < InitialTuning::kMaxFaceRounds && result_.marks.empty(); ++round) {
        late_ = round >= InitialTuning::kPatience;
        if (!border_.plane && (late_ || !inner_.empty())) {
            const bool reversed = oracle_.topology().faces[face_].reversed;
            SurfaceFlips{*tri_, result_.sites, site_of_, inside_, reversed, kCosMaxTurn, !inner_.empty()}.run();
        }
        if (!refine_round()) {
            break;
        }
        find_inside();
    }
    if (result_.marks.empty()) {
        assemble();
    }
    return result_;
}

// Two arcs can bound a face, two chords cannot: asks for at least three pieces.
bool FaceMesher::long_enough() {
    if (border_.pieces.size() >= 3) {
        return true;
    }
    for (int k = 0; k < static_cast<int>(border_.pieces.size()); ++k) {
        mark_piece(k);
    }
    if (result_.marks.empty()) {
        result_.failure = border_.pieces.empty() ? "it has no edges" : "its border is too short to enclose anything";
    }
    return false;
}

void FaceMesher::mark_piece(int piece) {
    const FaceBoundary::Piece& p = border_.pieces[piece];
    if (!p.collapsed() && length_of(piece) > 2.0 * reach()) {
        result_.marks.insert({oracle_.topology().uses[p.use].edge, p.index});
    }
}

// Marks only the longer piece if it is much longer: pieces of equal length separate at a small input angle as their
// curves do, while a long chord cuts off short ones however short they become, since both are halved in turn. Once
// only crossings are resolved, both are marked.
void FaceMesher::mark_crossing(int piece, int other) {
    if (other < 0 || !border_may_change_ || !much_longer(other, piece)) {
        mark_piece(piece);
    }
    if (other >= 0 && (!border_may_change_ || !much_longer(piece, other))) {
        mark_piece(other);
    }
}

double FaceMesher::length_of(int piece) const {
    const FaceBoundary::Piece& p = border_.pieces[piece];
    return (result_.sites[p.to].point - result_.sites[p.from].point).norm();
}

// Requests that a piece is halved. Where the curves of an edge differ within its tolerance, shorter pieces follow the
// surface no better, so that the request is refused.
bool FaceMesher::request_halving(int piece) {
    if (!border_may_change_ || border_.pieces[piece].collapsed()) {
        return false;
    }
    const double length = length_of(piece);
    if (length <= InitialTuning::kMinDeviations * border_.deviation || length <= 2.0 * reach()) {
        return false;
    }
    mark_piece(piece);
    return true;
}

void FaceMesher::mark_around(int planar_vertex) {
    for (int k = 0; k < static_cast<int>(border_.pieces.size()); ++k) {
        const FaceBoundary::Piece& p = border_.pieces[k];
        if (planar_of_[p.from] == planar_vertex || planar_of_[p.to] == planar_vertex) {
            mark_piece(k);
        }
    }
}

bool FaceMesher::insert_border() {
    Vec2 low = Vec2::Constant(1e300);
    Vec2 high = Vec2::Constant(-1e300);
    for (const VertexUse& s : border_.sites) {
        low = low.cwiseMin(border_.scaled(s.uv));
        high = high.cwiseMax(border_.scaled(s.uv));
    }
    if (!low.allFinite() || !high.allFinite()) {
        result_.failure = "its border has coordinates that are not numbers";
        return false;
    }
    tri_ = std::make_unique<ConstrainedDelaunay>(low, high, result_.sites.size());
    level_.assign(result_.sites.size(), 0);
    smallest_ = std::max({2.0 * reach(), InitialTuning::kMinDeviations * border_.deviation,
                          InitialTuning::kMinPart * (high - low).norm()});
    site_of_.assign(ConstrainedDelaunay::kFrame, -1);
    for (int s = 0; s < static_cast<int>(result_.sites.size()); ++s) {
        oracle_.check();
        const int v = tri_->insert(border_.scaled(result_.sites[s].uv));
        if (v == static_cast<int>(site_of_.size())) {
            site_of_.push_back(s);
        } else if (result_.sites[site_of_[v]].vertex != result_.sites[s].vertex) {
            result_.failure = "two points of its border fall together in (u, v)";
            return false;
        }
        planar_of_.push_back(v);
    }
    overlaps_.resize(border_.pieces.size());
    bool free = true;
    for (int k = 0; k < static_cast<int>(border_.pieces.size()); ++k) {
        oracle_.check();
        const FaceBoundary::Piece& p = border_.pieces[k];
        if (!p.collapsed() && result_.sites[p.from].vertex == result_.sites[p.to].vertex) {
            mark_piece(k);
            free = false;
        }
        free = add_constraint(k) && free;
    }
    if (!free && result_.marks.empty() && result_.failure.empty()) {
        result_.failure = "its border crosses itself in (u, v)";
    }
    return free;
}

bool FaceMesher::add_constraint(int piece) {
    const FaceBoundary::Piece& p = border_.pieces[piece];
    const int a = planar_of_[p.from];
    const int b = planar_of_[p.to];
    if (a == b) {
        return true;
    }
    if (const auto obstacle = tri_->insert_constraint(a, b, piece)) {
        mark_crossing(piece, obstacle->constraint);
        if (obstacle->vertex >= 0) {
            mark_around(obstacle->vertex);
        }
        return false;
    }
    const int label = tri_->label(tri_->find_edge(a, b));
    if (label != piece) {
        overlaps_[label].push_back(piece);
    }
    return true;
}

// Classifies triangles from the frame inwards: crossing an odd number of borders changes between outside and inside.
// This does not rely on the direction of the loops, which is wrong on faulty faces.
void FaceMesher::find_inside() {
    const int n = tri_->triangle_count();
    inside_.assign(n, -1);
    std::vector<int> stack;
    for (int h = 0; h < 3 * n; ++h) {
        if (tri_->twin(h) < 0) {
            inside_[h / 3] = 0;
            stack.push_back(h / 3);
        }
    }
    bool any = false;
    while (!stack.empty()) {
        const int t = stack.back();
        stack.pop_back();
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const int g = tri_->twin(h);
            if (g < 0) {
                continue;
            }
            int crossed = 0;
            if (const int label = tri_->label(h); label >= 0) {
                crossed += border_.pieces[label].internal ? 0 : 1;
                for (const int other : overlaps_[label]) {
                    crossed += border_.pieces[other].internal ? 0 : 1;
                }
            }
            const char side = static_cast<char>((inside_[t] + crossed) % 2);
            if (inside_[g / 3] < 0) {
                inside_[g / 3] = side;
                any = any || side == 1;
                stack.push_back(g / 3);
            } else if (inside_[g / 3] != side) {
                result_.failure = "its border is not closed in (u, v)";
                return;
            }
        }
    }
    if (!any) {
        result_.failure = "its border encloses nothing";
    }
}

void FaceMesher::insert_inside(const VertexUse& site) {
    if (tri_->insert_off_constraints(border_.scaled(site.uv)) == static_cast<int>(site_of_.size())) {
        site_of_.push_back(static_cast<int>(result_.sites.size()));
        result_.sites.push_back(site);
        level_.push_back(0);
    }
}

void FaceMesher::insert_inner() {
    const std::vector<VertexUse> points = sites_of_points(oracle_, chains_, grid_, face_, border_);
    for (const std::vector<VertexUse>* sites : {&points, &inner_}) {
        std::for_each(sites->begin(), sites->end(), [&](const VertexUse& site) { insert_inside(site); });
    }
    if (!points.empty() || !inner_.empty()) {
        find_inside();
    }
}

void FaceMesher::check_loops(const std::vector<std::optional<Vec2>>& middles) {
    for (const int piece : coarse_pieces_of_inverted_loops(oracle_, chains_, border_, middles)) {
        request_halving(piece);
    }
}

// Requests the split of the piece, or of the piece on the side beyond which its middle lies, if that one is much
// longer (see mark_crossing). Where both have similar lengths and meet in a corner, neither is split: tangent curves
// look the same at any length.
void FaceMesher::request_border_split(int piece, int side) {
    const int other = tri_->label(side);
    if (other < 0 || much_longer(piece, other)) {
        request_halving(piece);
    } else if (much_longer(other, piece)) {
        request_halving(other);
    }
}

// A piece whose middle on the curve lies beyond the apex of its triangle would fold that triangle when it is split.
void FaceMesher::reject_useless_halving(const std::vector<std::optional<Vec2>>& middles) {
    for (std::size_t k = 0; k < middles.size(); ++k) {
        const FaceBoundary::Piece& p = border_.pieces[k];
        const int a = planar_of_[p.from];
        const int b = planar_of_[p.to];
        const int h = !middles[k] || a == b ? -1 : tri_->find_edge(a, b);
        if (h < 0) {
            continue;
        }
        for (const int side : {h, tri_->twin(h)}) {
            if (side < 0 || inside_[side / 3] != 1) {
                continue;
            }
            const Vec2& from = tri_->point(tri_->corner(side));
            const Vec2& to = tri_->point(tri_->corner(ConstrainedDelaunay::next(side)));
            const Vec2& apex = tri_->point(tri_->corner(ConstrainedDelaunay::prev(side)));
            if (orient2d(apex, from, *middles[k]) <= 0) {
                request_border_split(static_cast<int>(k), ConstrainedDelaunay::prev(side));
            } else if (orient2d(to, apex, *middles[k]) <= 0) {
                request_border_split(static_cast<int>(k), ConstrainedDelaunay::next(side));
            }
        }
    }
}

Fault FaceMesher::fault(int t, const geometry::Answer& at_centroid) const {
    const std::array<const VertexUse*, 3> s{&corner_site(3 * t), &corner_site(3 * t + 1), &corner_site(3 * t + 2)};
    double longest = 0.0;
    for (int i = 0; i < 3; ++i) {
        longest = std::max(longest, (s[(i + 1) % 3]->point - s[i]->point).norm());
        if (same_vertex(*s[i], *s[(i + 1) % 3])) {
            // A side at a pole or along short edges is dropped later. Any other meets one vertex twice around the face.
            const int from = site_of_[tri_->corner(3 * t + i)];
            const int to = site_of_[tri_->corner(3 * t + (i + 1) % 3)];
            return border_.joined_by_collapsed(from, to) ? Fault::None : Fault::ChordDeviation;
        }
    }
    if (border_.plane || longest < smallest_) {
        return Fault::None;
    }
    return fault_of({s, at_centroid.point - grid_.origin(), at_centroid.normal,
                     oracle_.topology().faces[face_].reversed, InitialTuning::kMinHeights * border_.deviation,
                     reach()});
}

// Returns the side along which the normal turns most; or, where the turn is small and the triangle too thin for its
// chord error, the longest side in the scaled domain, with border sides counted double since they are the usual cause.
int FaceMesher::side_to_split(int t, Fault fault) const {
    double turn[3];
    double length[3];
    for (int i = 0; i < 3; ++i) {
        const int h = 3 * t + i;
        const int next = ConstrainedDelaunay::next(h);
        const Vec3& a = corner_site(h).normal;
        const Vec3& b = corner_site(next).normal;
        turn[i] = angle_between(a, b);
        length[i] = (tri_->point(tri_->corner(next)) - tri_->point(tri_->corner(h))).norm();
    }
    const int most = static_cast<int>(std::max_element(turn, turn + 3) - turn);
    if (fault == Fault::NormalDeviation && turn[most] > InitialTuning::kTurnThatCounts) {
        return most;
    }
    for (int i = 0; i < 3; ++i) {
        const int label = tri_->label(3 * t + i);
        length[i] *= label >= 0 && !border_.pieces[label].collapsed() ? 2.0 : 1.0;
    }
    return static_cast<int>(std::max_element(length, length + 3) - length);
}

void FaceMesher::ask_to_split(int t, Fault fault, std::vector<Side>& sides) {
    const int h = 3 * t + side_to_split(t, fault);
    const int label = tri_->label(h);
    if (label >= 0 && request_halving(label)) {
        return;
    }
    for (const int side : {h, ConstrainedDelaunay::next(h), ConstrainedDelaunay::prev(h)}) {
        const int a = tri_->corner(side);
        const int b = tri_->corner(ConstrainedDelaunay::next(side));
        if (tri_->label(side) < 0 && std::max(level(a), level(b)) < InitialTuning::kMaxLevel) {
            sides.push_back({std::min(a, b), std::max(a, b)});
            return;
        }
    }
}

geometry::Engine::Answers FaceMesher::at_centroids(const std::vector<int>& triangles) {
    geometry::Engine::Batch batch;
    batch.reserve(triangles.size());
    for (const int t : triangles) {
        const auto [a, b, c] = corners_of(t);
        const Vec2 uv = border_.unscaled((tri_->point(a) + tri_->point(b) + tri_->point(c)) / 3.0);
        batch.push_back(geometry::Query::face_point(face_, uv.x(), uv.y()));
    }
    return oracle_.ask(std::move(batch));
}

bool FaceMesher::refine_round() {
    std::vector<int> untested;
    fine_.resize(static_cast<std::size_t>(tri_->triangle_count()), Corners{-1, -1, -1});
    for (int t = 0; t < tri_->triangle_count(); ++t) {
        const Corners corners = corners_of(t);
        if (inside_[t] == 1 && fine_[t] != corners) {
            untested.push_back(t);
        }
    }
    geometry::Engine::Answers answers(untested.size());
    if (!border_.plane) {
        answers = at_centroids(untested);
    }
    std::vector<Side> sides;
    result_.unresolved = 0;
    for (std::size_t i = 0; i < untested.size(); ++i) {
        const int t = untested[i];
        const Fault found = fault(t, answers[i]);
        if (found == Fault::None) {
            fine_[t] = corners_of(t);
        } else {
            ++result_.unresolved;
            ask_to_split(t, found, sides);
        }
    }
    std::sort(sides.begin(), sides.end());
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    return insert_midpoints(sides);
}

// Whether a point on the side from a to b would be too close to the corners of the two triangles. Near an edge whose
// curve deviates from the surface, vertices no farther apart than this deviation form triangles with arbitrary
// normals.
bool FaceMesher::crowds(int a, int b, const Vec3& p) const {
    const int h = tri_->find_edge(a, b);
    if (h < 0) {
        return true;  // an earlier insertion flipped the side
    }
    const double least = std::max(reach(), InitialTuning::kMinHeights * border_.deviation);
    for (const int corner :
         {a, b, tri_->corner(ConstrainedDelaunay::prev(h)), tri_->corner(ConstrainedDelaunay::prev(tri_->twin(h)))}) {
        if (corner >= ConstrainedDelaunay::kFrame && (site_at(corner).point - p).norm() < least) {
            return true;
        }
    }
    return false;
}

// @param sides  ascending
bool FaceMesher::insert_midpoints(const std::vector<Side>& sides) {
    if (sides.empty() || tri_->vertex_count() > InitialTuning::kMaxSitesOfFace + static_cast<int>(inner_.size())) {
        return false;
    }
    geometry::Engine::Batch batch;
    batch.reserve(sides.size());
    std::vector<Vec2> places;
    for (const auto& [a, b] : sides) {
        places.push_back(0.5 * (tri_->point(a) + tri_->point(b)));
        const Vec2 uv = border_.unscaled(places.back());
        batch.push_back(geometry::Query::face_point(face_, uv.x(), uv.y()));
    }
    const geometry::Engine::Answers answers = oracle_.ask(std::move(batch));
    bool added = false;
    std::size_t i = 0;
    for (const auto& [a, b] : sides) {
        const geometry::Answer& answer = answers[i];
        VertexUse site;
        site.uv = border_.unscaled(places[i++]);
        site.normal = answer.normal;
        site.point = grid_.snap(answer.point);
        if (!answer.found() || crowds(a, b, site.point)) {
            continue;
        }
        const int v = tri_->insert(places[i - 1]);
        if (v == static_cast<int>(site_of_.size())) {
            site_of_.push_back(static_cast<int>(result_.sites.size()));
            result_.sites.push_back(site);
            level_.push_back(std::max(level(a), level(b)) + 1);
            added = true;
        }
    }
    return added;
}

Link FaceMesher::link_of(int h, const std::vector<int>& number) const {
    const int label = tri_->label(h);
    if (label < 0) {
        const int g = tri_->twin(h);
        return {3 * number[g / 3] + g % 3, -1};
    }
    const auto begins_here = [&](int k) { return planar_of_[border_.pieces[k].from] == tri_->corner(h); };
    const std::vector<int>& others = overlaps_[label];
    const auto other = begins_here(label) ? others.end() : std::find_if(others.begin(), others.end(), begins_here);
    return {-1, other == others.end() ? label : *other};
}

void FaceMesher::assemble() {
    std::vector<int> number(tri_->triangle_count(), -1);
    std::vector<int> kept;
    for (int t = 0; t < tri_->triangle_count(); ++t) {
        if (inside_[t] == 1) {
            number[t] = static_cast<int>(kept.size());
            kept.push_back(t);
        }
    }
    std::vector<Corners> triangles;
    std::vector<std::array<Link, 3>> links;
    triangles.reserve(kept.size());
    links.reserve(kept.size());
    for (const int t : kept) {
        triangles.push_back({kept_site(3 * t), kept_site(3 * t + 1), kept_site(3 * t + 2)});
        links.push_back({link_of(3 * t, number), link_of(3 * t + 1, number), link_of(3 * t + 2, number)});
    }
    for (const FaceBoundary::Piece& p : border_.pieces) {
        result_.borders.push_back({p.use, p.index});
    }
    if (close(triangles, std::move(links)) && oracle_.topology().faces[face_].reversed) {
        reverse_orientation(result_);
    }
}

// @return whether the face has a triangulation
bool FaceMesher::close(const std::vector<Corners>& triangles, std::vector<std::array<Link, 3>> links) {
    const auto closing = add_without_degenerate(triangles, std::move(links), result_);
    if (!closing) {
        return true;
    }
    for (const int piece : *closing) {
        mark_piece(piece);
    }
    if (result_.marks.empty()) {
        result_.failure = "it closes on itself at a collapsed edge";
    }
    return false;
}

}  // namespace

FaceMesh triangulate_face(geometry::Oracle& oracle, const EdgeDiscretisation& chains, const SinglePrecisionGrid& grid,
                          int face, bool border_may_change, const std::vector<FaceMesh::VertexUse>& inner) {
    return FaceMesher(oracle, chains, grid, face, border_may_change, inner).run();
}

void reverse_orientation(FaceMesh& face) {
    for (std::size_t t = 0; t < face.triangles.size(); ++t) {
        std::swap(face.triangles[t][1], face.triangles[t][2]);
        std::swap(face.links[t][0], face.links[t][2]);
        for (FaceMesh::Link& link : face.links[t]) {
            if (link.half_edge >= 0) {
                link.half_edge = 3 * (link.half_edge / 3) + 2 - link.half_edge % 3;
            }
        }
    }
}

}  // namespace mq::triangulate
