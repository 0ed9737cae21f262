# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of a report as plain values for JSON."""

import math

# What reports have for Python alone.
_NOT_WRITTEN = {"exempt_reasons", "spanning", "max_chord_triangle", "max_chord_point", "detail", "sewn", "imprinted", "reused_faces",
                "holes_filled"}
WRAP_FIELDS = ("distance_to_input", "distance_from_input", "gap_triangles", "gap_area")  # of the mesh itself


def report_fields(report):
    """A report as plain values for JSON."""
    if hasattr(report, "to_dict"):
        return plain(report.to_dict())
    names = [name for cls in reversed(type(report).__mro__) for name, value in vars(cls).items() if isinstance(value, property)]
    fields = {name: getattr(report, name) for name in names if name not in _NOT_WRITTEN}
    if fields.get("box"):
        fields["box"] = [corner.tolist() for corner in report.box]
    if "size_ratio_point" in fields:
        fields["size_ratio_point"] = fields["size_ratio_point"].tolist()
    if "straight" in fields:
        fields["straight"] = report_fields(report.straight)
    return plain(fields)


def plain(fields):
    """The fields, with null for numbers that JSON has no word for."""
    return {name: None if isinstance(value, float) and not math.isfinite(value) else value
            for name, value in fields.items()}
