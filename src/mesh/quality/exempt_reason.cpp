// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/exempt_reason.h"

#include <cstdio>
#include <iterator>
#include <string>
#include <utility>

#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::mesh {

namespace {

static_assert(std::size(phrases::kExempt) == static_cast<std::size_t>(ExemptCause::NoChangeWithinTolerance) + 1,
              "one phrase for each cause");

const phrases::Exempt& phrase_of(ExemptCause cause) {
    return phrases::kExempt[static_cast<std::size_t>(cause)];
}

bool is_there(const NamedEntity& entity) {
    return entity.dimension >= 0;
}

}  // namespace

Message name_of(const NamedEntity& entity) {
    // FreeCAD's names of sub-elements, by dimension.
    static constexpr std::array<const char*, 3> kKinds{"Vertex", "Edge", "Face"};
    const auto kind = static_cast<std::size_t>(entity.of_shape[0]);
    Message name = Message::value(kKinds[kind] + std::to_string(entity.of_shape[1] + 1));
    if (entity.dimension == entity.of_shape[0]) {
        return name;
    }
    return {entity.dimension == 1 ? phrases::kCrease : phrases::kCreaseEnd, {{"name", std::move(name)}}};
}

const char* name_of(ExemptCause cause) {
    return phrase_of(cause).name;
}

bool is_forced(ExemptCause cause) {
    return phrase_of(cause).forced;
}

Message message_of(const ExemptReason& reason) {
    Message message{phrase_of(reason.cause).text};
    if (reason.angle >= 0.0) {
        char number[32];
        std::snprintf(number, sizeof number, "%.2f", reason.angle);
        message.places.push_back({"number", number});
    }
    if (is_there(reason.joined[0])) {
        message.places.push_back({"name", name_of(reason.joined[0])});
        message.places.push_back({"name2", name_of(reason.joined[1])});
        message.places.push_back({"length", in_mm(reason.apart, 3)});
    }
    if (is_there(reason.vertex)) {
        message.places.push_back({"vertex", name_of(reason.vertex)});
    }
    if (is_there(reason.edges[1])) {
        message.places.push_back({"edge", name_of(reason.edges[0])});
        message.places.push_back({"edge2", name_of(reason.edges[1])});
    } else if (is_there(reason.edges[0])) {
        message = {phrases::kOnEdge, {{"phrase", std::move(message)}, {"edge", name_of(reason.edges[0])}}};
    }
    if (is_there(reason.face)) {
        message = {phrases::kOnFace, {{"phrase", std::move(message)}, {"face", name_of(reason.face)}}};
    }
    return message;
}

}  // namespace mq::mesh
