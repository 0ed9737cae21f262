# SPDX-License-Identifier: LGPL-2.1-or-later
"""What OpenFOAM's checkMesh says about a VolumeMesh (Debian: openfoam)."""

import os
import subprocess
import tempfile

ENVIRONMENT = {**os.environ, "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}


def checked(mesh, *more):
    """The faults that checkMesh finds; none: it says "Mesh OK"."""
    with tempfile.TemporaryDirectory() as folder:
        mesh.write(os.path.join(folder, "case"))
        said = subprocess.run(["checkMesh", *more], cwd=os.path.join(folder, "case"), env=ENVIRONMENT, capture_output=True, text=True).stdout
    return [] if "Mesh OK." in said else [line.strip() for line in said.splitlines() if "***" in line] or ["no verdict"]
