// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/incremental/mesh_cache.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace mq::triangulate {

namespace {

// The options that cached faces depend on, without the chord tolerance (compared in mm) and the local sizes (compared
// by face).
auto demands(const TriangulateOptions& o) {
    return std::make_tuple(o.min_angle, o.max_edge, o.min_edge, o.edges_per_circle, o.growth, o.insertion, o.order,
                           o.sites_in_round, o.evaluation, o.keep_edges, o.corners, o.feature_angle, o.method);
}

template <typename T>
std::size_t bytes_of(const std::vector<T>& v) {
    return v.size() * sizeof(T);
}

template <typename T>
std::size_t bytes_of(const std::vector<std::vector<T>>& v) {
    std::size_t sum = v.size() * sizeof(std::vector<T>);
    for (const std::vector<T>& inner : v) {
        sum += bytes_of(inner);
    }
    return sum;
}

std::size_t bytes_of(const mesh::TriangleMesh& m) {
    return bytes_of(m.vertices) + bytes_of(m.triangles) + bytes_of(m.triangle_face) + bytes_of(m.vertex_entity) +
           bytes_of(m.triangle_piece) + bytes_of(m.vertex_piece);
}

// Counts the most recently used runs that need at most `most` bytes together. Faces shared by several runs count once.
template <typename Runs>
std::size_t bytes_from_back(const Runs& runs, std::size_t most, std::size_t& count) {
    std::set<const CachedFace*> met;
    std::size_t sum = 0;
    count = 0;
    for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
        std::size_t more = bytes_of((*run)->result.mesh);
        for (const auto& [key, face] : (*run)->faces) {
            more += met.insert(face.get()).second ? face->bytes() : 0;
        }
        if (sum + more > most) {
            break;
        }
        sum += more;
        ++count;
    }
    return sum;
}

}  // namespace

std::size_t CachedFace::bytes() const {
    return sizeof(CachedFace) + bytes_of(parameters) + bytes_of(min_sample_count) + bytes_of(edge_parameters) +
           bytes_of(mesh.sites) + bytes_of(mesh.triangles) + bytes_of(mesh.links) + bytes_of(mesh.borders) +
           bytes_of(measured) + bytes_of(given_up);
}

bool CachedRun::serves(const TriangulateOptions& now) const {
    return demands(options) == demands(now);
}

std::shared_ptr<const CachedRun> MeshCache::run_on(const geometry::Fingerprint& input) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = std::find_if(runs_.begin(), runs_.end(), [&](const auto& run) { return run->input == input; });
    if (found == runs_.end()) {
        return nullptr;
    }
    std::rotate(found, found + 1, runs_.end());
    return runs_.back();
}

std::shared_ptr<const CachedRun> MeshCache::nearest(const std::vector<geometry::Fingerprint>& faces,
                                                    const TriangulateOptions& options) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::shared_ptr<const CachedRun> best;
    std::size_t most = 0;
    for (const auto& run : runs_) {
        std::size_t triangles = 0;
        for (const geometry::Fingerprint& face : faces) {
            const auto found = run->faces.find(face);
            triangles += found != run->faces.end() ? found->second->mesh.triangles.size() : 0;
        }
        if (run->serves(options) && triangles > 0 && triangles >= most) {
            best = run;
            most = triangles;
        }
    }
    return best;
}

void MeshCache::add(std::shared_ptr<const CachedRun> run) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto same = [&](const auto& other) { return other->input == run->input; };
    runs_.erase(std::remove_if(runs_.begin(), runs_.end(), same), runs_.end());
    runs_.push_back(std::move(run));
    evict();
}

void MeshCache::evict() {
    std::size_t count = 0;
    bytes_from_back(runs_, most_bytes_, count);
    count = std::min(count, most_runs_);
    runs_.erase(runs_.begin(), runs_.end() - static_cast<std::ptrdiff_t>(count));
}

std::size_t MeshCache::runs() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return runs_.size();
}

std::size_t MeshCache::bytes() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::size_t count = 0;
    return bytes_from_back(runs_, static_cast<std::size_t>(-1), count);
}

}  // namespace mq::triangulate
