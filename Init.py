# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD executes this file without telling where it lies; the addon's folder is on sys.path.
import os
import sys

for _folder in list(sys.path):
    _package_home = os.path.join(_folder, "Mod")
    if os.path.isfile(os.path.join(_package_home, "MeshQuality", "__init__.py")):
        if _package_home not in sys.path:
            sys.path.append(_package_home)
        from MeshQuality import exchange

        exchange.register()
        break
del _folder, _package_home
