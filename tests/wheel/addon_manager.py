#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a FreeCAD that was never started to a certified mesh: the Addon Manager's way, by clicks in its window.

    python3 tests/wheel/addon_manager.py FOLDER_WITH_WHEELS [--root FOLDER] [--refused | --zip FILE]

FreeCAD runs unchanged on a virtual screen, in a network of its own that has one server: it stands in for the addresses from which
the Addon Manager takes its index and the addon, and pip takes wheels from the folder. --root is a Debian in a folder, as
tools/compat keeps them. With --refused the index does not allow the package of the binary, which is then unpacked by hand. With --zip
nothing is installed by the manager but the file unpacked into the folder Mod.
addon_manager_inside.py clicks; pictures, steps and seconds are in build/addon-manager. The last line is 'N passed, N failed'.
"""

import argparse
import base64
import hashlib
import html
import http.server
import io
import json
import os
import re
import shutil
import ssl
import subprocess
import sys
import tempfile
import threading
import time
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
RESULT = ROOT / "build" / "addon-manager"
REPOSITORY = "https://github.com/example/MeshQuality"  # of a kind whose files the Addon Manager knows to ask for
INDEX = "https://raw.githubusercontent.com/FreeCAD/FreeCAD-addons/master"
CATALOGUE = "https://addons.freecad.org"
CONSTRAINTS = "https://raw.githubusercontent.com/FreeCAD/Addons/refs/heads/main/Data/Python"  # which versions pip may take
HOSTS = ("api.github.com", "github.com", "raw.githubusercontent.com", "freecad.org", "addons.freecad.org", "wiki.freecad.org")
SCREEN, LIMIT = "1200x800x24", 600


def run(*command, **options):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True, **options).stdout


def zipped(files):
    """A zip of {path in it: bytes}."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as written:
        for path, content in files.items():
            written.writestr(path, content)
    return stream.getvalue()


def pages(tree, allowed):
    """{address: what the server answers}: for FreeCAD 0.20 and 1.0 a list of repositories, for 1.1 a catalogue; the addon's files."""
    files = {str(path.relative_to(tree)): path.read_bytes() for path in sorted(tree.rglob("*")) if path.is_file()}
    submodule = f'[submodule "MeshQuality"]\n\tpath = MeshQuality\n\turl = {REPOSITORY}\n\tbranch = main\n'
    metadata = {"package_xml": files["package.xml"].decode(), "requirements_txt": files["requirements.txt"].decode(),
                "icon_data": base64.b64encode(files["freecad/MeshQuality/Resources/icons/MeshQuality.svg"]).decode()}
    entry = {"repository": REPOSITORY, "git_ref": "main", "branch_display_name": "main", "metadata": metadata,
             "last_update_time": "2026-11-30T00:00:00+00:00"}
    found = {"https://api.github.com/zen": b"Anything added dilutes everything else.", f"{INDEX}/addonflags.json": b"{}",
             f"{INDEX}/.gitmodules": submodule.encode(), f"{INDEX}/ALLOWED_PYTHON_PACKAGES.txt": "\n".join(allowed).encode(),
             f"{CATALOGUE}/status": b"up", f"{CATALOGUE}/macro_cache.zip": zipped({"macro_cache.json": b"{}"}),
             f"{CATALOGUE}/addon_catalog_cache.zip": zipped({"addon_catalog_cache.json": json.dumps({"MeshQuality": [entry]}).encode()}),
             # As a host of repositories gives it: the zip has one folder, whose name has the branch.
             f"{REPOSITORY}/archive/main.zip": zipped({"MeshQuality-main/": b"", **{f"MeshQuality-main/{path}": content
                                                                                    for path, content in files.items()}}),
             **{f"{CONSTRAINTS}/3.{minor}/constraints.txt": b"# none\n" for minor in range(11, 15)},
             f"{REPOSITORY}/blob/main/README.md": f"<pre>{html.escape(files['README.md'].decode())}</pre>".encode(),
             **{f"{REPOSITORY}/raw/main/{path}": content for path, content in files.items()}}
    for name in ("macro_cache.zip", "addon_catalog_cache.zip"):
        found[f"{CATALOGUE}/{name}.sha256"] = hashlib.sha256(found[f"{CATALOGUE}/{name}"]).hexdigest().encode()
    return found


def serve(answers, folder, asked):
    """A server for these addresses, with a certificate by the authority of the folder."""
    class Handler(http.server.BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def do_GET(self):  # noqa: N802  the name that the library asks for
            address = f"https://{self.headers['Host']}{self.path}"
            body = answers.get(address)
            asked.append([address, body is not None])
            self.send_response(404 if body is None else 200)
            self.send_header("Content-Length", str(len(body or b"")))
            self.end_headers()
            self.wfile.write(body or b"")

        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 443), Handler)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(folder / "server.pem")
    server.socket = context.wrap_socket(server.socket, server_side=True)
    threading.Thread(target=server.serve_forever, daemon=True).start()


def make_certificates(folder):
    """An authority in folder/certs, as OpenSSL and Qt look it up, and a certificate of the hosts."""
    certificates = folder / "certs"
    certificates.mkdir()
    run("openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=addon manager", "-keyout", folder / "ca.key",
        "-out", certificates / "ca-certificates.crt")
    run("openssl", "req", "-newkey", "rsa:2048", "-nodes", "-subj", "/CN=server", "-keyout", folder / "server.key", "-out", folder / "request")
    (folder / "names").write_text("subjectAltName=" + ",".join(f"DNS:{host}" for host in HOSTS), encoding="ascii")
    run("openssl", "x509", "-req", "-days", "2", "-in", folder / "request", "-CA", certificates / "ca-certificates.crt", "-CAkey",
        folder / "ca.key", "-CAcreateserial", "-extfile", folder / "names", "-out", folder / "server.crt")
    (folder / "server.pem").write_text((folder / "server.key").read_text() + (folder / "server.crt").read_text())
    shutil.copyfile(certificates / "ca-certificates.crt", certificates / "authority.pem")
    run("openssl", "rehash", certificates)


def start_screen(folder):
    """A virtual screen; its name."""
    readable, writable = os.pipe()
    with (folder / "screen.log").open("w") as log:
        subprocess.Popen(["Xvfb", "-displayfd", str(writable), "-screen", "0", SCREEN, "-dpi", "96", "-nolisten", "tcp"], pass_fds=[writable],
                         stdout=log, stderr=log)
    os.close(writable)
    with os.fdopen(readable) as told:
        return f":{told.readline().strip()}"


def unpack(archive_, there, environment, shared):
    """Unpacks the file into FreeCAD's folder Mod, as a user does whose FreeCAD is not running."""
    script = 'import FreeCAD; print("\\nfolder=" + FreeCAD.getUserAppDataDir(), flush=True)'
    told = run(*there, "freecadcmd", "-c", script, env=environment, stdin=subprocess.DEVNULL)
    home = re.search(r"^folder=.*?/home/(.*)$", told, re.MULTILINE)[1]
    begin = time.time()
    run("unzip", "-q", archive_, "-d", shared / "home" / home / "Mod")
    step = {"session": 1, "what": f"line typed: unzip {archive_.name} -d .../Mod", "waited": time.time() - begin}
    (shared / "state.json").write_text(json.dumps({"session": 1, "begin": begin, "steps": [step]}), encoding="utf-8")


def connect(folder, root, allowed):
    """The network that FreeCAD in this root sees; the list to which each address that is asked for is added."""
    tree, asked = folder / "MeshQuality", []
    run(ROOT / "tools" / "addon_tree", tree, REPOSITORY)
    make_certificates(folder)
    (folder / "hosts").write_text("".join(f"127.0.0.1 {host}\n" for host in ("localhost", *HOSTS)), encoding="ascii")
    run("ip", "link", "set", "lo", "up")
    run("mount", "--bind", folder / "hosts", root / "etc/hosts")
    run("mount", "--bind", folder / "certs", root / "etc/ssl/certs")
    serve(pages(tree, allowed), folder, asked)
    return asked


def enter(root, shared, pips):
    """Gives a root the folder, the screen, devices and processes, and a pip; the folder's place there."""
    (root / "tmp/.X11-unix").mkdir(exist_ok=True)
    run("mount", "--bind", shared, root / "mnt")
    run("mount", "--bind", "/tmp/.X11-unix", root / "tmp/.X11-unix")
    run("mount", "--rbind", "/dev", root / "dev")
    run("mount", "-t", "proc", "proc", root / "proc")
    for path in pips:
        zipfile.ZipFile(path).extractall(shared / "pip")
        place, = root.glob("usr/local/lib/python3*/dist-packages")
        run("mount", "--bind", shared / "pip", place)
    return Path("/mnt")


def work(arguments):
    """All of it, in namespaces of its own; whether the mesh was made."""
    with tempfile.TemporaryDirectory(prefix="addon-manager-") as name:
        folder, root = Path(name), arguments.root or Path("/")
        asked = connect(folder, root, ["numpy"] if arguments.refused else ["numpy", "meshquality_core"])
        shared = folder / "shared"
        shutil.copytree(HERE, shared / "scripts")
        shutil.copytree(arguments.wheels, shared / "wheels")
        (shared / "home").mkdir()
        screen = start_screen(folder)
        inside = enter(root, shared, arguments.wheels.glob("pip-*.whl")) if arguments.root else shared
        environment = {"HOME": f"{inside}/home", "PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "LIBGL_ALWAYS_SOFTWARE": "1",
                       "DISPLAY": screen, "QT_QPA_PLATFORM": "xcb", "QTWEBENGINE_DISABLE_SANDBOX": "1", "PIP_NO_INDEX": "1",
                       "PIP_CERT": "/etc/ssl/certs/ca-certificates.crt", "PIP_FIND_LINKS": f"{inside}/wheels",
                       "ADDON_MANAGER": str(inside), **({"ADDON_MANAGER_REFUSED": "1"} if arguments.refused else {})}
        there = [shutil.which("chroot"), str(root)]
        if arguments.zip:
            unpack(arguments.zip, there, environment, shared)
        done, begin = shared / "done.json", time.monotonic()
        with (shared / "freecad.log").open("w") as log:
            subprocess.Popen([*there, "freecad", f"{inside}/scripts/addon_manager_inside.py"], env=environment, stdin=subprocess.DEVNULL,
                             stdout=log, stderr=log)
        while not done.exists() and time.monotonic() - begin < LIMIT:
            time.sleep(0.2)
        time.sleep(0.5)
        (shared / "asked.json").write_text(json.dumps(asked, indent=1), encoding="utf-8")
        shutil.rmtree(RESULT, ignore_errors=True)
        RESULT.mkdir(parents=True)
        for path in (*shared.glob("*.png"), *shared.glob("*.json"), shared / "freecad.log"):
            shutil.copyfile(path, RESULT / path.name)
        return done.exists() and report(json.loads(done.read_text(encoding="utf-8")))


def report(said):
    """Prints the steps and what came of them; whether that is a certified mesh."""
    for step in said["steps"]:
        print(f"{step['session']}. {step['waited']:6.1f} s  {step['what']}")
    lines = sum(step["what"].startswith("line typed") for step in said["steps"])
    print(f"{len(said['steps']) - lines} clicks, {lines} lines typed, {said['seconds']:.1f} s; FreeCAD {said['freecad']}; {said['result']}")
    return bool(said["met"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("wheels", type=Path, help="folder with wheels of tools/wheel; one of pip stands in for the package python3-pip")
    parser.add_argument("--root", type=Path, help="a Debian in a folder, with FreeCAD")
    parser.add_argument("--refused", action="store_true", help="the index does not allow the package of the binary")
    parser.add_argument("--zip", type=Path, help="a zip of tools/release with the binaries in it")
    arguments = parser.parse_args()
    if "ADDON_MANAGER_ALONE" not in os.environ:
        os.environ["ADDON_MANAGER_ALONE"] = "1"
        os.execvp("unshare", ["unshare", "--map-root-user", "--mount", "--net", "--pid", "--fork", "--kill-child", "--mount-proc",
                              sys.executable, *sys.argv])
    good = work(arguments)
    print(f"{int(good)} passed, {int(not good)} failed")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
