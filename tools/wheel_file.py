# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stands in the wheel meshquality-core besides its binary, and the file itself: the same bytes for the same content."""

import base64
import calendar
import csv
import hashlib
import io
import json
import os
import re
import subprocess
import time
import uuid
import xml.etree.ElementTree as ElementTree
import zipfile
from collections import namedtuple
from pathlib import Path

import own_opencascade

ROOT = Path(__file__).resolve().parent.parent
SPACE = "{https://wiki.freecad.org/Package_Metadata}"
NAME, PACKAGE = "meshquality-core", "meshquality_core"
OWN_LICENCE = "LGPL-2.1-or-later"

# What of others is in the binary: the id of SPDX, what its package is elsewhere, and how the binary holds it.
Part = namedtuple("Part", "name version licence purl relationship files")


def debian(package):
    """The version of an installed package of Debian."""
    return subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], check=True, capture_output=True, text=True).stdout


def parts(opencascade, pybind11):
    """What of others is in the binary: the folders of the OpenCASCADE that own_opencascade has installed, and of what pybind11 says of itself."""
    version = pybind11.name.removesuffix(".dist-info").partition("-")[2]
    eigen, robin_map = debian("libeigen3-dev"), debian("robin-map-dev")
    kept = opencascade / "licences"
    texts = {path.name: path.read_text(encoding="utf-8") for path in kept.glob("opencascade-*")}
    return [
        Part("opencascade", own_opencascade.PACKAGE_VERSION, "LGPL-2.1-only WITH OCCT-exception-1.0",
             f"pkg:deb/debian/opencascade@{own_opencascade.PACKAGE_VERSION}?arch=source", "STATIC_LINK", texts),
        Part("delabella", own_opencascade.VERSION, "MIT", "pkg:github/msokalski/delabella", "CONTAINS",
             {"delabella.txt": leading_comment(kept / "delabella.cpp")}),
        Part("pybind11", version, "BSD-3-Clause", f"pkg:pypi/pybind11@{version}", "CONTAINS",
             {"pybind11.txt": (pybind11 / "licenses" / "LICENSE").read_text(encoding="utf-8")}),
        Part("eigen", eigen, "MPL-2.0", f"pkg:deb/debian/eigen3@{eigen}?arch=source", "CONTAINS",
             {"eigen.txt": Path("/usr/share/common-licenses/MPL-2.0").read_text(encoding="utf-8")}),
        Part("robin-map", robin_map, "MIT", f"pkg:deb/debian/robin-map@{robin_map}?arch=source", "CONTAINS",
             {"robin-map.txt": leading_comment(Path("/usr/include/tsl/robin_map.h"))})]


def about():
    """The element <package> of package.xml."""
    return ElementTree.parse(ROOT / "package.xml").getroot()


def of_package(name):
    """The text of an entry of package.xml."""
    return about().find(SPACE + name).text


def epoch():
    """Seconds since 1970 that stand for the time of the build: SOURCE_DATE_EPOCH, or the date in package.xml."""
    given = os.environ.get("SOURCE_DATE_EPOCH")
    return int(given) if given else calendar.timegm(time.strptime(of_package("date"), "%Y-%m-%d"))


def expression(parts):
    """The licence of the whole, as SPDX writes it."""
    terms = [OWN_LICENCE, *(part.licence for part in parts)]
    return " AND ".join(dict.fromkeys(terms))


def metadata(python, platform, parts):
    """The file METADATA, by which pip knows the wheel; python is (major, minor), platform a tag of its."""
    version = ".".join(str(number) for number in python)
    system = "Microsoft :: Windows" if platform.startswith("win") else "POSIX :: Linux"
    lines = ["Metadata-Version: 2.4", f"Name: {NAME}", f"Version: {of_package('version')}",
             "Summary: The C++ core of MeshQuality, a workbench of FreeCAD for meshes of guaranteed quality",
             f"License-Expression: {expression(parts)}",
             *(f"License-File: {name}" for name in sorted(licences(parts))),
             f"Requires-Python: =={version}.*", f"Classifier: Operating System :: {system}",
             f"Classifier: Programming Language :: Python :: {version}", "Description-Content-Type: text/markdown", ""]
    return "\n".join([*lines, (ROOT / "packaging" / "wheel.md").read_text(encoding="utf-8")])


def licences(parts):
    """{name of a file: its text} of all licences of what is inside."""
    found = {"LICENSE": (ROOT / "LICENSE").read_text(encoding="utf-8")}
    for part in parts:
        found.update(part.files)
    return found


def leading_comment(path):
    """The comment with which a source of C++ begins, in which small libraries have their licence."""
    text = path.read_text(encoding="utf-8")
    return re.match(r"\s*/\*.*?\*/", text, re.DOTALL)[0].strip() + "\n"


def spdx(parts, tag):
    """The list of what is inside, in SPDX 2.3 (JSON)."""
    def package(name, version, licence, purl):
        return {"SPDXID": f"SPDXRef-{name}", "name": name, "versionInfo": version, "downloadLocation": "NOASSERTION",
                "filesAnalyzed": False, "licenseConcluded": licence, "licenseDeclared": licence, "copyrightText": "NOASSERTION",
                "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": purl}]}

    version = of_package("version")
    whole = package(NAME, version, expression(parts), f"pkg:pypi/{NAME}@{version}")
    packages = [whole, *(package(part.name, part.version, part.licence, part.purl) for part in parts)]
    relations = [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": whole["SPDXID"]},
                 *({"spdxElementId": whole["SPDXID"], "relationshipType": part.relationship,
                    "relatedSpdxElement": f"SPDXRef-{part.name}"} for part in parts)]
    document = {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"{NAME}-{version}-{tag}",
                "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(epoch())), "creators": ["Tool: tools/wheel"]},
                "packages": packages, "relationships": relations}
    document["documentNamespace"] = uuid.uuid5(uuid.NAMESPACE_OID, json.dumps(document)).urn
    return json.dumps(document, indent=1) + "\n"


def contents(binary, python, platform, parts):
    """{path in the wheel: bytes}, without RECORD. The binary is the path of _core."""
    version = of_package("version")
    info = f"{PACKAGE}-{version}.dist-info"
    tag = "cp{0}{1}-cp{0}{1}-{2}".format(*python, platform)
    texts = {
        f"{PACKAGE}/__init__.py": f'"""The binary of MeshQuality, which the package MeshQuality loads."""\n\n__version__ = "{version}"\n',
        f"{info}/METADATA": metadata(python, platform, parts),
        f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: tools/wheel\nRoot-Is-Purelib: false\nTag: {tag}\n",
        f"{info}/sboms/{NAME}.spdx.json": spdx(parts, tag),
        **{f"{info}/licenses/{name}": text for name, text in licences(parts).items()}}
    return {f"{PACKAGE}/{binary.name}": binary.read_bytes(), **{path: text.encode() for path, text in texts.items()}}


def record(files, path):
    """The file RECORD: what all others hold."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    for name in sorted(files):
        digest = base64.urlsafe_b64encode(hashlib.sha256(files[name]).digest()).rstrip(b"=").decode()
        writer.writerow([name, f"sha256={digest}", len(files[name])])
    writer.writerow([path, "", ""])
    return stream.getvalue().encode()


def write(folder, files):
    """Writes the wheel of these contents and returns its path."""
    info = next(name for name in files if name.endswith("/WHEEL")).rpartition("/")[0]
    tag = re.search(r"^Tag: (.*)$", files[f"{info}/WHEEL"].decode(), re.MULTILINE)[1]
    path = folder / f"{info.removesuffix('.dist-info')}-{tag}.whl"
    whole = {**files, f"{info}/RECORD": record(files, f"{info}/RECORD")}
    archive(path, whole, last=info)
    return path


def archive(path, files, last=""):
    """Writes a zip of {path in it: bytes}, those below the folder `last` at its end."""
    moment = time.gmtime(max(epoch(), 315532800))[:6]  # a zip knows nothing before 1980
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as written:
        for name in sorted(files, key=lambda name: (bool(last) and name.startswith(last), name)):
            entry = zipfile.ZipInfo(name, moment)
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, (0o100755 if name.endswith((".so", "bin/meshquality")) else 0o100644) << 16
            entry.create_system = 3
            written.writestr(entry, files[name])
