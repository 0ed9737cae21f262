# SPDX-License-Identifier: LGPL-2.1-or-later
"""`meshquality batch`: the same operation on every part below a folder.

    plan        what is to be done: parts, options, limits, where results go
    ledger      parts.jsonl: what was done already
    freecad_pool  FreeCADs that do one part after the other, with limits; `worker_loop` is what runs in them
    part        one part: what is run on a worker
    cluster     the parts on workers, by Dask
    table, report, charts     parts.csv and report.html
    atomic_file  how files are replaced
    command     all of it, for the command line

Only `worker_loop` imports FreeCAD. Results do not depend on which worker did a part, nor on what it did
before; a part has failed only if it failed in a FreeCAD that had done nothing else.
"""

# Lines of parts.jsonl stay short: they have some items only of a list with more than LONG_LIST.
LONG_LIST, SHOWN_OF_LIST = 60, 20
