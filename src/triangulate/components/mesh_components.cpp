// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/components/mesh_components.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/disjoint_sets.h"

namespace mq::triangulate {

namespace {

template <typename Item>
bool more_work(const Item& a, const Item& b) {
    return a.work > b.work;
}

DisjointSets<int> joined_vertices(const ClassifiedMesh& mesh, const std::vector<int>& together) {
    DisjointSets<int> joined(static_cast<std::size_t>(mesh.vertex_count()));
    for (int h = 0; h < mesh.half_edge_count(); ++h) {
        joined.unite(mesh.vertex_of(h), mesh.vertex_of(ClassifiedMesh::next(h)));
    }
    std::vector<int> first(together.size(), -1);  // by number of faces: a vertex
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        int& vertex = first[static_cast<std::size_t>(together[static_cast<std::size_t>(mesh.face_of(t))])];
        vertex = vertex < 0 ? mesh.vertex_of(3 * t) : vertex;
        joined.unite(vertex, mesh.vertex_of(3 * t));
    }
    return joined;
}

/// Copies triangles of a mesh, with all that they use, into a mesh of their own.
class Cutting {
  public:
    Cutting(const ClassifiedMesh& mesh, std::vector<int> triangles, const Progress* progress)
        : mesh_(mesh),
          pace_(progress),
          triangles_(static_cast<std::size_t>(mesh.triangle_count()), -1),
          vertices_(static_cast<std::size_t>(mesh.vertex_count()), -1),
          sites_(static_cast<std::size_t>(mesh.site_count()), -1),
          segments_(static_cast<std::size_t>(mesh.segment_count()), -1) {
        result_.triangles = std::move(triangles);
        mark();
        result_.vertices = numbered(vertices_);
        result_.sites = numbered(sites_);
        result_.segments = numbered(segments_);
        add_corners();
        add_triangles();
        add_segments();
    }

    MeshComponent release() { return std::move(result_); }

  private:
    using Numbers = std::vector<int>;  // by index in the mesh: the index here, or -1

    static int& at(Numbers& numbers, int index) { return numbers[static_cast<std::size_t>(index)]; }

    void mark() {
        int count = 0;
        for (const int t : result_.triangles) {
            pace_.step();
            at(triangles_, t) = count++;
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                at(sites_, mesh_.site_of(h)) = 0;
                at(vertices_, mesh_.vertex_of(h)) = 0;
                if (mesh_.segment_of(h) >= 0) {
                    at(segments_, mesh_.segment_of(h)) = 0;
                }
            }
        }
    }

    // Numbers the marked entities in the order of the mesh.
    // @return their indices in the mesh
    std::vector<int> numbered(Numbers& numbers) {
        std::vector<int> marked;
        for (int i = 0; i < static_cast<int>(numbers.size()); ++i) {
            pace_.step();
            if (at(numbers, i) >= 0) {
                at(numbers, i) = static_cast<int>(marked.size());
                marked.push_back(i);
            }
        }
        return marked;
    }

    int half_edge(int h) { return 3 * at(triangles_, ClassifiedMesh::triangle_of(h)) + h % 3; }

    void add_corners() {
        for (const int v : result_.vertices) {
            pace_.step();
            result_.mesh.add_vertex(mesh_.vertex(v).point, mesh_.vertex(v).entity);
        }
        for (const int s : result_.sites) {
            pace_.step();
            ClassifiedMesh::VertexUse site = mesh_.site(s);
            site.vertex = at(vertices_, site.vertex);
            result_.mesh.add_site(site);
        }
    }

    void add_triangles() {
        for (const int t : result_.triangles) {
            pace_.step();
            std::array<int, 3> corners{};
            for (int k = 0; k < 3; ++k) {
                corners[static_cast<std::size_t>(k)] = at(sites_, mesh_.site_of(3 * t + k));
            }
            result_.mesh.add_triangle(corners, mesh_.face_of(t));
        }
        for (const int t : result_.triangles) {
            pace_.step();
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                if (h < mesh_.twin(h)) {
                    result_.mesh.link(half_edge(h), half_edge(mesh_.twin(h)));
                }
            }
        }
    }

    void add_segments() {
        for (const int s : result_.segments) {
            pace_.step();
            const ClassifiedMesh::Segment& segment = mesh_.segment(s);
            const int added = result_.mesh.add_segment(
                segment.edge, {at(vertices_, segment.vertices[0]), at(vertices_, segment.vertices[1])}, segment.t);
            for (const ClassifiedMesh::SegmentUse& use : segment.uses) {
                result_.mesh.bind(half_edge(use.half_edge), added, use.use);
            }
        }
    }

    const ClassifiedMesh& mesh_;
    CancelPace pace_;
    Numbers triangles_;
    Numbers vertices_;
    Numbers sites_;
    Numbers segments_;
    MeshComponent result_;
};

// The indices of a component's entities in the whole mesh: the former ones keep theirs, the others are appended.
std::vector<int> indices(std::vector<int> former, int count, int& next) {
    former.resize(static_cast<std::size_t>(count), -1);
    for (int& index : former) {
        index = index < 0 ? next++ : index;
    }
    return former;
}

/// Joins components one entity after the other.
class Joining {
  public:
    Joining(const ClassifiedMesh& divided, const std::vector<const MeshComponent*>& changed, const Progress* progress)
        : divided_(divided), changed_(changed), pace_(progress) {
        int vertex = divided.vertex_count();
        int site = divided.site_count();
        int segment = divided.segment_count();
        for (const MeshComponent* of : changed) {
            vertices_.push_back(indices(of->vertices, of->mesh.vertex_count(), vertex));
            sites_.push_back(indices(of->sites, of->mesh.site_count(), site));
            segments_.push_back(indices(of->segments, of->mesh.segment_count(), segment));
        }
        segment = leave_out_unused(segment);
        add_vertices(vertex);
        add_sites(site);
        add_triangles();
        add_segments(segment);
    }

    JoinedComponents release() {
        result_.vertices = std::move(vertices_);
        return std::move(result_);
    }

  private:
    // Calls `see(component, index there, index in the whole)` for the entities of all components.
    template <typename See>
    void for_each(const std::vector<std::vector<int>>& indices, const See& see) {
        for (std::size_t c = 0; c < changed_.size(); ++c) {
            for (std::size_t i = 0; i < indices[c].size(); ++i) {
                pace_.step();
                see(c, static_cast<int>(i), indices[c][i]);
            }
        }
    }

    // Numbers segments without those that no component has.
    // @return the new count
    int leave_out_unused(int count) {
        std::vector<int> renewed(static_cast<std::size_t>(count), -1);
        for (const std::vector<int>& of_component : segments_) {
            for (const int s : of_component) {
                renewed[static_cast<std::size_t>(s)] = 0;
            }
        }
        int next = 0;
        for (int& number : renewed) {
            number = number < 0 ? -1 : next++;
        }
        for (std::vector<int>& of_component : segments_) {
            for (int& s : of_component) {
                s = renewed[static_cast<std::size_t>(s)];
            }
        }
        return next;
    }

    void add_vertices(int count) {
        std::vector<ClassifiedMesh::Vertex> vertices(static_cast<std::size_t>(count));
        for (int v = 0; v < divided_.vertex_count(); ++v) {
            vertices[static_cast<std::size_t>(v)] = divided_.vertex(v);
        }
        for_each(vertices_, [&](std::size_t c, int here, int whole) {
            vertices[static_cast<std::size_t>(whole)] = changed_[c]->mesh.vertex(here);
        });
        for (const ClassifiedMesh::Vertex& vertex : vertices) {
            result_.mesh.add_vertex(vertex.point, vertex.entity);
        }
    }

    void add_sites(int count) {
        std::vector<ClassifiedMesh::VertexUse> sites(static_cast<std::size_t>(count));
        for (int s = 0; s < divided_.site_count(); ++s) {
            sites[static_cast<std::size_t>(s)] = divided_.site(s);
        }
        for_each(sites_, [&](std::size_t c, int here, int whole) {
            ClassifiedMesh::VertexUse site = changed_[c]->mesh.site(here);
            site.vertex = vertices_[c][static_cast<std::size_t>(site.vertex)];
            sites[static_cast<std::size_t>(whole)] = site;
        });
        for (const ClassifiedMesh::VertexUse& site : sites) {
            result_.mesh.add_site(site);
        }
    }

    void add_triangles() {
        for (std::size_t c = 0; c < changed_.size(); ++c) {
            const ClassifiedMesh& mesh = changed_[c]->mesh;
            result_.first.push_back(result_.mesh.triangle_count());
            for (int t = 0; t < mesh.triangle_count(); ++t) {
                pace_.step();
                std::array<int, 3> corners{};
                for (int k = 0; k < 3; ++k) {
                    corners[static_cast<std::size_t>(k)] = sites_[c][static_cast<std::size_t>(mesh.site_of(3 * t + k))];
                }
                result_.mesh.add_triangle(corners, mesh.face_of(t));
            }
            const int base = 3 * result_.first.back();
            for (int h = 0; h < mesh.half_edge_count(); ++h) {
                pace_.step();
                if (h < mesh.twin(h)) {
                    result_.mesh.link(base + h, base + mesh.twin(h));
                }
            }
        }
    }

    void add_segments(int count) {
        std::vector<ClassifiedMesh::Segment> segments(static_cast<std::size_t>(count));
        for_each(segments_, [&](std::size_t c, int here, int whole) {
            ClassifiedMesh::Segment segment = changed_[c]->mesh.segment(here);
            for (int& v : segment.vertices) {
                v = vertices_[c][static_cast<std::size_t>(v)];
            }
            for (ClassifiedMesh::SegmentUse& use : segment.uses) {
                use.half_edge += 3 * result_.first[c];
            }
            segments[static_cast<std::size_t>(whole)] = std::move(segment);
        });
        for (const ClassifiedMesh::Segment& segment : segments) {
            const int added = result_.mesh.add_segment(segment.edge, segment.vertices, segment.t);
            for (const ClassifiedMesh::SegmentUse& use : segment.uses) {
                result_.mesh.bind(use.half_edge, added, use.use);
            }
        }
    }

    const ClassifiedMesh& divided_;
    const std::vector<const MeshComponent*>& changed_;
    CancelPace pace_;
    std::vector<std::vector<int>> vertices_;  // by component and index in it: index in the whole
    std::vector<std::vector<int>> sites_;
    std::vector<std::vector<int>> segments_;
    JoinedComponents result_;
};

}  // namespace

std::vector<MeshBody> bodies_of(const ClassifiedMesh& mesh, const std::vector<int>& together,
                                const std::vector<double>& work) {
    DisjointSets<int> joined = joined_vertices(mesh, together);
    std::vector<int> body_at(static_cast<std::size_t>(mesh.vertex_count()), -1);
    std::vector<MeshBody> result;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        int& body = body_at[static_cast<std::size_t>(joined.find(mesh.vertex_of(3 * t)))];
        if (body < 0) {
            body = static_cast<int>(result.size());
            result.emplace_back();
        }
        result[static_cast<std::size_t>(body)].work += work[static_cast<std::size_t>(t)];
        result[static_cast<std::size_t>(body)].triangles.push_back(t);
    }
    std::stable_sort(result.begin(), result.end(), more_work<MeshBody>);
    return result;
}

std::vector<std::vector<int>> groups_of(const std::vector<double>& work, std::size_t most) {
    struct Group {
        double work;
        std::vector<int> items;
    };
    std::vector<Group> groups;
    for (std::size_t i = 0; i < work.size(); ++i) {
        groups.push_back({work[i], {static_cast<int>(i)}});
    }
    for (; groups.size() > most; groups.pop_back()) {  // added to the smallest group that stays
        const Group& last = groups.back();
        Group& smallest =
            *std::max_element(groups.begin(), groups.begin() + static_cast<std::ptrdiff_t>(most), more_work<Group>);
        smallest.work += last.work;
        smallest.items.insert(smallest.items.end(), last.items.begin(), last.items.end());
    }
    std::stable_sort(groups.begin(), groups.end(), more_work<Group>);
    std::vector<std::vector<int>> result;
    for (Group& group : groups) {
        result.push_back(std::move(group.items));
    }
    return result;
}

MeshComponent component_of(const ClassifiedMesh& mesh, std::vector<int> triangles, const Progress* progress) {
    return Cutting(mesh, std::move(triangles), progress).release();
}

JoinedComponents join(const ClassifiedMesh& divided, const std::vector<const MeshComponent*>& changed,
                      const Progress* progress) {
    return Joining(divided, changed, progress).release();
}

}  // namespace mq::triangulate
