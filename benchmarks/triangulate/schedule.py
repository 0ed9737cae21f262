# SPDX-License-Identifier: LGPL-2.1-or-later
"""Replays what an operation did on a number of threads: list scheduling of its recorded tasks.

A record is what MeshQuality._core.stop_recording returns: tasks, sections in which a task shares its work among threads, and stages. It
must have been made with the number of threads that is simulated, since pieces of work depend on it.
"""

import heapq


def makespan(seconds, threads, start=0.0):
    """Seconds until tasks have ended that `threads` workers take in their order, each when it is free.

    start: seconds from the call until the workers begin, and from their end until the call returns
    """
    free = [0.0] * threads
    for duration in seconds:
        heapq.heappush(free, heapq.heappop(free) + duration)
    return start + max(free)


def durations(record, starts):
    """Seconds of every task with the sections within it.

    starts: number of threads -> seconds that it takes to start and end them
    """
    result = [seconds for _, seconds in record["tasks"]]
    of_section = [[] for _ in record["sections"]]
    for task, (section, _) in enumerate(record["tasks"]):
        if section >= 0:
            of_section[section].append(task)
    # Sections within tasks of a section come after it.
    for (caller, threads), tasks in reversed(list(zip(record["sections"], of_section))):
        result[caller] += makespan([result[task] for task in tasks], threads, starts[threads])
    return result


def stage_seconds(record, starts):
    """Seconds of the stages in their order, {name: (on one thread, on several)}; "" is what belongs to none."""
    several = durations(record, starts)
    one = durations_on_one(record)
    names = {task: name for name, task in record["stages"]}
    result = {}
    for task, (section, _) in enumerate(record["tasks"]):
        if section < 0:
            before = result.get(names.get(task, ""), (0.0, 0.0))
            result[names.get(task, "")] = (before[0] + one[task], before[1] + several[task])
    return result


def durations_on_one(record):
    """Seconds of every task with all that it called, on one thread."""
    result = [seconds for _, seconds in record["tasks"]]
    for task in reversed(range(len(result))):
        section = record["tasks"][task][0]
        if section >= 0:
            result[record["sections"][section][0]] += result[task]
    return result


def numbers_of_threads(record):
    """The numbers of threads for which a replay needs the time of their start."""
    return sorted({threads for _, threads in record["sections"]})
