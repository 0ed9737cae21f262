# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core, certificates and errors say, in the user's language."""

import FreeCAD

from .. import phrases


def translate_phrase(text):
    """Of one of phrases.texts(), with places for what differs."""
    return FreeCAD.Qt.translate("MeshQuality", text)


def translated(text):
    """Of a reason, an error, or anything else of the table of phrases."""
    return phrases.translated(str(text), translate_phrase)


def translated_certificate(text):
    """Of what a certificate says is not met: sentences."""
    return phrases.sentences(text, translate_phrase)


def translated_stage(stage):
    """Of a stage of the work."""
    return phrases.stage(stage, translate_phrase)
