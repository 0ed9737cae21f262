// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/input/operation.h"

#include <algorithm>
#include <iterator>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

namespace mq::boolean {

namespace {

/// All operations, for lookups by name.
constexpr Operation kOperations[] = {Operation::Union, Operation::Intersection, Operation::Difference,
                                     Operation::SymmetricDifference};

}  // namespace

const char* name(Operation operation) {
    switch (operation) {
        case Operation::Union:
            return "union";
        case Operation::Intersection:
            return "intersection";
        case Operation::Difference:
            return "difference";
        case Operation::SymmetricDifference:
            break;
    }
    return "symmetric_difference";
}

Operation operation_from(const std::string& text) {
    std::string known;
    for (const Operation operation : kOperations) {
        if (text == name(operation)) {
            return operation;
        }
        known += (known.empty() ? "'" : ", '") + std::string(name(operation)) + "'";
    }
    throw InvalidInput(
        phrases::kNotAllowed,
        {{"option", "operation"}, {"value", "'" + text + "'"}, {"range", Message(phrases::kOneOf, {{"list", known}})}});
}

bool in_result(Operation operation, bool in_a, bool in_b) {
    switch (operation) {
        case Operation::Union:
            return in_a || in_b;
        case Operation::Intersection:
            return in_a && in_b;
        case Operation::Difference:
            return in_a && !in_b;
        case Operation::SymmetricDifference:
            break;
    }
    return in_a != in_b;
}

Expression Expression::chain(Operation operation, int operands) {
    Expression result;
    result.leaf_.assign(static_cast<std::size_t>(operands), -1);
    for (int k = 0; k < operands; ++k) {
        result.add_operand(k);
        if (k > 0) {
            result.add_operation(operation);
        }
    }
    result.chained_ = operation;
    return result;
}

Expression Expression::from(const std::vector<std::int32_t>& postfix, int operands) {
    Expression result;
    result.leaf_.assign(static_cast<std::size_t>(operands), -1);
    std::vector<char> occurs(static_cast<std::size_t>(operands), 0);
    for (const std::int32_t token : postfix) {
        if (token >= operands || token < -static_cast<std::int32_t>(std::size(kOperations)) ||
            (token < 0 && result.open_.size() < 2)) {
            throw InvalidInput(phrases::kExpressionToken, {{"value", std::to_string(token)}});
        }
        if (token < 0) {
            result.add_operation(kOperations[-1 - token]);
        } else {
            char& here = occurs[static_cast<std::size_t>(token)];
            result.add_operand(token);
            result.leaf_[static_cast<std::size_t>(token)] =
                here != 0 ? -1 : result.leaf_[static_cast<std::size_t>(token)];
            here = 1;
        }
    }
    if (result.open_.size() != 1 || std::find(occurs.begin(), occurs.end(), 0) != occurs.end()) {
        throw InvalidInput(phrases::kExpressionNotJoined, {{"count", operands}});
    }
    return result;
}

void Expression::add_operand(int operand) {
    const auto node = static_cast<int>(nodes_.size());
    nodes_.push_back({operand});
    leaf_[static_cast<std::size_t>(operand)] = node;
    open_.push_back(node);
}

void Expression::add_operation(Operation operation) {
    const auto node = static_cast<int>(nodes_.size());
    for (int i = 0; i < 2; ++i) {
        Node& below = nodes_[static_cast<std::size_t>(open_.back())];
        below.parent = node;
        below.complemented = i == 0 && operation == Operation::Difference;
        open_.pop_back();
    }
    nodes_.push_back({-1, operation});
    open_.push_back(node);
}

bool Expression::contains(const std::int32_t* winding) const {
    return fold<char>([&](int operand) { return winding[operand] > 0 ? 1 : 0; },
                      [](Operation operation, char first, char second) {
                          return in_result(operation, first != 0, second != 0) ? 1 : 0;
                      }) != 0;
}

Membership::Membership(const Expression& expression)
    : expression_(expression),
      leaves_(expression.operands()),
      below_(expression.nodes_.size()),
      holds_(expression.nodes_.size(), 0) {
    std::vector<int> open;
    for (std::size_t n = 0; n < below_.size(); ++n) {
        const Expression::Node& node = expression.nodes_[n];
        if (node.operand >= 0) {
            leaves_[static_cast<std::size_t>(node.operand)].push_back(static_cast<int>(n));
        } else {
            below_[n] = {open[open.size() - 2], open.back()};
            open.resize(open.size() - 2);
        }
        open.push_back(static_cast<int>(n));
    }
}

void Membership::set(std::size_t operand, bool inside) {
    for (int n : leaves_[operand]) {
        char now = inside ? 1 : 0;
        while (holds_[static_cast<std::size_t>(n)] != now) {
            holds_[static_cast<std::size_t>(n)] = now;
            const int parent = expression_.nodes_[static_cast<std::size_t>(n)].parent;
            if (parent < 0) {
                break;
            }
            const auto [first, second] = below_[static_cast<std::size_t>(parent)];
            n = parent;
            now = in_result(expression_.nodes_[static_cast<std::size_t>(n)].operation,
                            holds_[static_cast<std::size_t>(first)] != 0, holds_[static_cast<std::size_t>(second)] != 0)
                      ? 1
                      : 0;
        }
    }
}

Pairing Expression::pairing(int first, int second) const {
    const int from[2] = {leaf_[static_cast<std::size_t>(first)], leaf_[static_cast<std::size_t>(second)]};
    if (from[0] < 0 || from[1] < 0) {
        return Pairing::None;
    }
    // Parents have higher indices than their children: the lower of the two nodes goes up, until both meet.
    int at[2] = {from[0], from[1]};
    bool complemented[2] = {false, false};
    while (at[0] != at[1]) {
        const int i = at[0] < at[1] ? 0 : 1;
        const Node& node = nodes_[static_cast<std::size_t>(at[i])];
        complemented[i] = complemented[i] != node.complemented;
        at[i] = node.parent;
        if (nodes_[static_cast<std::size_t>(at[i])].operation == Operation::SymmetricDifference) {
            return Pairing::None;
        }
    }
    const Operation operation = nodes_[static_cast<std::size_t>(at[0])].operation;
    // By De Morgan's laws a union of complements has the surface of an intersection, and the other way around.
    if (complemented[0] == complemented[1]) {
        return (operation == Operation::Union) != complemented[0] ? Pairing::Union : Pairing::Intersection;
    }
    return (operation == Operation::Union) != complemented[0] ? Pairing::SecondLessFirst : Pairing::FirstLessSecond;
}

}  // namespace mq::boolean
