# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a batch on workers, by Dask: a cluster on this machine, or one that is there.

Dask's workers only wait: the work is done by the FreeCADs that they start, see freecad_pool. So on one
machine one worker of as many threads as there are jobs, in this process, is enough.
"""

import itertools
import logging
import os
import socket
import sys
import threading
import time
import urllib.parse
import uuid
import warnings
from contextlib import contextmanager

from ..errors import Error
from ..scratch import Folder
from .part import LOST

# Parts that the scheduler knows at a time, for each thread of the workers: enough that none waits
# for this process, few enough that a million parts cost it no more than a thousand.
AHEAD = 4
LEAST_AHEAD = 32
WAIT_FOR_WORKERS = 60.0
DASHBOARD = "127.0.0.1:8787"
CHECK_EVERY = 200  # parts between two queries of the number of workers


def cores():
    """How many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


@contextmanager
def client_of(scheduler=None, jobs=None, dashboard=False):
    """A Dask client: of the cluster at `scheduler`, or of one in this process with `jobs` threads.

    The latter talks within this process and listens nowhere, but for its dashboard, for this machine
    only. Raises Error where there is no such cluster, or no worker in it.
    """
    import dask
    from distributed import Client

    for name in list(logging.root.manager.loggerDict):
        # Errors are raised, and stderr belongs to the command's line. Some of Dask's loggers have
        # levels of their own.
        if name.partition(".")[0] in ("distributed", "asyncio"):
            logging.getLogger(name).setLevel(logging.CRITICAL)

    # Results of parts are small, and FreeCAD's memory is limited elsewhere.
    with dask.config.set({"distributed.worker.memory.target": False,
                          "distributed.worker.memory.spill": False}):
        if scheduler is None:
            with Folder() as made, \
                    _local_cluster(jobs or cores(), made.path, dashboard) as cluster, \
                    Client(cluster) as client:
                if dashboard:
                    port = cluster.scheduler.services["dashboard"].port
                    print(f"meshquality: Dask's dashboard is at http://127.0.0.1:{port}", file=sys.stderr)
                yield client
            return
        try:
            _require_listener(scheduler)
            client = Client(scheduler, timeout=20)
        except (OSError, ValueError, TimeoutError) as error:
            raise Error(f"there is no Dask scheduler at {scheduler}: {error}") from error
        with client:
            try:
                client.wait_for_workers(1, timeout=WAIT_FOR_WORKERS)
            except TimeoutError as error:
                raise Error(f"the Dask cluster at {scheduler} has no workers: start some with "
                            f"dask-worker {scheduler}") from error
            yield client


def _local_cluster(threads, scratch, dashboard):
    """A scheduler and a worker in this process that exchange objects, without any port.

    Dask's LocalCluster starts servers of HTTP for both on all addresses, whatever it is told.
    """
    from distributed import Scheduler, SpecCluster, Worker

    class Unheard:
        def start_http_server(self, *_, **__):
            """Listens nowhere."""

    class QuietScheduler(Unheard, Scheduler):
        pass

    class QuietWorker(Unheard, Worker):
        pass

    # Where another program has the port, Dask takes another one and warns.
    warnings.filterwarnings("ignore", "Port ", UserWarning)
    shown = {"dashboard": True, "dashboard_address": DASHBOARD} if dashboard else {}
    return SpecCluster(
        scheduler={"cls": Scheduler if dashboard else QuietScheduler,
                   "options": {"protocol": "inproc://", **shown}},
        workers={0: {"cls": QuietWorker, "options": {
            "protocol": "inproc://", "nthreads": threads, "memory_limit": 0, "local_directory": scratch}}})


def _require_listener(address):
    """Raises OSError at once where nobody listens: Dask would try for a while."""
    place = urllib.parse.urlsplit(address)
    if place.scheme == "tcp" and place.port:
        socket.create_connection((place.hostname, place.port), timeout=20).close()


def shipped(module, name):
    """A function of (package folder, arguments) that runs a function of MeshQuality.batch on a worker.

    A nested function travels by its content, so that workers need not have the package on their
    path; they need its folder, under the same path or as MESHQUALITY_MOD says.
    """
    def work(folder, *arguments):
        import importlib
        import os
        import sys

        folder = os.environ.get("MESHQUALITY_MOD", folder)
        if folder not in sys.path:
            sys.path.insert(0, folder)
        return getattr(importlib.import_module(f"MeshQuality.batch.{module}"), name)(*arguments)

    return work


def run(client, plan, parts, finished, work=None):
    """Does the parts, in their order; calls finished(entry) for each once, in the order they end.

    work(folder, task, batch) does one, on a worker; part.run unless another one is given.
    Raises ConnectionError when the scheduler, or for WAIT_FOR_WORKERS the last worker, goes away: what was not finished is
    not done.
    """
    from distributed import as_completed

    folder = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    batch, work = uuid.uuid4().hex, work or shipped("part", "run")
    waiting, tasks, numbers = iter(parts), {}, itertools.count()
    flow = as_completed(with_results=True, raise_errors=False)

    def submit(count):
        for part in [part for _, part in zip(range(count), waiting)]:
            # Keys travel as UTF-8, which not all names are.
            name = part.name.encode(errors="replace").decode()
            future = client.submit(work, folder, plan.task(part), batch, pure=False,
                                   key=f"{batch[:8]}-{next(numbers)}-{name}")
            tasks[future.key] = part
            flow.add(future)

    ended, watch = 0, _WorkerWatch(client, flow)
    try:
        submit(_ahead(client))
        watch.start()
        for future, result in flow:
            part = tasks.pop(future.key)
            if isinstance(result, dict):
                finished(result)
            elif watch.lost:
                raise ConnectionError("the Dask cluster has no workers any more: start some and run it again to go on")
            elif future.status == "cancelled":
                raise ConnectionError("the Dask scheduler has gone: run it again to go on")
            else:
                finished(_lost(plan, part, result))
            future.release()
            ended += 1
            wanted = 1 if ended % CHECK_EVERY else _ahead(client) - len(tasks)
            submit(max(0, wanted))
    finally:
        watch.end()
        _end_work(client, batch, folder)


class _WorkerWatch(threading.Thread):
    """Cancels the futures of `flow` once the cluster has been without workers for WAIT_FOR_WORKERS: Dask would wait for
    others without an end. `lost` says so.
    """

    def __init__(self, client, flow):
        super().__init__(daemon=True)
        self._client, self._flow, self._ended = client, flow, threading.Event()
        self.lost = False

    def run(self):
        """The thread."""
        seen = time.monotonic()
        while not self._ended.wait(WAIT_FOR_WORKERS / 20.0):
            if self._client.status != "running" or self._client.nthreads():
                seen = time.monotonic()
            elif time.monotonic() - seen > WAIT_FOR_WORKERS:
                self.lost = True
                self._client.cancel(list(self._flow.futures))
                return

    def end(self):
        """Stops watching."""
        self._ended.set()
        if self.is_alive():
            self.join()


def _ahead(client):
    threads = sum(client.nthreads().values())
    return max(LEAST_AHEAD, AHEAD * threads)


def _end_work(client, batch, folder):
    """Ends the FreeCADs of the batch on all workers."""
    if client.status == "running":
        client.run(shipped("freecad_pool", "close_pool"), folder, batch, on_error="ignore")


def _lost(plan, part, raised):
    """The entry of a part that no worker could finish, with what Dask raised."""
    error = raised[1] if isinstance(raised, tuple) else raised
    return {**{name: plan.task(part)[name] for name in ("part", "key", "size", "mtime_ns")},
            "output": None, "digest": None, "state": LOST, "attempts": 0,
            "error": f"{type(error).__name__}: {error}"}
