#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Booleans of random solids that share a face, beside OpenCASCADE: components, area, volume.

    /usr/bin/python3 benchmarks/boolean/boolean_contacts.py --pairs 50

Kinds of faces, how the solids lie on each other, and displacements within the tolerance: tests/parts/contact_pairs.py. Every
second pair is given as meshes, the others as shapes. `--only plane-7` runs one pair and says more.
"""

import sys
import time
from collections import Counter
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--pairs", type=int, default=20, help="of each kind")
    result.add_argument("--first", type=int, default=0, help="seed of the first")
    result.add_argument("--kinds", nargs="*", help="plane, cylinder, cone, sphere, torus, spline; default: all")
    result.add_argument("--only", help="KIND-SEED")
    return result


def operands_of(pair, as_meshes):
    import MeshQuality as mq

    if not as_meshes:
        return pair.first, pair.displaced
    return tuple(mq.triangulate(shape, chord_height=0.5 * pair.tolerance).to_mesh()
                 for shape in (pair.first, pair.displaced))


def run(pair, as_meshes):
    """For each operation what is wrong, "" where nothing is, and whether the error bound says that the tolerance is kept."""
    import MeshQuality as mq
    from parts.contact_pairs import OPERATIONS, disagreement

    operands = operands_of(pair, as_meshes)
    found = {}
    for operation in OPERATIONS:
        try:
            result = mq.boolean(*operands, operation, tolerance=pair.tolerance, method="exact")
            what = disagreement(pair, operation, result)
            met = result.report.error_bound <= pair.tolerance
            found[operation] = (what, met)
        except mq.Error as error:
            found[operation] = (f"{type(error).__name__}: {error}", False)
    return found


def work(arguments):
    from parts.contact_pairs import KINDS, contact_pair

    chosen = [(arguments.only.rsplit("-", 1)[0], int(arguments.only.rsplit("-", 1)[1]))] if arguments.only else \
        [(kind, seed) for kind in arguments.kinds or KINDS
         for seed in range(arguments.first, arguments.first + arguments.pairs)]
    wrong, unmet, done, rows = Counter(), Counter(), Counter(), []
    start = time.process_time()
    for kind, seed in chosen:
        pair = contact_pair(kind, seed)
        for operation, (what, met) in run(pair, seed % 2 == 1).items():
            done[kind, operation] += 1
            unmet[kind, operation] += not met
            if what:
                wrong[kind, operation] += 1
                rows.append((kind, seed, operation, what, met))
                print(f"{kind}-{seed} {operation}: {what}; {'called met' if met else 'not called met'}", flush=True)
    for kind, operation in done:
        print(f"{kind:9} {operation:21} {wrong[kind, operation]:4} wrong, {unmet[kind, operation]:4} not called met, "
              f"of {done[kind, operation]}")
    print(f"{sum(wrong.values())} wrong, {sum(row[-1] for row in rows)} of these called met, of {sum(done.values())}; "
          f"{time.process_time() - start:.0f} CPU s")
    return {"wrong": rows, "done": sum(done.values()), "status": int(bool(rows))}


inside_freecad.start(__file__, parser(), work)
