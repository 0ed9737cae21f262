# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of document objects that an expression sets. FreeCAD evaluates it again with each recompute, so that
nothing else can change them.
"""

from .. import phrases
from ..errors import InvalidInput
from .distance_bound import PROPERTY


def expressions_of(obj, table):
    """{option: (property, expression)} of those options whose properties are bound to expressions."""
    engine = {path.lstrip("."): expression for path, expression, *_ in obj.ExpressionEngine}
    found = {}
    for option in table:
        names = [option.property_name, *([option.alias_property_name] if option.alias else ()),
                 *([PROPERTY] if option.is_distance else ())]
        bound = [(name, engine[name]) for name in names if name in engine]
        if bound:
            found[option.name] = bound[0]
    return found


def require_free(obj, table, before, values):
    """Raises InvalidInput where the options would be others than before, but an expression sets them.

    before, values  {option: checked value}
    """
    for name, (bound, expression) in expressions_of(obj, table).items():
        if values[name] != before[name]:
            raise InvalidInput(phrases.Text(phrases.BOUND_BY_EXPRESSION, option=name, name=bound, name2=f"'{obj.Label}'",
                                            value=expression, name3=f"obj.setExpression({bound!r}, None)"))
