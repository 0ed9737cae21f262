// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/classified_mesh.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "mesh/first_use_numbers.h"
#include "mesh/morton_sort.h"

namespace mq::triangulate {

namespace {

// Marks a half-edge that is neither linked nor bound yet: names ClassifiedMesh::kLooseSide.
constexpr int kLoose = ~0;

// Returns the triangles in the order of a Morton curve, so that near triangles are near in the list.
LargeVector<int> along_morton_curve(const ClassifiedMesh& mesh) {
    LargeVector<mesh::MortonKey> keys(static_cast<std::size_t>(mesh.triangle_count()));
    const MortonCurve curve(mesh);
    for_each_in_ranges(keys.size(), [&](std::size_t t) {
        keys[t] = {curve.place(static_cast<int>(t)), static_cast<std::uint32_t>(t)};
    });
    mesh::sort_by_code(keys);
    LargeVector<int> order(keys.size());
    for_each_in_ranges(keys.size(), [&](std::size_t i) { order[i] = static_cast<int>(keys[i].item); });
    return order;
}

int moved_half_edge(const NewIndices& renewed, int h) {
    return 3 * renewed.triangles[static_cast<std::size_t>(h / 3)] + h % 3;
}

}  // namespace

MortonCurve::MortonCurve(const ClassifiedMesh& mesh) : mesh_(mesh) {
    Vec3 high = low_ = mesh.points().front();
    for (const Vec3& p : mesh.points()) {
        low_ = low_.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double side = (high - low_).maxCoeff();
    scale_ = side > 0.0 ? (mesh::kMortonCells - 1) / (3.0 * side) : 0.0;
}

std::uint32_t MortonCurve::place(int t) const {
    const Vec3 cell =
        (mesh_.point_of(3 * t) + mesh_.point_of(3 * t + 1) + mesh_.point_of(3 * t + 2) - 3.0 * low_) * scale_;
    return mesh::morton_code({cell.x(), cell.y(), cell.z()});
}

thread_local ClassifiedMesh::Share* ClassifiedMesh::share_ = nullptr;

int ClassifiedMesh::add_vertex(const Vec3& point, mesh::VertexEntity entity) {
    if (share_ != nullptr) {
        points_[share_->vertex] = point;
        entities_[share_->vertex] = entity;
        return share_->vertex++;
    }
    points_.push_back(point);
    entities_.push_back(entity);
    return vertex_count() - 1;
}

int ClassifiedMesh::add_site(const VertexUse& site) {
    int index = site_count();
    if (share_ != nullptr) {
        index = share_->site++;
        sites_[index] = site;
    } else {
        sites_.push_back(site);
    }
    sites_[index].point = points_[site.vertex];
    return index;
}

int ClassifiedMesh::add_triangle(const std::array<int, 3>& sites, int face) {
    if (share_ != nullptr) {
        const int t = share_->triangle++;
        std::copy(sites.begin(), sites.end(), corner_.begin() + 3 * t);
        face_[t] = face;
        return t;
    }
    for (const int s : sites) {
        corner_.push_back(s);
        twin_.push_back(kLoose);
        number_.push_back(-1);
    }
    face_.push_back(face);
    if (stamp_.size() < face_.size()) {
        stamp_.push_back(0);
    } else {  // the index was used before, and marks of its former triangle must not hold for this one
        ++stamp_[face_.size() - 1];
    }
    return triangle_count() - 1;
}

int ClassifiedMesh::add_segment(int edge, const std::array<int, 2>& vertices, const std::array<double, 2>& t) {
    segments_.push_back({edge, vertices, t, {}});
    return segment_count() - 1;
}

int ClassifiedMesh::new_number() {
    return share_ == nullptr ? numbers_++ : share_->number++;
}

// Returns what `twin_` is on that side.
int ClassifiedMesh::add_side(int segment, int slot) {
    sides_.push_back({segment, slot});
    return ~(static_cast<int>(sides_.size()) - 1);
}

void ClassifiedMesh::link(int half_edge, int twin) {
    twin_[half_edge] = twin;
    twin_[twin] = half_edge;
    number_[half_edge] = new_number();
    number_[twin] = number_[half_edge];
}

void ClassifiedMesh::bind(int half_edge, int segment, int use) {
    twin_[half_edge] = add_side(segment, static_cast<int>(segments_[segment].uses.size()));
    number_[half_edge] = new_number();
    segments_[segment].uses.push_back({half_edge, use});
}

int ClassifiedMesh::edge_count() const {
    std::size_t on_segments = 0;
    for (const Segment& segment : segments_) {
        on_segments += segment.uses.size();
    }
    return (3 * used_triangle_count() + static_cast<int>(on_segments)) / 2;
}

LargeVector<int> ClassifiedMesh::renumber_edges() {
    LargeVector<int> renewed(static_cast<std::size_t>(numbers_), -1);
    for_each_in_ranges(number_.size(), [&](std::size_t i) {
        const int h = static_cast<int>(i);
        if (twin_[h] < h && !gone(triangle_of(h))) {  // each edge at one of its half-edges
            renewed[number_[h]] = 0;
        }
    });
    dropped_ += numbers_;
    numbers_ = 0;
    for (int& number : renewed) {
        number = number < 0 ? -1 : numbers_++;
    }
    dropped_ -= numbers_;
    for_each_in_ranges(number_.size(), [&](std::size_t h) {
        if (!gone(triangle_of(static_cast<int>(h)))) {
            number_[h] = renewed[number_[h]];
        }
    });
    return renewed;
}

// Vertices of segments that are gone stay, too: they are few.
NewIndices ClassifiedMesh::new_indices(const LargeVector<int>& order, int vertices, int sites) {
    NewIndices renewed;
    renewed.triangles.resize(order.size());
    for_each_in_ranges(order.size(), [&](std::size_t i) { renewed.triangles[order[i]] = static_cast<int>(i); });
    const std::size_t count = 3 * order.size();
    const auto half_edge = [&](std::size_t i) { return 3 * order[i / 3] + static_cast<int>(i % 3); };
    const auto number = [&](LargeVector<int>& indices, std::size_t all, int first, const auto& index_at) {
        indices.assign(all, -1);
        std::iota(indices.begin(), indices.begin() + first, 0);
        return mesh::number_by_first_use(count, index_at, first, indices);
    };
    vertices =
        number(renewed.vertices, points_.size(), vertices, [&](std::size_t i) { return vertex_of(half_edge(i)); });
    number(renewed.sites, sites_.size(), sites, [&](std::size_t i) { return corner_[half_edge(i)]; });
    const int numbers = number(renewed.edges, static_cast<std::size_t>(numbers_), 0,
                               [&](std::size_t i) { return number_[half_edge(i)]; });
    for (const Segment& segment : segments_) {
        for (const int v : segment.vertices) {
            renewed.vertices[v] = renewed.vertices[v] < 0 ? vertices++ : renewed.vertices[v];
        }
    }
    dropped_ += numbers_ - numbers;
    numbers_ = numbers;
    return renewed;
}

void ClassifiedMesh::move_triangles(const LargeVector<int>& order, const NewIndices& renewed) {
    const auto move_corners = [&](LargeVector<int>& values, const auto& changed) {
        LargeVector<int> moved(values.size());
        for_each_in_ranges(order.size(), [&](std::size_t i) {
            for (int k = 0; k < 3; ++k) {
                moved[3 * i + k] = changed(values[3 * order[i] + k]);
            }
        });
        values.swap(moved);
    };
    move_corners(corner_, [&](int site) { return renewed.sites[site]; });
    move_corners(twin_, [&](int twin) { return twin < 0 ? twin : moved_half_edge(renewed, twin); });
    move_corners(number_, [&](int number) { return renewed.edges[number]; });
    move_to_indices(renewed.triangles, face_, -1);
    LargeVector<std::uint32_t> dropped(stamp_.begin() + triangle_count(), stamp_.end());
    stamp_.resize(face_.size());
    move_to_indices(renewed.triangles, stamp_, 0);
    stamp_.insert(stamp_.end(), dropped.begin(), dropped.end());
}

NewIndices ClassifiedMesh::order_in_space(int vertices, int sites) {
    const LargeVector<int> order = along_morton_curve(*this);
    NewIndices renewed = new_indices(order, vertices, sites);
    move_triangles(order, renewed);
    for_each_in_ranges(segments_.size(), [&](std::size_t s) {
        for (int& v : segments_[s].vertices) {
            v = renewed.vertices[v];
        }
        for (SegmentUse& use : segments_[s].uses) {
            use.half_edge = moved_half_edge(renewed, use.half_edge);
        }
    });
    for_each_in_ranges(sites_.size(), [&](std::size_t s) { sites_[s].vertex = renewed.vertices[sites_[s].vertex]; });
    move_to_indices(renewed.sites, sites_, {});
    move_to_indices(renewed.vertices, points_, Vec3::Zero());
    move_to_indices(renewed.vertices, entities_, {-1, -1});
    ++dropped_;  // data that are stored by indices of triangles are no longer valid
    return renewed;
}

void ClassifiedMesh::put(int h, const Link& link) {
    twin_[h] = link.twin;
    number_[h] = link.number;
    if (link.twin >= 0) {
        twin_[link.twin] = h;
    } else if (link.twin != kLoose) {
        const SegmentSide side = sides_[~link.twin];
        segments_[side.segment].uses[side.slot].half_edge = h;
    }
}

void ClassifiedMesh::set_corners(int triangle, int a, int b, int c) {
    corner_[3 * triangle] = a;
    corner_[3 * triangle + 1] = b;
    corner_[3 * triangle + 2] = c;
    ++stamp_[triangle];
}

std::array<int, 3> ClassifiedMesh::split_triangle(int triangle, int site) {
    const int h = 3 * triangle;
    const int a = corner_[h];
    const int b = corner_[h + 1];
    const int c = corner_[h + 2];
    const Link bc = link_of(h + 1);
    const Link ca = link_of(h + 2);
    const int t1 = add_triangle({b, c, site}, face_[triangle]);
    const int t2 = add_triangle({c, a, site}, face_[triangle]);
    set_corners(triangle, a, b, site);
    put(3 * t1, bc);
    put(3 * t2, ca);
    link(h + 1, 3 * t1 + 2);
    link(3 * t1 + 1, 3 * t2 + 2);
    link(3 * t2 + 1, h + 2);
    return {triangle, t1, t2};
}

int ClassifiedMesh::split_segment(int segment, int vertex, double t, const std::vector<int>& sites) {
    const int far =
        add_segment(segments_[segment].edge, {vertex, segments_[segment].vertices[1]}, {t, segments_[segment].t[1]});
    const int start = segments_[segment].vertices[0];
    segments_[segment].vertices[1] = vertex;
    segments_[segment].t[1] = t;
    for (std::size_t k = 0; k < segments_[segment].uses.size(); ++k) {
        const int h = segments_[segment].uses[k].half_edge;
        const int tri = triangle_of(h);
        const int a = corner_[h];
        const int b = corner_[next(h)];
        const int c = corner_[prev(h)];
        const bool along = sites_[a].vertex == start;
        const int side = twin_[h];
        const Link bc = link_of(next(h));
        const Link ca = link_of(prev(h));
        const int added = add_triangle({sites[k], b, c}, face_[tri]);
        set_corners(tri, a, sites[k], c);
        put(3 * tri + 2, ca);
        put(3 * added + 1, bc);
        link(3 * tri + 1, 3 * added + 2);
        const int near_half = along ? 3 * tri : 3 * added;
        const int far_half = along ? 3 * added : 3 * tri;
        put(near_half, {side, new_number()});
        bind(far_half, far, segments_[segment].uses[k].use);
    }
    return far;
}

void ClassifiedMesh::swap(int h) {
    const int g = twin_[h];
    const int t = triangle_of(h);
    const int o = triangle_of(g);
    const int a = corner_[h];
    const int b = corner_[next(h)];
    const int c = corner_[prev(h)];
    const int d = corner_[prev(g)];
    const Link bc = link_of(next(h));
    const Link ca = link_of(prev(h));
    const Link ad = link_of(next(g));
    const Link db = link_of(prev(g));
    set_corners(t, a, d, c);
    set_corners(o, d, b, c);
    put(3 * t, ad);
    put(3 * t + 2, ca);
    put(3 * o, db);
    put(3 * o + 1, bc);
    link(3 * t + 1, 3 * o + 2);
}

void ClassifiedMesh::dissolve(int segment) {
    std::vector<SegmentUse>& uses = segments_[segment].uses;
    link(uses[0].half_edge, uses[1].half_edge);
    uses.clear();
}

std::vector<int> ClassifiedMesh::replace(const std::vector<int>& removed,
                                         const std::vector<std::array<int, 3>>& added) {
    using Side = std::pair<int, int>;
    std::map<Side, Link> rim;
    for (const int t : removed) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const int g = twin(h);
            if (g < 0 || std::find(removed.begin(), removed.end(), triangle_of(g)) == removed.end()) {
                rim.emplace(Side(corner_[h], corner_[next(h)]), link_of(h));
            }
        }
    }
    const int face = face_[removed.front()];
    std::vector<int> indices;
    std::map<Side, int> open;
    for (std::size_t i = 0; i < added.size(); ++i) {
        const auto& c = added[i];
        indices.push_back(i < removed.size() ? removed[i] : add_triangle(c, face));
        set_corners(indices.back(), c[0], c[1], c[2]);
        for (int k = 0; k < 3; ++k) {
            const int h = 3 * indices.back() + k;
            const Side side(c[k], c[(k + 1) % 3]);
            if (const auto found = rim.find(side); found != rim.end()) {
                put(h, found->second);
                rim.erase(found);
            } else if (const auto other = open.find({side.second, side.first}); other != open.end()) {
                link(h, other->second);
                open.erase(other);
            } else {
                open.emplace(side, h);
            }
        }
    }
    link_by_vertices(open, rim);
    for (std::size_t i = added.size(); i < removed.size(); ++i) {
        face_[removed[i]] = -1;
        ++stamp_[removed[i]];
        gone_.push_back(removed[i]);
    }
    return indices;
}

// Links half-edges by the vertices that they join: to what is left of the rim, and to each other. Where a side of the
// parameter domain is a point in space, and along a dissolved seam, a vertex has several sites: the two sides of an
// edge end at different ones, and swaps across the edge exchange them.
void ClassifiedMesh::link_by_vertices(const std::map<std::pair<int, int>, int>& open,
                                      const std::map<std::pair<int, int>, Link>& rim) {
    std::map<std::pair<int, int>, Link> by_vertices;
    for (const auto& [side, link] : rim) {
        by_vertices.emplace(std::pair(sites_[side.first].vertex, sites_[side.second].vertex), link);
    }
    std::map<std::pair<int, int>, int> others;
    for (const auto& [side, h] : open) {
        const auto on_rim = by_vertices.find({vertex_of(h), vertex_of(next(h))});
        if (on_rim != by_vertices.end()) {
            put(h, on_rim->second);
            by_vertices.erase(on_rim);
            continue;
        }
        const auto other = others.find({vertex_of(next(h)), vertex_of(h)});
        if (other != others.end()) {
            link(h, other->second);
        } else {
            others.emplace(std::pair(vertex_of(h), vertex_of(next(h))), h);
        }
    }
}

std::vector<int> ClassifiedMesh::join_segments(int near, int far, const std::vector<CavityFill>& refills) {
    segments_[near].vertices[1] = segments_[far].vertices[1];
    segments_[near].t[1] = segments_[far].t[1];
    std::vector<int> all;
    for (std::size_t k = 0; k < refills.size(); ++k) {
        const int side = twin_[segments_[near].uses[k].half_edge];
        const std::vector<int> added = replace(refills[k].removed, refills[k].added);
        all.insert(all.end(), added.begin(), added.end());
        for (const int t : added) {
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                if (corner_[h] == refills[k].base[0] && corner_[next(h)] == refills[k].base[1]) {
                    put(h, {side, new_number()});
                }
            }
        }
    }
    segments_[far].uses.clear();
    return all;
}

void ClassifiedMesh::replace_between(int near, int far, int vertex, double t,
                                     const std::vector<std::vector<int>>& spokes, const std::vector<int>& sites) {
    segments_[near].vertices[1] = vertex;
    segments_[near].t[1] = t;
    segments_[far].vertices[0] = vertex;
    segments_[far].t[0] = t;
    for (std::size_t k = 0; k < spokes.size(); ++k) {
        for (const int h : spokes[k]) {
            corner_[h] = sites[k];
            ++stamp_[triangle_of(h)];
            number_[h] = new_number();
            if (twin(h) >= 0) {
                number_[twin_[h]] = number_[h];
            }
        }
        number_[prev(spokes[k].back())] = new_number();
    }
}

std::vector<std::pair<int, int>> ClassifiedMesh::compact() {
    std::vector<std::pair<int, int>> moved;
    const int before = triangle_count();
    std::sort(gone_.begin(), gone_.end());
    for (const int hole : gone_) {
        while (triangle_count() > hole && gone(triangle_count() - 1)) {
            drop_last_triangle();
        }
        if (hole >= triangle_count()) {
            break;
        }
        const int last = triangle_count() - 1;
        face_[hole] = face_[last];
        stamp_[hole] = std::max(stamp_[hole], stamp_[last]) + 1;
        for (int k = 0; k < 3; ++k) {
            corner_[3 * hole + k] = corner_[3 * last + k];
            put(3 * hole + k, link_of(3 * last + k));
        }
        ++stamp_[last];
        moved.emplace_back(last, hole);
        drop_last_triangle();
    }
    gone_.clear();
    // Releases the memory of triangles that are gone, where they are this fraction of all or more: it takes a copy.
    constexpr int kWorthACopy = 16;  // one in
    if (before - triangle_count() > before / kWorthACopy) {
        corner_.shrink_to_fit();
        twin_.shrink_to_fit();
        number_.shrink_to_fit();
        face_.shrink_to_fit();
    }
    return moved;
}

void ClassifiedMesh::drop_last_triangle() {
    corner_.resize(corner_.size() - 3);
    twin_.resize(twin_.size() - 3);
    number_.resize(number_.size() - 3);
    face_.pop_back();
}

bool ClassifiedMesh::leads_to(int h, int vertex) const {
    int g = h;
    for (int on = h; on >= 0; on = twin(prev(g))) {
        g = on;
        if (vertex_of(next(g)) == vertex) {
            return true;
        }
        if (twin(prev(g)) == h) {
            return false;
        }
    }
    if (vertex_of(prev(g)) == vertex) {
        return true;
    }
    for (g = twin(h); g >= 0; g = twin(next(g))) {  // the turn ends at a segment: the other way round
        if (vertex_of(prev(g)) == vertex) {
            return true;
        }
    }
    return false;
}

std::vector<int> ClassifiedMesh::star(int h, std::size_t most) const {
    int first = h;
    std::size_t steps = 0;
    for (int g = twin(h); g >= 0; g = twin(first)) {  // clockwise, to the cut or once around
        first = next(g);
        if (first == h) {
            break;
        }
        if (++steps >= most) {
            return {};
        }
    }
    constexpr std::size_t kUsual = 12;  // Typical number of triangles around a vertex, for which memory is reserved.
    std::vector<int> result;
    result.reserve(kUsual);
    result.push_back(first);
    for (int g = twin(prev(first)); g >= 0 && g != first; g = twin(prev(g))) {
        if (result.size() >= most) {
            return {};
        }
        result.push_back(g);
    }
    return result;
}

std::vector<std::vector<int>> ClassifiedMesh::triangles_by_face(std::size_t faces) const {
    std::vector<std::size_t> counts(faces, 0);
    for (const int face : face_) {
        ++counts[static_cast<std::size_t>(face)];
    }
    std::vector<std::vector<int>> result(faces);
    for (std::size_t f = 0; f < faces; ++f) {
        result[f].reserve(counts[f]);
    }
    for (int t = 0; t < triangle_count(); ++t) {
        result[face_of(t)].push_back(t);
    }
    return result;
}

std::string ClassifiedMesh::inconsistency() const {
    for (int h = 0; h < half_edge_count(); ++h) {
        if (gone(triangle_of(h))) {
            continue;
        }
        const std::string name = "half-edge " + std::to_string(h);
        if (twin_[h] == kLoose) {
            return name + " is neither linked nor on a segment";
        }
        const int from = vertex_of(h);
        const int to = vertex_of(next(h));
        if (from == to) {
            return name + " runs from a vertex to itself";
        }
        if (twin_[h] >= 0) {
            const int g = twin_[h];
            if (twin_[g] != h || vertex_of(g) != to || vertex_of(next(g)) != from || number_[g] != number_[h]) {
                return name + " and its twin do not match";
            }
            continue;
        }
        const SegmentSide side = sides_[~twin_[h]];
        const Segment& s = segments_[side.segment];
        const bool same =
            (s.vertices[0] == from && s.vertices[1] == to) || (s.vertices[0] == to && s.vertices[1] == from);
        if (!same || s.uses[side.slot].half_edge != h) {
            return name + " does not match its segment";
        }
    }
    return {};
}

}  // namespace mq::triangulate
