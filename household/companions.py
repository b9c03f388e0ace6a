"""The packages that come with this one; their names are general, so others use them."""

from importlib.util import find_spec
from pathlib import Path

COMPANIONS = {"learners": "catalog", "policies": "learning", "experiments": "cli"}
"""Each of them with a part that only ours has."""


def check_companions(root: Path) -> None:
    """Makes sure that they are not shadowed; imports none of them.

    Args:
        root: The folder that this package is in.

    Raises:
        ImportError: If another package of the name comes first, or lies over ours.
    """
    for name, part in COMPANIONS.items():
        try:
            spec = find_spec(name)
        except ValueError:  # It is loaded, and does not know where from.
            continue
        if spec is None or spec.origin is None:  # Whoever needs it will miss it.
            continue
        file = Path(spec.origin)
        folder = file.parent
        own = folder.parent == root and any(folder.glob(f"{part}*"))
        if not own:
            other = folder if file.name == "__init__.py" else file
            raise ImportError(
                f"household comes with a package {name!r}, but another one is found "
                f"in its place: {other}; rename that, take it off the module path, "
                "or install household into an environment of its own"
            )
