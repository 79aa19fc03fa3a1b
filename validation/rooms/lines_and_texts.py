"""What a drawing has, read without Plumbline: segments, whether some stand for curves, texts with their places, the lines
of named closed elements, and metres per unit where the file says so."""
import collections
import dataclasses
import json
import math
import pathlib
import xml.etree.ElementTree as xml

import ezdxf.path
import ezdxf.recover
import shapely

METRES = {1: 0.0254, 2: 0.3048, 4: 0.001, 5: 0.01, 6: 1.0, 14: 0.1}  # of $INSUNITS
TEXTS = {"TEXT", "MTEXT", "ATTRIB"}
UNDRAWN = {"DIMENSION", "LEADER", "HATCH", "VIEWPORT", "ATTDEF", "POINT", "ACAD_PROXY_ENTITY", "WIPEOUT", "IMAGE"}


@dataclasses.dataclass
class Drawing:
    segments: list = dataclasses.field(default_factory=list)  # pairs of points
    has_curves: bool = False
    texts: list = dataclasses.field(default_factory=list)  # (words, point)
    named: list = dataclasses.field(default_factory=list)  # (words, polygon)
    metres: float = 0
    skipped: collections.Counter = dataclasses.field(default_factory=collections.Counter)

    def chain(self, points):
        points = [(p[0], p[1]) for p in points]
        self.segments += [(p, q) for p, q in zip(points, points[1:]) if p != q]

    def ring(self, points):
        self.chain([*points, points[0]])


class Dxf:
    def __init__(self, path, sagitta):
        self.sagitta, self.drawing = sagitta, Drawing()
        document, _ = ezdxf.recover.readfile(path)
        self.drawing.metres = METRES.get(document.header.get("$INSUNITS", 0), 0)
        self.layers = {layer.dxf.name.lower(): layer for layer in document.layers}
        for entity in document.modelspace():
            self.add(entity, "0")

    def is_hidden(self, layer):
        found = self.layers.get(layer.lower())
        return layer.lower() == "defpoints" or found is not None and (
            found.is_off() or found.is_frozen() or found.dxf.get("plot", 1) == 0)

    def add(self, entity, outer):
        """`outer` is the layer of the insert around it, on which things of layer 0 are."""
        layer, kind = entity.dxf.layer, entity.dxftype()
        if layer == "0":
            layer = outer
        if entity.dxf.get("invisible", 0):
            return
        if kind == "INSERT":
            found = self.layers.get(layer.lower())
            if found is not None and found.is_frozen():
                return
            for copy in entity.multi_insert() if entity.mcount > 1 else [entity]:
                for inner in [*copy.virtual_entities(), *copy.attribs]:
                    self.add(inner, layer)
        elif self.is_hidden(layer) or kind in TEXTS and getattr(entity, "is_invisible", False):
            self.drawing.skipped["hidden"] += 1
        elif kind in TEXTS:
            self.add_text(entity)
        elif kind in UNDRAWN:
            self.drawing.skipped[kind] += 1
        else:
            self.add_lines(entity)

    def add_text(self, text):
        if text.dxftype() == "MTEXT":
            words, place = text.plain_text(), text.dxf.insert
        else:
            words, place = text.plain_text(), text.get_placement()[1]
            place = text.ocs().to_wcs(place)
        self.drawing.texts.append((" ".join(words.split()), (place.x, place.y)))

    def add_lines(self, entity):
        kind = entity.dxftype()
        if kind == "LINE":
            self.drawing.chain([entity.dxf.start, entity.dxf.end])
        elif kind in ("SOLID", "TRACE", "3DFACE"):
            self.drawing.ring(entity.wcs_vertices())
        elif kind == "MLINE":
            for part in entity.virtual_entities():
                self.add_lines(part)
        elif kind == "LWPOLYLINE" and not entity.has_arc:
            points = list(entity.vertices_in_wcs())
            self.drawing.chain(points + points[:1] if entity.closed else points)
        elif kind == "POLYLINE" and not entity.has_arc and not entity.is_poly_face_mesh:
            points = list(entity.points_in_wcs())
            self.drawing.chain(points + points[:1] if entity.is_closed else points)
        else:
            path = ezdxf.path.make_path(entity)
            self.drawing.has_curves = self.drawing.has_curves or path.has_curves
            self.drawing.chain(path.flattening(self.sagitta))


def read_geojson(path):
    """Polygons, with the property `name`."""
    drawing = Drawing()
    for feature in json.loads(pathlib.Path(path).read_text())["features"]:
        properties = {key.lower(): value for key, value in (feature.get("properties") or {}).items()}
        name = properties.get("name")
        for polygon in shapely.get_parts(shapely.geometry.shape(feature["geometry"])):
            for ring in [polygon.exterior, *polygon.interiors]:
                drawing.chain(ring.coords)
            if name:
                drawing.named.append((name, polygon))
    return drawing


def read_structure(path):
    """A LAR structure of models with V and FV, translations and scalings, which act on what follows them."""
    file, drawing = json.loads(pathlib.Path(path).read_text()), Drawing()

    def walk(item, scale, shift):
        if "V" in item:
            points = [[s * c + t for s, c, t in zip(scale, v, shift)] for v in item["V"]]
            for face in item["FV"]:
                drawing.ring([points[i] for i in face])
            return
        for part in item["body"]:
            if "ref" in part:
                walk(file["defs"][part["ref"]], scale, shift)
            elif part["op"] == "t":
                shift = [t + s * a for s, a, t in zip(scale, part["args"], shift)]
            elif part["op"] == "s":
                scale = [s * a for s, a in zip(scale, part["args"])]
            else:
                raise ValueError(part["op"])

    walk(file["defs"][file["root"]], [1, 1], [0, 0])
    return drawing


def read_svg(path):
    """Rectangles, lines, polygons and texts that nothing transforms; a shape's title or id is its name."""
    drawing, space = Drawing(), "{http://www.w3.org/2000/svg}"
    for element in xml.parse(path).getroot().iter():
        number = lambda name: float(element.get(name, 0))
        if "transform" in element.attrib:
            raise ValueError("transform")
        kind = element.tag.removeprefix(space)
        if kind == "text":
            drawing.texts.append((" ".join("".join(element.itertext()).split()), (number("x"), number("y"))))
            continue
        if kind == "line":
            points = [(number("x1"), number("y1")), (number("x2"), number("y2"))]
        elif kind == "rect":
            x, y, w, h = map(number, ("x", "y", "width", "height"))
            points = [(x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y)]
        elif kind in ("polygon", "polyline"):
            numbers = list(map(float, element.get("points").replace(",", " ").split()))
            points = list(zip(numbers[::2], numbers[1::2]))
            points += points[:1] if kind == "polygon" else []
        elif kind in ("path", "circle", "ellipse", "use", "image"):
            raise ValueError(kind)
        else:
            continue
        drawing.chain(points)
        title = element.find(space + "title")
        name = title.text if title is not None else element.get("id")
        if name and points[0] == points[-1]:
            drawing.named.append((name, shapely.Polygon(points)))
    return drawing


def read(path, sagitta):
    ending = pathlib.Path(path).suffix.lower()
    if ending == ".dxf":
        return Dxf(path, sagitta).drawing
    return {".geojson": read_geojson, ".json": read_structure, ".svg": read_svg}[ending](path)


def extent(drawing):
    points = [p for segment in drawing.segments for p in segment]
    return max((max(axis) - min(axis) for axis in zip(*points)), default=math.nan)
