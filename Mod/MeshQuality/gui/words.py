# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core, certificates and errors say, in the user's language."""

import FreeCAD

from .. import phrases


def _translate(text):
    return FreeCAD.Qt.translate("MeshQuality", text)


def translated(text):
    """Of a reason, an error, or anything else of the table of phrases."""
    return phrases.translated(str(text), _translate)


def translated_certificate(text):
    """Of what a certificate says is missed: a sentence."""
    return phrases.sentences(text, _translate)


def translated_stage(stage):
    """Of a stage of the work."""
    return phrases.stage(stage, _translate)
