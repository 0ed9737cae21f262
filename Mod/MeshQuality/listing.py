# SPDX-License-Identifier: LGPL-2.1-or-later
"""What help() and tab completion list: what scripts use, and nothing else."""

import pkgutil
import sys


class _Unlisted:
    """Finds the modules of a folder for imports, and lists none."""

    def __init__(self, finder):
        self.find_spec, self.invalidate_caches = finder.find_spec, finder.invalidate_caches

    def iter_modules(self, prefix=""):
        """Called by pkgutil, with which help() lists the modules of a package."""
        return iter(())


def hide_modules(folders):
    """Has help() leave out the modules in the folders of a package."""
    for folder in folders:
        finder = pkgutil.get_importer(folder)
        if finder is not None and not isinstance(finder, _Unlisted):
            sys.path_importer_cache[folder] = _Unlisted(finder)


def _public(names):
    return [name for name in names if not name.startswith("_") or name.startswith("__")]


class Public(type):
    """Metaclass of public classes: dir() of them and of their objects leaves out what begins with an underscore."""

    def __new__(cls, name, bases, members):
        """A class whose objects list what is public."""
        return super().__new__(cls, name, bases, {"__dir__": lambda self: _public(object.__dir__(self)), **members})

    def __dir__(cls):
        return _public(super().__dir__())
