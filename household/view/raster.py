"""Pictures of homes as pixels, to draw on top of."""

from dataclasses import dataclass
from functools import lru_cache
from io import BytesIO

import numpy as np
from numpy.typing import NDArray

from household.home.floorplan import FloorPlan
from household.view.floorplan_svg import BORDER, SCALE, draw_on, size_of


@dataclass(frozen=True, eq=False)
class Raster:
    """A picture of a home.

    Attributes:
        pixels: Shape (height, width, 3), red, green and blue.
        left: x of the left edge [m].
        top: y of the upper edge [m].
        scale: Pixels per meter.
    """

    pixels: NDArray[np.uint8]
    left: float
    top: float
    scale: float


@lru_cache(maxsize=8)
def rasterize(plan: FloorPlan, scale: float) -> Raster:
    """Draws a home.

    Args:
        plan: The home.
        scale: Pixels per meter.
    """
    from matplotlib.figure import Figure

    dpi = scale / SCALE
    width, height = (int(side) for side in np.ceil(size_of(plan) * scale))
    # Half a pixel more, as Matplotlib rounds down.
    figure = Figure(figsize=((width + 0.5) / dpi, (height + 0.5) / dpi), dpi=dpi)
    draw_on(plan, figure.add_axes((0.0, 0.0, 1.0, 1.0)))
    data = BytesIO()
    figure.savefig(data, format="rgba", dpi=dpi)
    rgba = np.frombuffer(data.getvalue(), dtype=np.uint8).reshape(height, width, 4)
    left, top = plan.lower[0] - BORDER, plan.upper[1] + BORDER
    return Raster(rgba[..., :3].copy(), float(left), float(top), scale)
