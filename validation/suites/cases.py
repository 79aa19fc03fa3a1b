"""Cases of other libraries' test suites for regions, with exact numbers.

A layer is a list of shapes; a shape is a list of rings, which have one winding number together; a
ring is a list of points, whose coordinates are texts as the file has them. Doubles of binary files
are the numbers that they are.
"""

from __future__ import annotations

import json
import re
import struct
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from dataclasses import dataclass, field
from decimal import Decimal
from pathlib import Path
from typing import Any

Point = tuple[str, str]
Ring = list[Point]
Layer = list[list[Ring]]

OPERATIONS = ("intersection", "union", "difference", "symmetric_difference")


@dataclass
class Case:
    """What a suite expects of two layers, or only the layers."""

    name: str
    a: Layer
    b: Layer
    operation: str
    rule: str = "evenodd"
    expected: list[Layer] = field(default_factory=list)  # any of these
    area: str | None = None
    rings: int | None = None  # of the result
    valid: bool | None = None  # whether `text` is, for the operation "valid"
    text: str = ""
    note: str = ""  # of the file, on what it expects
    rounded_to_one: bool = False  # whether results have integers for corners


class Unread(Exception):
    """What is not about areas."""


def cases_of(suite: Path) -> Iterator[Case | str]:
    """The cases of a folder, by file; texts for what is none, with the reason."""
    readers = {".xml": jts, ".geojson": geojson, ".json": ioverlay, ".txt": clipper}
    for file in sorted(suite.iterdir()):
        if file.suffix in readers:
            yield from readers[file.suffix](file)


# JTS and GEOS: XML.

JTS_OPERATIONS = {
    "intersection": ("intersection",),
    "union": ("union",),
    "difference": ("difference",),
    "symdifference": ("symmetric_difference",),
    "intersectionng": ("intersection",),
    "unionng": ("union",),
    "differenceng": ("difference",),
    "symdifferenceng": ("symmetric_difference",),
    "overlayareatest": OPERATIONS,
    "areatest": OPERATIONS,
    "unionarea": ("union",),
    "isvalid": ("valid",),
}


def jts(file: Path) -> Iterator[Case | str]:
    for number, case in enumerate(ElementTree.parse(file).getroot().iter("case"), 1):
        name = f"{file.name} {number}"
        for op in case.iter("op"):
            kind = op.get("name", "").lower()
            if kind not in JTS_OPERATIONS:
                yield f"{name}: {kind} is not about areas"
                continue
            try:
                yield from _jts_cases(name, case, op, kind)
            except Unread as reason:
                yield f"{name}: {kind}: {reason}"


def _jts_cases(name: str, case: Any, op: Any, kind: str) -> Iterator[Case]:
    def operand(which: str | None) -> Layer:
        text = case.findtext(which.lower()) if which else None
        return geometry(text) if text and text.strip() else []

    a = operand(op.get("arg1", "a"))
    b = operand(op.get("arg2")) if kind != "isvalid" else []
    value = (op.text or "").strip()
    for operation in JTS_OPERATIONS[kind]:
        made = Case(name, a, b, operation)
        if operation == "valid":
            made.valid = value == "true"
            made.text = (case.findtext(op.get("arg1", "a").lower()) or "").strip()
        elif kind == "unionarea":
            made.area = value
        elif value and not kind.endswith("areatest"):
            made.expected = [geometry(value)]
        yield made


def geometry(text: str) -> Layer:
    """The polygons of WKT, or of WKB in hexadecimals."""
    text = text.strip()
    if re.fullmatch(r"[0-9A-Fa-f\s]+", text):
        return Wkb(bytes.fromhex("".join(text.split()))).layer()
    return wkt(text)


def wkt(text: str) -> Layer:
    """The polygons of WKT: an error where there are points or lines, too."""
    upper = re.sub(r",\s*EMPTY|EMPTY\s*,", "", text.upper())
    if re.search(r"POINT|LINE", upper):
        raise Unread("it has points or lines")
    polygons = re.findall(r"\(\s*\([^()]+\)(?:\s*,\s*\([^()]+\))*\s*\)", upper)
    return [[_points(ring) for ring in re.findall(r"\(([^()]+)\)", p)] for p in polygons]


def _points(text: str) -> Ring:
    pairs = [pair.split() for pair in text.split(",")]
    return [(pair[0], pair[1]) for pair in pairs if len(pair) >= 2]


class Wkb:
    """Reads well-known binary from its beginning."""

    def __init__(self, data: bytes) -> None:
        self.data, self.at = data, 0

    def _take(self, form: str) -> Any:
        values = struct.unpack_from(form, self.data, self.at)
        self.at += struct.calcsize(form)
        return values

    def layer(self) -> Layer:
        order = "<" if self._take("B")[0] else ">"
        (kind,) = self._take(order + "I")
        has_z, has_srid = kind & 0x80000000, kind & 0x20000000
        if has_srid:
            self._take(order + "I")
        width = 3 if has_z or (kind & 0xFFFF) // 1000 == 1 else 2
        kind = (kind & 0xFFFF) % 1000
        (count,) = self._take(order + "I")
        if kind == 3:
            return [[self._ring(order, width) for _ in range(count)]]
        if kind in (6, 7):
            return [shape for _ in range(count) for shape in self.layer()]
        raise Unread("it has points or lines")

    def _ring(self, order: str, width: int) -> Ring:
        (count,) = self._take(order + "I")
        values = self._take(f"{order}{count * width}d")
        points = zip(values[::width], values[1::width])
        return [(str(Decimal(x)), str(Decimal(y))) for x, y in points]


# GeoJSON: a feature for each operand, and of Martinez for each result.

MARTINEZ = {
    "intersection": "intersection",
    "union": "union",
    "diff": "difference",
    "xor": "symmetric_difference",
}


def geojson(file: Path) -> Iterator[Case | str]:
    data = json.loads(file.read_text(), parse_float=str, parse_int=str)
    features = data.get("features", [data])
    operands: list[Layer] = []
    results: list[tuple[str, Layer, str]] = []
    try:
        for feature in features:
            layer = _geojson_layer(feature.get("geometry", feature))
            properties = feature.get("properties") or {}
            operation = properties.get("operation")
            if operation in MARTINEZ:
                results.append((MARTINEZ[operation], layer, properties.get("comment", "")))
            else:
                operands.append(layer)
    except Unread as reason:
        yield f"{file.name}: {reason}"
        return
    if results:
        for operation, expected, note in results:
            a, b = operands
            yield Case(file.name, a, b, operation, expected=[expected], note=note)
        return
    # Of more than two operands the first against the others, which are together for the library.
    rest = [shape for layer in operands[1:] for shape in layer]
    for operation in OPERATIONS:
        yield Case(file.name, operands[0], rest, operation)


def _geojson_layer(geometry: Any) -> Layer:
    if geometry is None:
        return []
    if geometry["type"] == "Polygon":
        polygons = [geometry["coordinates"]]
    elif geometry["type"] == "MultiPolygon":
        polygons = geometry["coordinates"]
    else:
        raise Unread("it has points or lines")
    return [[[(p[0], p[1]) for p in ring] for ring in rings] for rings in polygons]


# iOverlay: JSON.

RULES = ("evenodd", "nonzero", "positive", "negative")
IOVERLAY = {
    "union": "union",
    "intersect": "intersection",
    "difference": "difference",
    "xor": "symmetric_difference",
    "inverseDifference": "inverse",
    "subject": "subject",
    "clip": "clip",
}


def ioverlay(file: Path) -> Iterator[Case | str]:
    data = json.loads(file.read_text(), parse_float=str)
    if "subjPaths" not in data:
        yield f"{file.name}: polygons cut by lines are faces, not regions"
        return
    subject, clip = ([_path(ring) for ring in data[k]] for k in ("subjPaths", "clipPaths"))
    for key, operation in IOVERLAY.items():
        a, b = [subject], [clip]
        if operation == "inverse":
            a, b, operation = b, a, "difference"
        elif operation in ("subject", "clip"):
            a, b, operation = (a if operation == "subject" else b), [], "union"
        expected = [[[_path(r) for r in shape] for shape in choice] for choice in data[key]]
        yield Case(
            f"{file.name} {key}",
            [s for s in a if s],
            [s for s in b if s],
            operation,
            RULES[data["fillRule"]],
            expected,
            rounded_to_one=True,
        )


def _path(ring: Any) -> Ring:
    return [(str(x), str(y)) for x, y in ring]


# Clipper2: texts of blocks.

CLIPPER = {
    "INTERSECTION": "intersection",
    "UNION": "union",
    "DIFFERENCE": "difference",
    "XOR": "symmetric_difference",
}


def clipper(file: Path) -> Iterator[Case | str]:
    blocks = re.split(r"(?m)^CAPTION:", file.read_text())[1:]
    for block in blocks:
        lines = [line.strip() for line in block.splitlines()]
        name = f"{file.name} {lines[0].rstrip('. ')}"
        values = dict(re.findall(r"(?m)^(CLIPTYPE|FILLRULE|SOL_AREA|SOL_COUNT): *(\S+)", block))
        if "SUBJECTS_OPEN" in lines:
            yield f"{name}: it has open lines"
            continue
        if values["CLIPTYPE"] not in CLIPPER:
            yield f"{name}: {values['CLIPTYPE']}"
            continue
        paths: dict[str, list[Ring]] = {"SUBJECTS": [], "CLIPS": []}
        into: list[Ring] | None = None
        for line in lines[1:]:
            if line in paths:
                into = paths[line]
            elif into is not None and line:
                numbers = re.findall(r"-?\d+", line)
                into.append(list(zip(numbers[::2], numbers[1::2])))
        area, count = values.get("SOL_AREA", "-1"), int(values.get("SOL_COUNT", "-1"))
        yield Case(
            name,
            [paths["SUBJECTS"]],
            [paths["CLIPS"]] if paths["CLIPS"] else [],
            CLIPPER[values["CLIPTYPE"]],
            values["FILLRULE"].lower(),
            area=None if area == "-1" else area,
            rings=None if count == -1 else count,
            rounded_to_one=True,
        )
