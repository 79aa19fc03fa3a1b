"""The rooms of a plan."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, overload

from plumbline import _core
from plumbline._cached import cached
from plumbline._joined import joined_arrangement
from plumbline._notebook import drawn, framed
from plumbline._numbers import Number, Numbers
from plumbline._progress import Progress
from plumbline._sizes import Unit, names, optional_size, unit_of
from plumbline._tables import to_geodataframe
from plumbline._whole import optional_count, threads_of
from plumbline.arrangement import Arrangement, arrange
from plumbline.errors import Error
from plumbline.line_inputs import lines
from plumbline.lines import Lines, LinesLike

if TYPE_CHECKING:
    from fractions import Fraction

    import networkx
    from geopandas import GeoDataFrame


class Rooms(Sequence[_core.Room]):
    """The rooms of a drawing, from left to right, and what was left out.

    Made by `plumbline.rooms`. A sequence of rooms: each has ``name``, ``names``, ``layers``,
    ``area`` and ``gross_area`` (Fractions, in drawing units squared), ``perimeter``, ``width``,
    ``middle``, ``depth``, ``parent``, ``neighbours`` and ``face``, its index in `arrangement`.
    Indices of rooms count from 0, as in Python; what is written for people numbers them from 1.

    Attributes
    ----------
    arrangement : Arrangement
        What the rooms are faces of. Where printed doubles left walls apart by their last digit, the
        arrangement of the drawing with these places joined, of lines of its own, which have the
        items of the drawing's.
    joined : int
        How many such places there were.

    See Also
    --------
    plumbline.rooms
    """

    def __init__(
        self,
        core: _core.Rooms,
        complex: _core.Complex,
        arrangement: Arrangement,
        joined: int,
        made_of: tuple[Any, ...],
    ) -> None:
        self._core = core
        self._complex = complex  # of the arrangement, with the segments of `lines`
        self.arrangement = arrangement
        self.joined = joined
        self._made_of = made_of

    def __len__(self) -> int:
        return len(self._rooms)

    @overload
    def __getitem__(self, i: int) -> _core.Room: ...
    @overload
    def __getitem__(self, i: slice) -> list[_core.Room]: ...
    def __getitem__(self, i: int | slice) -> _core.Room | list[_core.Room]:
        return self._rooms[i]

    def __iter__(self) -> Iterator[_core.Room]:
        return iter(self._rooms)

    @cached
    def _rooms(self) -> list[_core.Room]:
        return self._core.rooms

    @property
    def lines(self) -> Lines:
        """The lines that bound rooms, with the labels of the whole drawing."""
        lines: Lines = self._made_of[0]
        return lines

    @property
    def min_area(self) -> Fraction:
        """The least area of a room, as applied."""
        return self._core.min_area

    @property
    def min_width(self) -> Fraction:
        """The least width of a room, as applied."""
        return self._core.min_width

    @property
    def narrow(self) -> int:
        """How many bounded faces are no rooms because no circle of `min_width` fits in."""
        return self._core.narrow

    @property
    def small(self) -> int:
        """How many are wide enough, but not of `min_area`."""
        return self._core.small

    @property
    def unit(self) -> _core.LengthUnit | None:
        """The unit of length, as used."""
        return self._core.unit

    @property
    def doubted(self) -> _core.LengthUnit | None:
        """The unit that the drawing says, where that would make it tiny, and it is not believed."""
        return self._core.doubted

    @cached
    def outside(self) -> list[_core.Label]:
        """Labels in no room."""
        labels = self.lines.labels
        return [labels[i] for i in self._core.outside]

    # Forms.

    def to_text(self, listed: int | None = None) -> str:
        """A table: the largest rooms, `listed` of them, or as many as fit on a screen."""
        return self._core.to_text(self.lines._core, optional_count(listed, "listed"))

    def to_json(self) -> str:
        """All of it as JSON, as docs/rooms.schema.json describes it."""
        return self._core.to_json(self.lines._core)

    def to_svg(self) -> str:
        """A plan: rooms in colours, different ones beside each other, with number, name, area."""
        return self._core.to_svg(self.lines._core, self._complex)

    def to_html(self) -> str:
        """A page with the plan and a list to search and to sort; it loads nothing else."""
        return self._core.to_html(self.lines._core, self._complex)

    @cached
    def _table(self) -> _core.Table:
        return self._core.table(self.lines._core, self._complex, 0)

    def to_geopandas(self) -> GeoDataFrame:
        """A GeoDataFrame of valid polygons with doubles that are proven to be a partition.

        Columns: ``room`` (its number, from 1), ``name`` (all names, "; " between), ``area``
        (rounded) and ``area_exact`` (text), ``area_m2`` where the unit is known, ``perimeter``,
        ``layers``, ``depth``, ``parent``, ``neighbours`` and ``doors`` (numbers), ``face``. A room
        that rounding parts has a row for each part. Needs geopandas.
        """
        return to_geodataframe(self._table, self.lines.crs)

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        collection: dict[str, Any] = json.loads(self._table.written("geojson"))
        return collection

    def to_networkx(self) -> networkx.Graph[int]:
        """Which rooms are beside each other, as a graph. Needs networkx.

        Nodes are indices of rooms, with ``number`` (from 1), ``name``, ``names``, ``layers``,
        ``area`` (float), ``pos``. Edges have ``shared`` and ``across``, lengths of common sides and
        of sides that face each other across a wall, and ``door``.

        Examples
        --------
        >>> import plumbline
        >>> plan = [(0, 0, 9, 0), (9, 0, 9, 3), (9, 3, 0, 3), (0, 3, 0, 0), (4, 0, 4, 3)]
        >>> plumbline.rooms(plan).to_networkx().edges(data="shared")
        EdgeDataView([(0, 1, 3.0)])
        """
        try:
            import networkx
        except ImportError as error:
            raise ImportError(
                'this needs networkx: pip install "plumbline-geometry[graph]"'
            ) from error
        graph: networkx.Graph[int] = networkx.Graph()
        for i, room in enumerate(self):
            graph.add_node(
                i,
                number=i + 1,
                name=room.name,
                names=room.names,
                layers=room.layers,
                area=float(room.area),
                pos=room.middle,
            )
        for i, room in enumerate(self):
            for other in room.neighbours:
                graph.add_edge(
                    i, other.room, shared=other.shared, across=other.across, door=other.door
                )
        return graph

    def _written(self, format: str, **options: Any) -> str | bytes:
        """The content of a file: what `plumbline.write` asks for."""
        if options:
            raise Error(f"rooms are written without options: {', '.join(options)}")
        if format == "json":
            return self.to_json()
        if format == "svg":
            return self.to_svg()
        if format == "html":
            return self.to_html()
        if format in ("geojson", "topojson", "dxf", "wkt", "csv", "wkb"):
            return self._table.written(format)
        raise Error(
            "rooms are written as geojson, topojson, dxf, wkt, csv, wkb, json, svg or html: "
            f"{format!r}"
        )

    def _repr_svg_(self) -> str | None:
        return drawn(self.to_svg())

    def _repr_html_(self) -> str | None:
        return framed(self.to_html())

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, self._made_of

    def __str__(self) -> str:
        return self.to_text()

    def __repr__(self) -> str:
        count = "1 room" if len(self) == 1 else f"{len(self)} rooms"
        area = float(sum(room.area for room in self))
        return f"<Rooms: {count}, area {area:.6g}, narrower faces {self.narrow}>"


def _made(
    of: Lines,
    min_area: str | None,
    min_width: str | None,
    is_unit_given: bool,
    doors: list[str],
    threads: int | None = None,
    progress: Progress = None,
    known: _core.Complex | None = None,
) -> Rooms:
    """The rooms of lines, all of which bound rooms. `known` is their arrangement."""
    arrangement = Arrangement(known, of) if known is not None else None
    if arrangement is None:
        arrangement = arrange(of, threads=threads, progress=progress)
    exact = arrangement._core
    without_drift, joined, _ = _core.without_drift(of._core, exact, threads_of(threads))
    if without_drift is not None:
        exact = without_drift
        arrangement = joined_arrangement(of, exact)
    unit = of.unit if is_unit_given else None
    found = _core.rooms(of._core, exact, min_area, min_width, unit, doors)
    return Rooms(found, exact, arrangement, joined, (of, min_area, min_width, is_unit_given, doors))


def rooms(
    drawing: Arrangement | LinesLike,
    /,
    *,
    min_area: Number | None = None,
    min_width: Number | None = None,
    unit: Unit | None = None,
    doors: str | Sequence[str] = ("*door*",),
    walls: str | Sequence[str] = (),
    numbers: Numbers | None = None,
    threads: int | None = None,
    progress: Progress = None,
) -> Rooms:
    """The rooms of a plan: bounded faces that are large and wide enough, with names, areas and
    neighbours.

    Parameters
    ----------
    drawing : Arrangement, or whatever `lines` takes
        The plan. Texts in it name rooms: those of a face that is no room, as a box around a
        number, the room around it.
    min_area : number, optional
        A room's area is at least this, in drawing units squared. By default 0.5 m2; where there is
        no unit, 2.25 times the least width squared.
    min_width : number, optional
        A circle of this diameter fits into a room, which it does not into walls; in drawing units.
        By default 0.5 m; where there is no unit, what parts the widths of faces most clearly.
    unit : str or number, optional
        What a drawing unit is, whatever the drawing says: "mm", "cm", "dm", "m", "km", "in", "ft",
        or a number of metres. By default what the drawing says, which is not believed where it
        makes the drawing less than 3 m long.
    doors : sequence of str
        Layers whose lines are doors; ``*`` and ``?`` stand for any characters, in any case.
    walls : sequence of str
        Layers whose lines bound rooms, all by default. Texts of all layers are read.
    numbers : {"doubles", "decimals"}, optional
        What floats stand for, as in `lines`.
    threads : int, optional
        As in `plumbline.arrange`.
    progress : bool or function, optional
        As in `arrange`.

    Returns
    -------
    Rooms
        By face, from left to right. Areas are exact; lengths and widths are rounded.

    Raises
    ------
    Error
        For a negative size, another unit, a layer that the drawing does not have; as `lines`.

    Notes
    -----
    O(E log E) for E edges, beside the arrangement. Where the digits of printed doubles leave walls
    apart by 1e-13, these places are joined first, within the rounding of the numbers: see
    `Rooms.joined`.

    Examples
    --------
    >>> import plumbline
    >>> plan = [(0, 0, 9, 0), (9, 0, 9, 3), (9, 3, 0, 3), (0, 3, 0, 0), (4, 0, 4, 3)]
    >>> found = plumbline.rooms(plan, unit="m")
    >>> [room.area for room in found]
    [Fraction(12, 1), Fraction(15, 1)]
    >>> found[0].neighbours[0].shared
    3.0
    """
    sizes = optional_size("min_area", min_area), optional_size("min_width", min_width)
    of = lines(drawing.lines if isinstance(drawing, Arrangement) else drawing, numbers=numbers)
    chosen = names(walls)
    if chosen:
        of = of.on_layers(*chosen)
    if unit is not None:
        of = Lines(_core.with_unit(of._core, unit_of(unit)), of.numbers)
    known = drawing.exact._core if isinstance(drawing, Arrangement) and not chosen else None
    return _made(of, *sizes, unit is not None, names(doors), threads, progress, known)
