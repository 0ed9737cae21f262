# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core, certificates and errors say, in the user's language."""

import FreeCAD

from .. import phrases


def translate_phrase(text):
    """One of phrases.texts() in the user's language, with places for what differs."""
    return FreeCAD.Qt.translate("MeshQuality", text)


def translated(text):
    """A reason, an error, or anything else of the table of phrases in the user's language."""
    return phrases.translated(str(text), translate_phrase)


def translated_certificate(text):
    """The sentences of a certificate in the user's language."""
    return phrases.sentences(text, translate_phrase)


def translated_stage(stage):
    """A stage of the work in the user's language."""
    return phrases.stage(stage, translate_phrase)
