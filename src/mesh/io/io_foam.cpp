// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/io/feature_edges.h"
#include "mesh/io/io_formats.h"

namespace mq::mesh {

namespace {

/// Opens a list of OpenFOAM.
void begin_list(Output& out, std::size_t count) {
    out.append_number(static_cast<long long>(count));
    out += "\n(\n";
}

void append_foam_point(Output& out, const Vec3& p) {
    out += '(';
    append_point_text(out, p, ")\n");
}

void append_edges(Output& out, const std::vector<std::array<std::int32_t, 2>>& edges) {
    begin_list(out, edges.size());
    for (const auto& edge : edges) {
        out += '(';
        out.append_number(static_cast<long long>(edge[0]));
        append_nodes(out, &edge[1], 1, 0, ' ', ")\n");
    }
    out += ")\n";
}

/// A subset of feature edges as cfMesh reads it: name, kind, indices.
void append_edge_subset(Output& out, const char* name, const std::vector<bool>& in) {
    constexpr const char* kFeatureEdges = "8";  // cfMesh's number of this kind of subset
    std::vector<std::int32_t> edges;
    for (std::size_t e = 0; e < in.size(); ++e) {
        if (in[e]) {
            edges.push_back(static_cast<std::int32_t>(e));
        }
    }
    out += std::string(name) + " " + kFeatureEdges + " " + std::to_string(edges.size()) + "(";
    append_nodes(out, edges.data(), edges.size(), 0, ' ', ")\n");
}

}  // namespace

void to_emesh(Output& out, const ExportMesh& mesh) {
    FeatureEdges features = feature_edges(mesh);
    std::vector<std::int32_t> number(mesh.nodes.size(), -1);
    std::vector<std::size_t> points;
    for (auto& edge : features.edges) {
        for (std::int32_t& node : edge) {
            const auto v = static_cast<std::size_t>(node);
            if (number[v] < 0) {
                number[v] = static_cast<std::int32_t>(points.size());
                points.push_back(v);
            }
            node = number[v];
        }
    }
    out +=
        "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       featureEdgeMesh;\n    object      "
        "MeshQuality.eMesh;\n}\n\n";
    begin_list(out, points.size());
    for (const std::size_t v : points) {
        append_foam_point(out, mesh.point(v));
    }
    out += ")\n\n";
    append_edges(out, features.edges);
}

void to_fms(Output& out, const ExportMesh& mesh) {
    begin_list(out, mesh.patches().size());
    for (const Group& patch : mesh.patches()) {
        out += patch.name + " wall\n";
    }
    out += ")\n";
    begin_list(out, mesh.nodes.size());
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        append_foam_point(out, mesh.point(i));
    }
    out += ")\n";
    begin_list(out, mesh.triangles().size());
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const std::int32_t* t = mesh.triangles().of(k);
        out += "((";
        out.append_number(static_cast<long long>(t[0]));
        append_nodes(out, t + 1, 2, 0, ' ', ")");
        append_nodes(out, &mesh.triangles().group[k], 1, 0, ' ', ")\n");
    }
    out += ")\n";
    const FeatureEdges features = feature_edges(mesh);
    append_edges(out, features.edges);
    out += "0\n(\n)\n0\n(\n)\n";  // subsets of points and of triangles: none
    begin_list(out, 2);
    append_edge_subset(out, "sharpEdges", features.sharp);
    append_edge_subset(out, "patchBorders", features.border);
    out += ")\n";
}

}  // namespace mq::mesh
