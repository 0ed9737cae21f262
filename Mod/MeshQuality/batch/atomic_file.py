# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are complete or absent, whenever a batch is stopped."""

import contextlib
import os

from ..files import UNFINISHED_OF_BATCH, remove_if_there, unfinished


@contextlib.contextmanager
def replacing(path, **options):
    """A stream for what `path` will hold once all is written; `options` are those of `open`."""
    ready = unfinished(path, "", UNFINISHED_OF_BATCH)
    try:
        with open(ready, "x", **options) as stream:
            yield stream
            stream.flush()
            os.fsync(stream.fileno())
        os.replace(ready, path)
    finally:
        remove_if_there(ready)
