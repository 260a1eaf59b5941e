"""World coordinates under pixels, by closed-form inverse formulas and by the inverted matrix.

Arrays are NumPy's. Pixels are device pixels: origin at the top-left corner, y down, the centre of
pixel (i, j) at (i + 0.5, j + 0.5).
"""

from . import _core
from ._core import *  # noqa: F403

__all__ = [name for name in dir(_core) if not name.startswith("_")]
__version__ = _core.__version__
