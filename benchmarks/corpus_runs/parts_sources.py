#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The public CAD parts of benchmarks/corpus_runs/parts_sources.tsv: brings them, or chooses others.

    benchmarks/corpus_runs/parts_sources.py bring CLONES PARTS
    benchmarks/corpus_runs/parts_sources.py choose CLONES --known ../shared/data/cad

CLONES holds clones of the repositories, a repository OWNER/NAME as OWNER+NAME or as OWNER/NAME,
bare or with a work tree. `bring` writes every part of the list whose repository is there to
PARTS/DIGEST.SUFFIX and says which are missing. `choose` writes the list anew: from each repository
files of different families first, a family being the names that differ in their numbers only.
The share of a part follows from its digest, so that it never changes.
"""

import argparse
import csv
import hashlib
import io
import os
import re
import subprocess
import sys
import zipfile
from collections import Counter, defaultdict
from pathlib import Path

LIST = Path(__file__).resolve().parent / "parts_sources.tsv"
COLUMNS = ("digest", "repository", "commit", "path", "bytes", "share")
SUFFIXES = {".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".fcstd"}
SMALLEST, LARGEST = 2_000, 8_000_000
MOST_OF_REPOSITORY, MOST_OF_FAMILY, MOST_DOCUMENTS = 60, 40, 150
BINARY_SHAPE = b"Open CASCADE Topology V"
IGES_SURFACES = {b"108", b"114", b"118", b"120", b"122", b"128", b"140", b"143", b"144", b"510"}


def share_of(digest):
    """Parts to develop on and parts to measure on."""
    return "develop" if digest[0] < "8" else "measure"


def read_list(path=LIST):
    with open(path, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream, delimiter="\t", quoting=csv.QUOTE_NONE))


class Clone:
    """The files of a repository, read without a work tree."""

    def __init__(self, folder):
        self.folder = folder
        self.environment = {**os.environ, "GIT_NO_LAZY_FETCH": "1"}

    def git(self, *command, given=None):
        return subprocess.run(["git", f"--git-dir={self.folder}", *command], input=given,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              env=self.environment).stdout

    def head(self):
        return self.git("rev-parse", "HEAD").decode().strip()

    def files(self, commit):
        """Path, name of the object and bytes of every CAD file of a fitting size."""
        found = []
        for line in self.git("ls-tree", "-r", "-z", commit).split(b"\0")[:-1]:
            kind, path = line.split(b"\t", 1)
            try:
                name = path.decode()
            except UnicodeDecodeError:
                continue
            if Path(name).suffix.lower() in SUFFIXES and not re.search(r"[\t\r\n]", name):
                found.append((name, kind.split()[2]))
        sizes = self.git("cat-file", "--batch-check=%(objecttype) %(objectsize)",
                         given=b"".join(blob + b"\n" for _, blob in found)).splitlines()
        return [(name, blob.decode(), int(size.split()[1]))
                for (name, blob), size in zip(found, sizes)
                if size.startswith(b"blob") and SMALLEST <= int(size.split()[1]) <= LARGEST]

    def read(self, name):
        """The bytes of an object (COMMIT:PATH, or its own name); empty where it is missing."""
        return self.git("cat-file", "blob", name)


def clones(folder):
    """The clones below a folder by their repositories' names."""
    found = {}
    for pattern in ("*", "*/*", "*/*/*"):
        for inner in sorted(folder.glob(pattern)):
            git = inner / ".git" if (inner / ".git").is_dir() else inner
            if not (git / "HEAD").is_file() or not (git / "objects").is_dir():
                continue
            parts = list(inner.relative_to(folder).parts)
            owner, plus, name = parts[0].partition("+")
            if not plus and len(parts) > 1:
                name = parts[1].removesuffix(".git")
            if name and inner.name != ".git":
                found.setdefault(f"{owner}/{name}", Clone(git))
    return found


def holds_faces(name, data):
    """Whether a file holds surfaces: lists of curves, points or meshes are no parts."""
    suffix = Path(name).suffix.lower()
    if suffix in (".step", ".stp"):
        return b"ISO-10303-21" in data[:2000] and (b"_FACE" in data or b"B_SPLINE_SURFACE" in data)
    if suffix in (".iges", ".igs"):
        return any(line[72:73] == b"D" and line[:8].strip() in IGES_SURFACES
                   for line in data.splitlines())
    if suffix in (".brep", ".brp"):
        return b"\nFa\n" in data.replace(b"\r", b"") or data.startswith(BINARY_SHAPE)
    return document_holds_faces(data)


def document_holds_faces(data):
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            return any(holds_faces(name, archive.read(name)) for name in archive.namelist()
                       if name.endswith((".brp", ".brep")))
    except zipfile.BadZipFile:
        return False


def family(repository, name):
    """What the names of near-identical files have in common."""
    return re.sub(r"[^a-z]+", "", Path(name).stem.lower()) or repository


def in_turn(repository, files):
    """Files in an order that takes one of every family, then a second of every family, ..."""
    families = defaultdict(list)
    for entry in sorted(files, key=lambda f: hashlib.sha256(f[0].encode()).hexdigest()):
        families[family(repository, entry[0])].append(entry)
    numbered = [(k, entry) for entries in families.values() for k, entry in enumerate(entries)]
    return [entry for _, entry in sorted(numbered, key=lambda n: n[0])]


def choose(folder, known):
    """The list of parts of all clones, without the digests given."""
    known = set(known)
    families, documents, rows = Counter(), 0, []
    for repository, clone in sorted(clones(folder).items()):
        commit, of_repository = clone.head(), 0
        for name, blob, size in in_turn(repository, clone.files(commit)):
            document = name.lower().endswith(".fcstd")
            if of_repository == MOST_OF_REPOSITORY:
                break
            kin = family(repository, name)
            if families[kin] == MOST_OF_FAMILY or (document and documents == MOST_DOCUMENTS):
                continue
            data = clone.read(blob)
            digest = hashlib.sha256(data).hexdigest()
            if digest in known or len(data) != size or not holds_faces(name, data):
                continue
            known.add(digest)
            families[kin] += 1
            of_repository += 1
            documents += document
            rows.append((digest, repository, commit, name, size, share_of(digest)))
        if of_repository:
            print(f"{of_repository:>4} {repository}", flush=True)
    return sorted(rows)


def write_list(rows, path=LIST):
    with open(path, "w", encoding="utf-8", newline="") as stream:
        stream.write("\t".join(COLUMNS) + "\n")
        stream.writelines("\t".join(map(str, row)) + "\n" for row in rows)


def bring(folder, parts):
    """Writes the parts of the list; returns those whose bytes are not to be had, by repository."""
    found, missing = clones(folder), Counter()
    parts.mkdir(parents=True, exist_ok=True)
    for row in read_list():
        path = parts / (row["digest"] + Path(row["path"]).suffix.lower())
        if path.exists():
            continue
        clone = found.get(row["repository"])
        data = clone.read(f"{row['commit']}:{row['path']}") if clone else b""
        if hashlib.sha256(data).hexdigest() == row["digest"]:
            path.write_bytes(data)
        else:
            missing[row["repository"]] += 1
    return missing


def digests(folder):
    return [hashlib.sha256(path.read_bytes()).hexdigest()
            for path in folder.rglob("*") if path.is_file()]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("bring", "choose"):
        commands.add_parser(name).add_argument("clones", type=Path)
    commands.choices["bring"].add_argument("parts", type=Path)
    commands.choices["choose"].add_argument("--known", type=Path, help="folder of parts to leave")
    arguments = parser.parse_args()
    if arguments.command == "choose":
        rows = choose(arguments.clones, digests(arguments.known) if arguments.known else [])
        write_list(rows)
        print(f"{len(rows)} parts")
        return 0
    missing = bring(arguments.clones, arguments.parts)
    for repository, count in sorted(missing.items()):
        print(f"{count} parts missing of {repository}")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
