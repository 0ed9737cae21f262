# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core, certificates and errors say, in the user's language and units."""

import FreeCAD

from .. import options, phrases
from . import quantities


def translate_phrase(text):
    """One of phrases.texts() in the user's language, with places for what differs."""
    return FreeCAD.Qt.translate("MeshQuality", text)


def of_workbench(text):
    """A property of the workbench with a text in the user's language: FreeCAD asks for it whenever it lists the workbenches, and
    does not translate it.
    """
    return property(lambda _: FreeCAD.Qt.translate("Workbench", text))


_TITLES = {option.name: option.title for table in (options.TRIANGULATE, options.CURVE, options.CURVED_DISPLAY, options.fem.FEM,
                                                   options.BOOLEAN, options.IMPROVE, options.offset.OFFSET_OBJECT,
                                                   options.offset.HOLLOW_OBJECT, options.inspection.INSPECTION_OBJECT, options.inspection.DEVIATION,
                                                   options.wrap.WRAP_OBJECT, options.simplify.SIMPLIFY, options.cam.CAM, options.repair.REPAIR_OBJECT) for option in table}


def _title(name):
    return translate_phrase(_TITLES.get(name, name))


WORDING = phrases.Wording(translate_phrase, quantities.in_locale, quantities.lengths_in_units, _title, quantities.volume_in_unit)


def translated(text):
    """A reason, an error, or anything else of the table of phrases."""
    return phrases.translated(phrases.text_of(text), WORDING)


def translated_certificate(text):
    """The sentences of a certificate."""
    return phrases.translated(text, WORDING)


def translated_stage(stage):
    """A stage of the work in the user's language."""
    return phrases.stage(stage, WORDING)


def translated_rest(stage):
    """What goes on after cancelling in the middle of a stage, in the user's language."""
    return phrases.rest(stage, WORDING)
