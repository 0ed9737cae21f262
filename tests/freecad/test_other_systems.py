# SPDX-License-Identifier: LGPL-2.1-or-later
"""Without what Windows lacks of Python, what deals with the system is still imported, and a part is meshed, written and read again."""

import os
import subprocess
import tempfile
import unittest

import helpers

# Modules and names that Python has on POSIX only.
MODULES = ("fcntl", "grp", "posix", "pty", "pwd", "resource", "syslog", "termios", "tty")
OS = ("fork", "forkpty", "getegid", "geteuid", "getgid", "getgroups", "getpgid", "getuid", "killpg", "mkfifo", "mknod", "nice",
      "posix_fallocate", "sched_getaffinity", "setsid", "statvfs", "uname", "wait4", "O_CLOEXEC", "O_DIRECTORY", "O_NOFOLLOW",
      "O_NONBLOCK", "WNOHANG")
SIGNAL = ("SIGALRM", "SIGCHLD", "SIGHUP", "SIGKILL", "SIGPIPE", "SIGQUIT", "SIGSTOP", "SIGUSR1", "alarm", "pthread_sigmask",
          "setitimer", "sigwait")
SCRIPT = """
import sys
sys.path[:0] = {paths!r}
import FreeCAD, Part
import builtins, errno, os, select, shutil, signal, socket, subprocess, tempfile
import numpy, uuid, unittest.mock

for module, names in ((os, {os!r}), (signal, {signal!r})):
    for name in names:
        vars(module).pop(name, None)
vars(errno).pop("EDQUOT", None)
shutil._use_fd_functions = False
shutil._rmtree_impl = getattr(shutil, "_rmtree_unsafe", None)  # chosen when Python 3.14 imports shutil
sys.platform = "win32"
own_import = builtins.__import__

def imported(name, globals=None, *others):
    if (globals or {{}}).get("__name__", "").startswith("MeshQuality") and name.partition(".")[0] in {modules!r}:
        raise ImportError("not on Windows: " + name)
    return own_import(name, globals, *others)

builtins.__import__ = imported
import MeshQuality as mq
from MeshQuality import limits, scratch
from MeshQuality.batch import cluster, freecad_pool, ledger, worker_loop
from MeshQuality.cli import freecad_process, signals, single_job
worker_loop.forget_peak()
limits.limit_memory(2**40)
limits.end_itself_after(1)
scratch.remove_left()
with signals.signals_held(), signals.EndedBySignals(), scratch.Folder() as folder:
    path = os.path.join(folder.path, "ball.msh")
    ball = mq.triangulate(Part.makeSphere(5))
    ball.write(path)
    print("triangles", len(ball.triangles), "of", len(mq.read_mesh(path).boundary()[0]))
assert cluster.cores() > 0
print("removed", not os.path.exists(folder.path))
sys.stdout.flush()
"""


class Windows(unittest.TestCase):
    def test_nothing_that_it_lacks_is_needed(self):
        paths = [os.path.join(helpers.ROOT, "Mod")]
        with tempfile.TemporaryDirectory() as folder:
            script = os.path.join(folder, "script.py")
            with open(script, "w", encoding="utf-8") as stream:
                stream.write(SCRIPT.format(paths=paths, modules=MODULES, os=OS, signal=SIGNAL))
            done = subprocess.run(["freecadcmd", script], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                  timeout=120, check=False)
        said = done.stdout + done.stderr
        self.assertRegex(said, r"(?m)^triangles (\d+) of \1$")
        self.assertIn("removed True\n", said)
