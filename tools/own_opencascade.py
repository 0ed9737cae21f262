# SPDX-License-Identifier: LGPL-2.1-or-later
"""OpenCASCADE from Debian's source package, static and with hidden symbols, for tools/wheel.

It is built once, into ~/.cache/meshquality/occt-VERSION-HASH: the hash is of all that makes its bytes.
"""

import hashlib
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

# Debian 12's, so that meshes can be compared with those of Debian 12's FreeCAD byte by byte.
RELEASE = "bookworm"
PACKAGE_VERSION = "7.6.3+dfsg1-7"
VERSION = PACKAGE_VERSION.partition("+")[0]
KEYS = "/usr/share/keyrings/debian-archive-keyring.gpg"
# They bring the others that the core links.
TOOLKITS = "TKBO", "TKMesh"
MODULES = ("FoundationClasses", "ModelingData", "ModelingAlgorithms", "Visualization", "ApplicationFramework",
           "DataExchange", "Draw")
# -O2 and exceptions as Debian builds it; nothing is contracted, as on x86-64, where there is nothing to contract to.
FLAGS = ("-O2 -DNDEBUG -ffp-contract=off -fvisibility=hidden -fvisibility-inlines-hidden -ffunction-sections "
         "-fdata-sections")
# Without TBB, OpenCASCADE has threads of its own; the core calls it serially in any case.
SETTINGS = {"CMAKE_BUILD_TYPE": "Release", "CMAKE_CXX_FLAGS_RELEASE": FLAGS, "CMAKE_C_FLAGS_RELEASE": FLAGS,
            "BUILD_LIBRARY_TYPE": "Static", "BUILD_RELEASE_DISABLE_EXCEPTIONS": "OFF", "BUILD_DOC_Overview": "OFF",
            "USE_TBB": "OFF", "USE_TK": "OFF", "USE_FREETYPE": "OFF", "BUILD_ADDITIONAL_TOOLKITS": " ".join(TOOLKITS),
            **{f"BUILD_MODULE_{name}": "OFF" for name in MODULES}}
LICENCES = {"LICENSE_LGPL_21.txt": "opencascade-LGPL-2.1.txt", "OCCT_LGPL_EXCEPTION.txt": "opencascade-exception.txt",
            "debian/copyright": "opencascade-copyright.txt", "src/BRepMesh/delabella.cpp": "delabella.cpp"}


def cache():
    """The folder of what is built once for all clones."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "meshquality"


def compiler():
    return subprocess.run(["c++", "--version"], check=True, capture_output=True, text=True).stdout.splitlines()[0]


def folder():
    """Where this OpenCASCADE, by this compiler, lies once it is built."""
    makes = repr((PACKAGE_VERSION, sorted(SETTINGS.items()), compiler()))
    return cache() / f"occt-{VERSION}-{hashlib.sha256(makes.encode()).hexdigest()[:12]}"


def source_line(kind, release):
    """The line of apt for packages (deb) or sources (deb-src) of a release, at the mirror of this machine's apt."""
    told = subprocess.run(["apt-get", "indextargets", "--format", "$(REPO_URI)", "Created-By: Packages", "Origin: Debian",
                           "Label: Debian"], check=True, capture_output=True, text=True).stdout.split()
    return f"{kind} [signed-by={KEYS}] {told[0] if told else 'http://deb.debian.org/debian'} {release} main\n"


def apt(into, kind, release):
    """The command apt-get, which knows packages (deb) or sources (deb-src) of that release alone and keeps its files in the
    folder. It checks them by the signed index of the release. Nothing of the machine's apt is changed.
    """
    for name in ("lists/partial", "archives/partial"):
        (into / name).mkdir(parents=True)
    (into / "sources.list").write_text(source_line(kind, release), encoding="utf-8")
    options = {"Dir::Etc::SourceList": into / "sources.list", "Dir::Etc::SourceParts": "/dev/null",
               "Dir::State::Lists": into / "lists", "Dir::Cache": into, "Dir::Cache::Archives": into / "archives",
               "APT::Sandbox::User": "root"}
    command = ["apt-get", "-q", *(f"-o{name}={value}" for name, value in options.items())]
    subprocess.run([*command, "update"], check=True, cwd=into)
    return command


def download(into, package="opencascade", version=PACKAGE_VERSION):
    """Unpacks a source package, with Debian's patches, into `into`/source. apt checks the .dsc, and dpkg-source the other
    files by the .dsc.
    """
    subprocess.run([*apt(into, "deb-src", RELEASE), "source", "--download-only", f"{package}={version}"], check=True, cwd=into)
    subprocess.run(["dpkg-source", "--require-strong-checksums", "-x", f"{package}_{version.split(':')[-1]}.dsc", "source"],
                   check=True, cwd=into)


def install(source, build, into, changes=None):
    """Builds it there and installs headers, libraries, CMake's files and licences. `changes` of SETTINGS are for other systems."""
    prefix_map = f"-ffile-prefix-map={source}=opencascade -ffile-prefix-map={build}=opencascade"
    settings = {**SETTINGS, "CMAKE_CXX_FLAGS": prefix_map, "CMAKE_C_FLAGS": prefix_map, "CMAKE_INSTALL_PREFIX": into,
                **(changes or {})}
    subprocess.run(["cmake", "-S", source, "-B", build, "-G", "Ninja", "-Wno-dev",
                    *(f"-D{name}={value}" for name, value in settings.items())], check=True)
    subprocess.run(["cmake", "--build", build], check=True)
    subprocess.run(["cmake", "--install", build], check=True, stdout=subprocess.DEVNULL)
    # Definitions of its own sources, which the core would take over; the core is compiled as for any OpenCASCADE.
    next(into.rglob("OpenCASCADECompileDefinitionsAndFlags-release.cmake")).unlink()
    (into / "licences").mkdir()
    for name, kept in LICENCES.items():
        shutil.copyfile(source / name, into / "licences" / kept)


def provide():
    """The folder with it, built now unless it was before."""
    home = folder()
    if (home / "complete").exists():
        return home
    shutil.rmtree(home, ignore_errors=True)
    home.mkdir(parents=True)
    with tempfile.TemporaryDirectory(prefix="occt-", dir=cache()) as name:
        work = Path(name)
        download(work)
        install(work / "source", work / "build", home)
    (home / "complete").touch()
    return home
