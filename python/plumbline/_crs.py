"""Reference systems of what is held against each other."""

from __future__ import annotations

from typing import Any

from plumbline.errors import Error


def crs_of(x: Any) -> str:
    """The name of the reference system of lines, of an arrangement, of a GeoSeries; "": unknown."""
    x = getattr(x, "lines", x)
    crs = getattr(x, "crs", None)
    if crs is None or isinstance(crs, str):
        return crs or ""
    return str(crs.to_string()) if hasattr(crs, "to_string") else ""


def ensure_same_crs(a: Any, b: Any) -> None:
    """An Error where both are known and differ."""
    one, other = crs_of(a), crs_of(b)
    if one and other and one != other and not _are_same(one, other):
        raise Error(f"different reference systems: {one:.60} and {other:.60}")


def _are_same(one: str, other: str) -> bool:
    """Whether two texts mean the same, as far as pyproj is there to tell."""
    try:
        from pyproj import CRS
        from pyproj.exceptions import CRSError
    except ImportError:
        return False
    try:
        return bool(CRS(one).equals(CRS(other), ignore_axis_order=True))
    except CRSError:
        return False
