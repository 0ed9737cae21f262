# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate of a mesh object: what ..verdict finds, under the names that scripts know."""

from ..verdict import (  # noqa: F401 - handed out
    MET,
    NOT_MET,
    Finding,
    faces,
    is_met,
    is_missed,
    must_be_closed,
    place,
    said,
    sentence,
    topology,
)

UNKNOWN = "unknown: the mesh was made by an older version; update it"
