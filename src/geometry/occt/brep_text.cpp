// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/brep_text.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <TopTools_FormatVersion.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <array>
#include <charconv>
#include <climits>
#include <cmath>
#include <functional>
#include <ios>
#include <sstream>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "geometry/occt/evaluation/failure_text.h"

namespace mq::geometry {

std::shared_ptr<const TopoDS_Shape> read_brep_text(const std::string& text) {
    auto shape = std::make_shared<TopoDS_Shape>();
    std::istringstream stream(text);
    try {
        BRepTools::Read(*shape, stream, BRep_Builder());
    } catch (const Standard_Failure& failure) {
        throw InvalidInput(phrases::kBrepNotRead, {{"text", failure_text(failure)}});
    }
    if (shape->IsNull()) {
        throw InvalidInput(phrases::kBrepEmpty);
    }
    return shape;
}

namespace {

/// The BREP text with the digits that a FreeCAD document keeps: a fixed number of decimals, however small a number is.
std::string text_of_document(const TopoDS_Shape& shape) {
    std::ostringstream stream;
    stream.setf(std::ios::fixed, std::ios::floatfield);
    BRepTools::Write(shape, stream, false, false, TopTools_FormatVersion_CURRENT);
    return stream.str();
}

/// Rounds the numbers with a decimal point to 12 decimals, without a sign of zeros: directions are computed anew
/// whenever a shape is read, and differ in their last digits. 12 decimals are the rounding errors of coordinates of
/// some metres.
std::string with_rounded_numbers(const std::string& text) {
    constexpr int kDecimals = 12;
    constexpr std::size_t kLongest = 400;  // a number with a fixed number of decimals: 309 digits before the point
    constexpr double kZero = 0.5e-12;
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \n", i), text.size());
        double value = 0.0;
        const bool is_number = std::find(text.data() + i, text.data() + end, '.') != text.data() + end &&
                               std::from_chars(text.data() + i, text.data() + end, value).ptr == text.data() + end;
        if (is_number) {
            std::array<char, kLongest> digits;
            const double rounded = std::abs(value) < kZero ? 0.0 : value;
            const auto last = std::to_chars(digits.data(), digits.data() + digits.size(), rounded,
                                            std::chars_format::fixed, kDecimals);
            result.append(digits.data(), last.ptr);
        } else {
            result.append(text, i, end - i);
        }
        if (end < text.size()) {
            result += text[end];
        }
        i = end + 1;
    }
    return result;
}

}  // namespace

std::string write_brep_text(const TopoDS_Shape& shape) {
    // The shape is copied, as FreeCAD does for undoing, and read once, as from a document, so that copies and documents
    // give the same text: a copy no longer shares what its faces have in common, and reading drops digits of small
    // numbers and computes directions again.
    BRepBuilderAPI_Copy copy(shape, true, false);
    std::string text = with_rounded_numbers(text_of_document(*read_brep_text(text_of_document(copy.Shape()))));
    // Number of marks, on a line of their own: free, modified, checked, orientable, closed, infinite, convex.
    constexpr std::size_t kMarks = 7;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (end - begin == kMarks && text.find_first_not_of("01", begin) >= end) {
            text[begin + 1] = text[begin + 2] = '0';
        }
        begin = end + 1;
    }
    return text;
}

ShapeIdentity identity_of(const TopoDS_Shape& shape) {
    ShapeIdentity identity;
    identity.tshape = reinterpret_cast<std::size_t>(shape.TShape().get());
#if OCC_VERSION_HEX >= 0x070800
    identity.hash = static_cast<int>(std::hash<TopoDS_Shape>()(shape) & INT_MAX);
#else
    identity.hash = shape.HashCode(INT_MAX);
#endif
    return identity;
}

}  // namespace mq::geometry
