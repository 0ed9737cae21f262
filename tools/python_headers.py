# SPDX-License-Identifier: LGPL-2.1-or-later
"""Headers of a Python that this machine need not have, from the Debian release that has it, for tools/wheel.

They lie in ~/.cache/meshquality/python-VERSION. A module is compiled with them alone; no library of Python is linked.
"""

import shutil
import subprocess
import tempfile
from pathlib import Path

import own_opencascade

RELEASES = {"3.11": "bookworm", "3.13": "trixie", "3.14": "forky"}


def provide(version):
    """The folder with the headers of a version such as "3.13", unpacked now unless they were before."""
    home = own_opencascade.cache() / f"python-{version}"
    if not home.exists():
        home.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=f"python-{version}-", dir=home.parent) as name:
            work = Path(name)
            subprocess.run([*own_opencascade.apt(work, "deb", RELEASES[version]), "download", f"libpython{version}-dev"], check=True,
                           cwd=work)
            package, = work.glob("*.deb")
            subprocess.run(["dpkg-deb", "--extract", package, work / "unpacked"], check=True)
            headers = work / "unpacked" / "usr" / "include" / f"python{version}"
            # The one beside the others only names the one for each kind of processor.
            configuration, = headers.parent.glob(f"*/python{version}/pyconfig.h")
            shutil.copy(configuration, headers)
            headers.rename(home)
    return home
