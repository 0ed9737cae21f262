// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/mixed/mixed_proof.h"

#include <algorithm>
#include <map>

#include "elements/product/check_elements.h"
#include "elements/product/element_jacobian.h"

namespace mq::given {

void prove_mixed(const std::vector<ElementNodes>& elements, int order, const std::vector<Vec3>& nodes,
                 const std::vector<std::size_t>& only, std::vector<double>& bounds, Progress& progress) {
    std::map<elements::ElementKind, std::vector<std::size_t>> by_kind;
    for (const std::size_t e : only) {
        by_kind[elements[e].kind].push_back(e);
    }
    for (const auto& [kind, members] : by_kind) {
        std::vector<std::int32_t> connectivity;
        for (const std::size_t e : members) {
            connectivity.insert(connectivity.end(), elements[e].nodes.begin(), elements[e].nodes.end());
        }
        const elements::ElementVerdicts found = elements::check_elements(
            kind, order, nodes, connectivity, elements::full_node_count(kind, order), &progress);
        for (std::size_t i = 0; i < members.size(); ++i) {
            const bool valid = found.verdict[i] == static_cast<std::uint8_t>(elements::Verdict::Valid);
            bounds[members[i]] = valid ? found.low[i] : std::min(found.low[i], 0.0);
        }
    }
}

double volume_of(const std::vector<ElementNodes>& elements, int order, const std::vector<Vec3>& nodes) {
    std::map<elements::ElementKind, elements::ElementJacobian> jacobians;
    double sum = 0.0;
    std::vector<Vec3> own;
    for (const ElementNodes& element : elements) {
        own.clear();
        for (const std::int32_t n : element.nodes) {
            own.push_back(nodes[static_cast<std::size_t>(n)]);
        }
        const auto of_kind =
            jacobians.try_emplace(element.kind, element.kind, order, elements::full_node_count(element.kind, order))
                .first;
        sum += of_kind->second.volume(own);
    }
    return sum;
}

}  // namespace mq::given
