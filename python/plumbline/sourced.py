"""Shapely's geometries, each with the items of the input that it is made of."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from plumbline._cached import cached
from plumbline._optional import needed
from plumbline.lists import Lists


class Sourced(Sequence[Any]):
    """Shapely's geometries, each with the items of the input that it is made of.

    A sequence of geometries; as a whole it is `geometry`, whose attributes and methods it has:
    ``.wkt``, ``.geoms``, ``.length``, ``.equals(...)``. (Shapely's geometries have no place for
    attributes of one's own, and cannot be subclassed.) Arrays of it are arrays of the geometries,
    so that shapely's functions and ``GeoSeries(...)`` take it.

    Attributes
    ----------
    geometries : ndarray of object
        Shapely's geometries. Read-only.
    sources : Lists
        Per geometry the items, ascending: positions in the input; where that is a single
        collection, in its parts.
    """

    def __init__(self, geometries: NDArray[np.object_], sources: Lists, kind: str) -> None:
        self.geometries = geometries.view()
        self.geometries.flags.writeable = False
        self.sources = sources
        self._kind = kind

    @cached
    def geometry(self) -> Any:
        """All in one, as shapely's function returns it: a MultiLineString or a
        GeometryCollection."""
        shapely = needed("shapely")
        return getattr(shapely, self._kind)(self.geometries)

    def __len__(self) -> int:
        return len(self.geometries)

    @overload
    def __getitem__(self, i: int) -> Any: ...
    @overload
    def __getitem__(self, i: slice) -> list[Any]: ...
    def __getitem__(self, i: int | slice) -> Any:
        return list(self.geometries[i]) if isinstance(i, slice) else self.geometries[i]

    def __iter__(self) -> Iterator[Any]:
        return iter(self.geometries)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[np.object_]:
        if dtype is not None and np.dtype(dtype) != object:
            raise TypeError(f"geometries are objects, not {dtype}")
        return self.geometries.copy() if copy else self.geometries

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name in ("geometries", "sources", "geometry"):
            raise AttributeError(name)
        return getattr(self.geometry, name)

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        interface: dict[str, Any] = self.geometry.__geo_interface__
        return interface

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Sourced):
            return bool(self.geometry == other.geometry) and self.sources == other.sources
        return bool(self.geometry == other)

    def __hash__(self) -> int:
        return hash(self.geometry)

    def __reduce__(self) -> tuple[Any, ...]:
        return Sourced, (self.geometries, self.sources, self._kind)

    def __repr__(self) -> str:
        return repr(self.geometry)

    def __str__(self) -> str:
        return str(self.geometry)
