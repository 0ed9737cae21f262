// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mq::boolean {

/// The four operations on two solids.
enum class Operation { Union, Intersection, Difference, SymmetricDifference };

/// The name in the public API: "union", "intersection", "difference", "symmetric_difference".
const char* name(Operation operation);

/// The operation of that name.
/// @throws InvalidInput naming the operations there are.
Operation operation_from(const std::string& name);

/// Whether a point of space belongs to the result, given whether it lies in the operands.
bool in_result(Operation operation, bool in_a, bool in_b);

/// How the material of two solids is joined where their surfaces run along each other.
enum class Pairing { Union, Intersection, FirstLessSecond, SecondLessFirst, None };

/// Solids joined by operations: a tree whose leaves are operands (constructive solid geometry; Requicha 1980). One
/// arrangement of all operands tells of each of its cells whether it belongs to the result, so that a sequence of
/// operations is rounded once, not after each.
class Expression {
  public:
    /// The operation applied from the first operand on.
    static Expression chain(Operation operation, int operands);
    /// @param postfix  operand k as k, an operation as -1 - its number, after the two that it joins; operands may occur
    ///     several times
    /// @throws InvalidInput unless this is one expression, with each of the operands
    static Expression from(const std::vector<std::int32_t>& postfix, int operands);

    std::size_t operands() const { return leaf_.size(); }
    /// The operation, if the expression is a chain of it.
    std::optional<Operation> chained() const { return chained_; }
    /// Whether a point of space belongs to the result.
    /// @param winding  winding number of each operand at the point: it is inside of operands with more than 0
    bool contains(const std::int32_t* winding) const;
    /// Evaluates the expression with any kind of values: leaf(operand), join(operation, first, second).
    template <typename Value, typename Leaf, typename Join>
    Value fold(const Leaf& leaf, const Join& join) const {
        std::vector<Value> stack;
        for (const Node& node : nodes_) {
            if (node.operand >= 0) {
                stack.push_back(leaf(static_cast<int>(node.operand)));
            } else {
                const Value second = stack.back();
                stack.pop_back();
                stack.back() = join(node.operation, stack.back(), second);
            }
        }
        return stack.back();
    }
    /// How two operands are joined; None for a symmetric difference, and if one of them occurs several times.
    Pairing pairing(int first, int second) const;

  private:
    friend class Membership;
    struct Node {
        std::int32_t operand = -1;  ///< -1: an operation
        Operation operation = Operation::Union;
        int parent = -1;
        bool complemented = false;  ///< the second solid of a difference
    };
    void add_operand(int operand);
    void add_operation(Operation operation);

    std::vector<Node> nodes_;  ///< in postfix order
    std::vector<int> open_;    ///< nodes without a parent
    std::vector<int> leaf_;    ///< by operand: its node; -1: it has several
    std::optional<Operation> chained_;
};

/// Whether a point that moves through space belongs to the result: it starts outside of all operands, and each border
/// that it passes costs no more than the operations whose result changes.
class Membership {
  public:
    /// @param expression must outlive this object
    explicit Membership(const Expression& expression);

    void set(std::size_t operand, bool inside);
    bool inside() const { return holds_.back() != 0; }

  private:
    const Expression& expression_;
    std::vector<std::vector<int>> leaves_;   ///< nodes of each operand
    std::vector<std::array<int, 2>> below_;  ///< by operation: the two values that it joins
    std::vector<char> holds_;                ///< by node
};

}  // namespace mq::boolean
