# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings the mesh of an object up to date in the background, told of in the status bar."""

import FreeCAD

from ..errors import Error
from . import background, background_recompute, jobs
from .panel_operation import Operation, Watch
from .translation import translated

translate = FreeCAD.Qt.translate


def update_in_background(obj):
    """Begins the work; returns its Job, None when there is nothing to do."""
    background_recompute.stop(obj)
    title = translate("MeshQuality", "Update {}").format(obj.Label)
    made = Operation.of_object(title, obj)
    try:
        work = made.work(made.values())
    except (Error, ImportError) as error:
        FreeCAD.Console.PrintError(f"{title}: {translated(error)}\n")
        return None
    watch = Watch(made.sources)
    job = jobs.Job(title, work.result, lambda result: made.land(work, result, watch),
                   lambda: made.possible(obj), obstacle=made.obstacle_beside_tasks, taking=jobs.ADDING)
    job.ended.connect(watch.end)
    background.tell(job)
    return jobs.queue().add(job)
