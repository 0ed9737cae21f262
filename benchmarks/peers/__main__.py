# SPDX-License-Identifier: LGPL-2.1-or-later
"""python3 benchmarks/peers: the program peers.py."""

import os
import sys
from pathlib import Path

os.execv(sys.executable, [sys.executable, str(Path(__file__).resolve().parent / "peers.py"), *sys.argv[1:]])
