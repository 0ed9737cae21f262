# SPDX-License-Identifier: LGPL-2.1-or-later
"""The addon as FreeCAD's index has it. Scripts and documents know its package as MeshQuality, which this finds."""

import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "Mod"))
