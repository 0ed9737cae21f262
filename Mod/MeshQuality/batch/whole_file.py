# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are there whole or not at all, whenever a batch is stopped."""

import contextlib
import os


@contextlib.contextmanager
def replacing(path, **options):
    """A stream for what `path` will hold once all is written; `options` are those of `open`."""
    ready = path.with_name(f".{path.name}.part")
    with open(ready, "w", **options) as stream:
        yield stream
        stream.flush()
        os.fsync(stream.fileno())
    os.replace(ready, path)
