// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/brep_text.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <TopTools_FormatVersion.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <climits>
#include <functional>
#include <ios>
#include <sstream>

#include "base/error.h"

namespace mq::geometry {

std::shared_ptr<const TopoDS_Shape> read_brep_text(const std::string& text) {
    auto shape = std::make_shared<TopoDS_Shape>();
    std::istringstream stream(text);
    try {
        BRepTools::Read(*shape, stream, BRep_Builder());
    } catch (const Standard_Failure& failure) {
        throw InvalidInput(std::string("the BREP text cannot be read: ") + failure.GetMessageString());
    }
    if (shape->IsNull()) {
        throw InvalidInput("the BREP text holds no shape");
    }
    return shape;
}

namespace {

/// With the digits that a FreeCAD document keeps: a fixed number of decimals, however small a number is.
std::string text_of_document(const TopoDS_Shape& shape) {
    std::ostringstream stream;
    stream.setf(std::ios::fixed, std::ios::floatfield);
    BRepTools::Write(shape, stream, false, false, TopTools_FormatVersion_CURRENT);
    return stream.str();
}

/// Takes the sign of zeros away, which directions computed anew may have or not.
std::string without_signs_of_zeros(const std::string& text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool begins = text[i] == '-' && (i == 0 || text[i - 1] == ' ' || text[i - 1] == '\n');
        const std::size_t end = begins ? text.find_first_not_of("0.", i + 1) : i;
        if (!begins || (end != std::string::npos && text[end] != ' ' && text[end] != '\n')) {
            result += text[i];
        }
    }
    return result;
}

}  // namespace

std::string write_brep_text(const TopoDS_Shape& shape) {
    // Read once: small numbers lose digits, and directions are computed anew.
    std::string text = without_signs_of_zeros(text_of_document(*read_brep_text(text_of_document(shape))));
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
