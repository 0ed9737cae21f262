// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>

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

/// The same for any number of operands: those after the first are joined to it one after the other.
/// @param winding  how often each operand winds around the point: it lies in those with more than 0
bool in_result(Operation operation, const std::int32_t* winding, int operands);

}  // namespace mq::boolean
