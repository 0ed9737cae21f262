# SPDX-License-Identifier: LGPL-2.1-or-later
"""first_height: how high the first layer on a wall must be for a y+, by what is known of flat plates."""

import math

from ...errors import InvalidInput
from ...listing import Public

FLUIDS = {"air": 1.516e-5, "water": 1.004e-6}  # m^2/s, kinematic viscosity at 20 degrees Celsius and 1 atm (White, appendix A)
_TRANSITION = 5e5  # Reynolds number of a plate from which on its flow counts as turbulent


class FirstHeight(float, metaclass=Public):
    """A height in mm, for first_height= of volume_mesh, whose report then says what it is for.

    y_plus             that was asked for, of the centre of the first cell
    reynolds           of speed and length
    skin_friction      coefficient of it, of the wall shear stress to the dynamic pressure
    friction_velocity  m/s
    """

    __slots__ = {"y_plus": "of the centre of the first cell", "reynolds": "of speed and length", "skin_friction": "coefficient",
                 "friction_velocity": "m/s"}

    def __str__(self):
        return (f"a first layer of {float(self):.4g} mm has its centre at y+ = {self.y_plus:g}, as on a flat plate with a Reynolds number of "
                f"{self.reynolds:.3g}, where the friction velocity is {self.friction_velocity:.4g} m/s")


def first_height(speed, length, fluid="air", y_plus=1.0):
    """The height of the first layer on a wall with which the centre of its cells, where solvers take the velocity, is at a y+
    -> FirstHeight, a float in mm.

    speed   m/s, of the free flow
    length  mm, of the wall along the flow; of a duct its diameter
    fluid   "air" or "water" of 20 degrees Celsius, or a kinematic viscosity in m^2/s
    y_plus  distance from the wall in units of viscosity / friction velocity

    An estimate by the skin friction at the end of a flat plate: 0.664 / Re^(1/2) below a Reynolds number of 5e5, which is laminar
    (Blasius), 0.027 / Re^(1/7) above (White, Fluid Mechanics, chapter 7). Nearer to the front y+ is larger. What a flow really has the
    solver tells.

    Raises InvalidInput naming the value.
    """
    viscosity = FLUIDS.get(fluid, fluid) if isinstance(fluid, str) else fluid
    if isinstance(viscosity, str):
        raise InvalidInput(f"fluid = {fluid!r}: give {' or '.join(map(repr, FLUIDS))}, or a kinematic viscosity in m^2/s")
    for name, value, unit in (("speed", speed, "m/s"), ("length", length, "mm"), ("fluid", viscosity, "m^2/s"), ("y_plus", y_plus, "")):
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0.0 < value < math.inf:
            raise InvalidInput(f"{name} = {value!r}: give a number above 0" + (f", in {unit}" if unit else ""))
    reynolds = speed * length / 1000.0 / viscosity
    friction = 0.664 / math.sqrt(reynolds) if reynolds < _TRANSITION else 0.027 / reynolds ** (1.0 / 7.0)
    velocity = speed * math.sqrt(friction / 2.0)
    found = FirstHeight(2.0 * y_plus * viscosity / velocity * 1000.0)
    found.y_plus, found.reynolds, found.skin_friction, found.friction_velocity = float(y_plus), reynolds, friction, velocity
    return found
