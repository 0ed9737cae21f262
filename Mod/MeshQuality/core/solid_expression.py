# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solid: solids joined by several operations that are computed together, and rounded once."""

from .. import options
from ..errors import InvalidInput
from ..listing import Public
from .booleans import run
from .operands.operands import Operands

# Tokens of the core's expressions.
_TOKENS = {"union": -1, "intersection": -2, "difference": -3, "symmetric_difference": -4}
# Operands and operations of an expression at most: a solid that is joined to itself 20 times has as many.
_MOST_TOKENS = 2_000_000


class Solid(metaclass=Public):
    """A solid of which operations make further ones; nothing is computed before `evaluate`.

    source      what `boolean` takes as an operand: a mesh, arrays (V, F), a shape, or a document object

    a | b, a & b, a - b and a ^ b are the union, the intersection, the difference and the symmetric
    difference; `b` may be a source. A solid may be part of several others. `evaluate` divides the
    triangles of all sources in one arrangement, so that nothing is rounded between the operations:
    (a - b) | (a & b) has the surface of a.
    """

    __slots__ = ("_source", "_operation", "_first", "_second")

    def __init__(self, source):
        if isinstance(source, Solid):
            raise InvalidInput("source is a Solid already")
        self._source, self._operation = source, None

    @classmethod
    def _joined(cls, operation, first, second):
        solid = cls.__new__(cls)
        solid._source, solid._operation = None, operation
        solid._first = first
        solid._second = second if isinstance(second, Solid) else cls(second)
        return solid

    def __or__(self, other):
        return self._joined("union", self, other)

    def __and__(self, other):
        return self._joined("intersection", self, other)

    def __sub__(self, other):
        return self._joined("difference", self, other)

    def __xor__(self, other):
        return self._joined("symmetric_difference", self, other)

    def __repr__(self):
        leaves, expression = self._in_postfix()
        counts = ((len(leaves), "source"), (sum(token < 0 for token in expression), "operation"))
        return f"<Solid: {', '.join(f'{count} {what}' + 's' * (count != 1) for count, what in counts)}>"

    def evaluate(self, resolution=512, tolerance=None, progress=None, threads=0):
        """The surface of the solid as a BooleanMesh; triangle_source counts the sources by their first place in
        the expression.

        resolution, tolerance, progress, threads   as `boolean` has them

        Raises as `boolean` does, and InvalidInput for an expression of more than 2,000,000 operands and operations.
        """
        values = options.check(options.BOOLEAN, {"operation": "union", "resolution": resolution,
                                                 "tolerance": tolerance, "method": "default"})
        values["threads"] = options.THREADS.checked(threads)
        options.require_callable(progress)
        leaves, expression = self._in_postfix()
        values["operation"] = expression
        return run(Operands([leaf._source for leaf in leaves]), values, progress)

    def _in_postfix(self):
        """(the solids that are sources, each once, the expression in postfix order)."""
        leaves, place, expression = [], {}, []
        stack = [self]
        while stack:
            if len(expression) + len(stack) > _MOST_TOKENS:
                raise InvalidInput(f"the expression has more than {_MOST_TOKENS:,} operands and operations: evaluate "
                                   "parts of it, and join their meshes")
            item = stack.pop()
            if isinstance(item, str):
                expression.append(_TOKENS[item])
            elif item._operation is None:
                if id(item) not in place:
                    place[id(item)] = len(leaves)
                    leaves.append(item)
                expression.append(place[id(item)])
            else:
                stack += [item._operation, item._second, item._first]
        return leaves, expression
