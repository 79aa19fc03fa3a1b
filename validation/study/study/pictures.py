"""Pictures of the report, as SVG: the same bytes from the same results."""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from textwrap import fill

import matplotlib

matplotlib.use("svg")

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from study import responses, tables
from study.tables import Engine, Study
from study.words import LOUD, OUTCOMES, RIGHT, SILENT

_COLOURS = {
    "error": "#c6c6c6",
    "crash": "#737373",
    "timeout": "#9e9ac8",
    "memory": "#54278f",
    "invalid": "#67000d",
    "topology": "#ef6548",
    "moved": "#9ecae1",
    "identical": "#3182bd",
}
_ROW, _COLUMN = 0.34, 0.34  # inches of a heat map's cell
_LINES = ("-", "--", ":", "-.")
_TILE_FONT, _TILE_LETTERS = 7, 38  # of titles of tiles, in a line
_DECADES_OF_TIME = 200  # points of a profile

matplotlib.rcParams.update(
    {
        "svg.hashsalt": "plumbline study",
        "svg.fonttype": "none",
        "font.family": "sans-serif",
        "font.size": 9,
        "axes.spines.top": False,
        "axes.spines.right": False,
    }
)


def pictures(study: Study) -> dict[str, str]:
    """SVG by name, of what there are results for."""
    found: dict[str, str] = {}
    makers: dict[str, Callable[[], Figure | None]] = {}
    for truth in study.truths:
        makers[f"silent_{truth}"] = partial(heat_map, study, truth)
        makers[f"outcomes_{truth}"] = partial(taxonomy, study, truth)
        makers[f"tolerance_{truth}"] = partial(tolerance_response, study, truth)
        makers[f"loud_{truth}"] = partial(loud_against_silent, study, truth)
    makers["times"] = partial(profile, study)
    for family in ("ulp map of a tee", "ulp map of a fan"):
        makers[family.replace(" ", "_")] = partial(ulp_map, study, family)
    for name, make in makers.items():
        figure = make()
        if figure is not None:
            found[f"{study.prefix}{name}"] = svg(figure)
            pyplot.close(figure)
    return found


def svg(figure: Figure) -> str:
    text = io.StringIO()
    figure.savefig(text, format="svg", bbox_inches="tight", metadata={"Date": None})
    # The version of matplotlib says nothing of the results.
    return re.sub(r"(?s)<metadata>.*?</metadata>\n? *", "", text.getvalue())


def heat_map(study: Study, truth: str) -> Figure | None:
    """Engines and families, share of silently wrong answers; a dot: none, with the bound 3/n below
    a hundredth; empty: no drawing."""
    shares = tables.silent_by_family(study, truth)
    engines = [e for e in study.engines if any(key[0] == e for key in shares)]
    families = [f for f in study.families if any(key[1] == f for key in shares)]
    if not engines:
        return None
    values = np.full((len(engines), len(families)), np.nan)
    size = (2 + _COLUMN * len(families), 1 + _ROW * len(engines))
    figure, axes = pyplot.subplots(figsize=size)
    for (engine, family), share in shares.items():
        i, j = engines.index(engine), families.index(family)
        values[i, j] = share.value
        text = f"{100 * share.value:.0f}" if share.k else ("·" if 3 / share.n < 0.01 else "")
        colour = "white" if share.value > 0.5 else "black"
        axes.text(j, i, text, ha="center", va="center", fontsize=7, color=colour)
    image = axes.imshow(values, cmap="Reds", vmin=0, vmax=1, aspect="auto")
    axes.set_facecolor("#e8e8e8")
    axes.set_xticks(range(len(families)), families, rotation=60, ha="right")
    axes.set_yticks(range(len(engines)), [study.of(e) for e in engines])
    axes.set_title(f"{study.subject}Silently wrong, per cent of drawings; truth: {truth}")
    figure.colorbar(image, ax=axes, shrink=0.8, pad=0.02)
    return figure


def taxonomy(study: Study, truth: str) -> Figure | None:
    """Shares of all outcomes, a bar for each engine."""
    numbers = tables.counts(study.fair(truth), tables.ENGINE)
    engines = [e for e in study.engines if e in numbers]
    if not engines:
        return None
    figure, axes = pyplot.subplots(figsize=(8, 1 + _ROW * len(engines)))
    left = np.zeros(len(engines))
    for outcome in OUTCOMES:
        widths = np.array([tables.share(numbers[e], (outcome,)).value for e in engines])
        axes.barh(range(len(engines)), widths, left=left, color=_COLOURS[outcome], label=outcome)
        left += widths
    axes.set_yticks(range(len(engines)), [study.of(e) for e in engines])
    axes.invert_yaxis()
    axes.set_xlim(0, 1)
    axes.set_xlabel("share of drawings")
    axes.set_title(f"{study.subject}What became of the drawings; truth: {truth}")
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), frameon=False)
    return figure


_NO_TOLERANCE = -15  # where the ratio 0 is drawn


def tolerance_response(study: Study, truth: str) -> Figure | None:
    """Shares of right and of silently wrong answers over tolerance / feature size, with Wilson
    bands of the former: a row of plots for each engine, grids first, a column for each group of
    families."""
    found = responses.Responses(study, truth)
    engines, groups = found.engines, found.groups
    if not engines:
        return None
    size = (2.5 + 1.7 * len(groups), 1.2 + 0.85 * len(engines))
    figure, grid = pyplot.subplots(
        len(engines), len(groups), figsize=size, sharex=True, sharey=True, squeeze=False
    )
    for row, engine in zip(grid, engines):
        for axes, group in zip(row, groups):
            response = found.of_group(group, engine)
            _line(axes, response, SILENT, _COLOURS["topology"], has_band=False)
            _line(axes, response, RIGHT, _COLOURS["identical"], has_band=True)
            axes.axvline(0, color="#888888", linewidth=0.7)
        title = found.titles[engine].replace(": ", ":\n", 1)
        row[0].set_ylabel(
            f"{title}\n({found.kinds[engine]})", rotation=0, ha="right", va="center", fontsize=8
        )
    for axes, group in zip(grid[0], groups):
        axes.set_title(group, fontsize=9)
    grid[0, 0].set_ylim(-0.05, 1.05)
    ticks = [_NO_TOLERANCE, -10, -5, 0]
    grid[0, 0].set_xticks(ticks, ["0", *(f"1e{k}" if k else "1" for k in ticks[1:])])
    figure.supxlabel("tolerance / least feature that was meant", y=0, fontsize=9)
    title = f"Drawings right (blue) and silently wrong (orange); truth: {truth}"
    figure.suptitle(f"{study.subject}{title}", y=1.0)
    figure.tight_layout()
    return figure


def _line(
    axes: Axes,
    response: responses.Response,
    outcomes: tuple[str, ...],
    colour: str,
    has_band: bool,
) -> None:
    """The ratio 0 stands apart, joined to no other."""
    shares = {r: responses.share(c, outcomes) for r, c in response.items()}
    if 0 in shares:
        share = shares.pop(0)
        if has_band:
            axes.vlines(_NO_TOLERANCE, *share.interval, color=colour, alpha=0.4)
        axes.plot(_NO_TOLERANCE, share.value, "o", markersize=2.5, color=colour)
    if not shares:
        return
    x = [float(np.log10(r)) for r in shares]
    if has_band:
        low, high = zip(*(s.interval for s in shares.values()))
        axes.fill_between(x, low, high, color=colour, alpha=0.2, linewidth=0)
    axes.plot(x, [s.value for s in shares.values()], linewidth=1.2, color=colour)


def loud_against_silent(study: Study, truth: str) -> Figure | None:
    """A point for each engine; versions of one with the same configuration are joined."""
    numbers = tables.counts(study.fair(truth), tables.ENGINE)
    if not numbers:
        return None
    figure, axes = pyplot.subplots(figsize=(6, 5))
    places: dict[tuple[str, str], list[tuple[float, float]]] = {}
    for k, engine in enumerate(e for e in study.engines if e in numbers):
        loud, silent = (tables.share(numbers[engine], o) for o in (LOUD, SILENT))
        x, y = 100 * silent.value, 100 * loud.value
        errors = [
            [[abs(v - 100 * bound)] for bound in s.interval] for v, s in ((x, silent), (y, loud))
        ]
        axes.errorbar(
            x, y, xerr=errors[0], yerr=errors[1], fmt="osD^v<>"[k // 10 % 7],
            color=f"C{k % 10}", markersize=5, linewidth=0.7, label=study.of(engine),
        )  # fmt: skip
        places.setdefault((engine[0], engine[3]), []).append((x, y))
    for points in places.values():
        if len(points) > 1:
            axes.plot(*zip(*points), color="#888888", linewidth=0.8, zorder=0)
    axes.set_xlabel("silently wrong, per cent of drawings")
    axes.set_ylabel("failed and said so, per cent")
    axes.set_xlim(left=-1)
    axes.set_ylim(bottom=-1)
    axes.set_title(f"{study.subject}Loud and silent; truth: {truth}")
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), frameon=False)
    return figure


def profile(study: Study) -> Figure | None:
    """Performance profile (Dolan and More 2002): of how many drawings an engine is right within so
    many times the best time; wrong answers count as none. Beside it time per n + K by size."""
    found = tables.times(study)
    if not found:
        return None
    best: dict[tuple[object, ...], float] = {}
    for of in found.values():
        for drawing, (seconds, _) in of.items():
            best[drawing] = min(seconds, best.get(drawing, seconds))
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.5))
    ratios = np.logspace(0, 5, _DECADES_OF_TIME)
    for k, (engine, of) in enumerate(found.items()):
        each = np.sort([seconds / best[drawing] for drawing, (seconds, _) in of.items()])
        shares = np.searchsorted(each, ratios, side="right") / len(best)
        style = {"color": f"C{k % 10}", "linestyle": _LINES[k // 10 % len(_LINES)]}
        left.plot(ratios, shares, label=study.of(engine), **style)
        x, y = _by_decade(of)
        right.plot(x, y, marker="o", markersize=3, **style)
    left.set_xscale("log")
    left.set_xlabel("times the best engine's time")
    left.set_ylabel("share of drawings that any engine got right")
    left.set_ylim(0, 1.02)
    right.set_xscale("log")
    right.set_yscale("log")
    right.set_xlabel("n + K: segments and vertices")
    right.set_ylabel("median microseconds per n + K")
    figure.legend(*left.get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(0.92, 0.9),
                  frameon=False)  # fmt: skip
    return figure


def _by_decade(of: dict[tuple[object, ...], tuple[float, int]]) -> tuple[list[float], list[float]]:
    groups: dict[int, list[float]] = {}
    for seconds, size in of.values():
        half_decade = round(2 * float(np.log10(size)))
        groups.setdefault(half_decade, []).append(1e6 * seconds / size)
    x = sorted(groups)
    return [10 ** (d / 2) for d in x], [float(np.median(groups[d])) for d in x]


def ulp_map(study: Study, family: str) -> Figure | None:
    """A tile for each engine: neighbours of an end point by outcome. In the first what is there,
    by numbers of faces; grey where no answer in doubles can be right."""
    rows = study.results.filter(pc.equal(study.results["family"], family))
    if not len(rows):
        return None
    faces, tiles = _tiles(rows)
    order = [e for e in study.engines if e in tiles]
    columns = min(5, len(order) + 1)
    lines = -(-(len(order) + 1) // columns)
    size = (2.4 * columns, 2.9 * lines + 0.8)
    figure, grid = pyplot.subplots(lines, columns, figsize=size, layout="constrained")
    flat = list(np.atleast_1d(grid).flat)
    for axes in flat:
        axes.set_axis_off()
    greens = pyplot.get_cmap("Greens").with_extremes(bad="#bbbbbb")
    least, most = np.nanmin(faces.all), np.nanmax(faces.all)
    flat[0].imshow(
        faces.fitting, cmap=greens, vmin=least - 1, vmax=most + 1, origin="lower",
        interpolation="nearest",
    )  # fmt: skip
    flat[0].set_title("exact: bounded faces\n" + _numbers(faces.all), fontsize=_TILE_FONT)
    colours = ListedColormap([_COLOURS[o] for o in OUTCOMES])
    norm = BoundaryNorm(np.arange(len(OUTCOMES) + 1) - 0.5, len(OUTCOMES))
    for axes, engine in zip(flat[1:], order):
        axes.imshow(tiles[engine], cmap=colours, norm=norm, origin="lower", interpolation="nearest")
        axes.set_title(fill(study.of(engine), _TILE_LETTERS), fontsize=_TILE_FONT)
    figure.legend(
        handles=[Patch(color=_COLOURS[o], label=o) for o in OUTCOMES],
        loc="outside lower center", ncols=min(len(OUTCOMES), 2 * columns), frameon=False,
    )  # fmt: skip
    side = len(faces.all)
    figure.suptitle(f"{family[0].upper()}{family[1:]}, {side} x {side} doubles")
    return figure


@dataclass(frozen=True)
class _Faces:
    """Numbers of bounded faces of a map's drawings: of all, and of those whose cells doubles
    hold."""

    all: np.ndarray
    fitting: np.ndarray


def _tiles(rows: pa.Table) -> tuple[_Faces, dict[Engine, np.ndarray]]:
    """What is there, and numbers of outcomes by engine: of each its largest map, if it is whole."""
    side = max(rows["size"].to_pylist())
    names = (*tables.ENGINE, "size", "seed", "outcome", "exact_faces", "fits_doubles")
    largest: dict[Engine, np.ndarray] = {}
    faces = _Faces(np.full((side, side), np.nan), np.full((side, side), np.nan))
    for *named, own, seed, outcome, exact, fits in zip(*(rows[n].to_pylist() for n in names)):
        tile = largest.get(tuple(named))
        if tile is None or len(tile) < own:
            tile = largest[tuple(named)] = np.full((own, own), np.nan)
        if len(tile) == own:
            tile[divmod(seed, own)] = OUTCOMES.index(outcome)
        if own == side:
            place = divmod(seed, side)
            faces.all[place], faces.fitting[place] = exact, exact if fits else np.nan
    return faces, {e: tile for e, tile in largest.items() if not np.isnan(tile).any()}


def _numbers(faces: np.ndarray) -> str:
    values, counts = np.unique(faces[~np.isnan(faces)], return_counts=True)
    return ", ".join(f"{int(v)} of {c}" for v, c in zip(values, counts))


assert set(_COLOURS) == set(OUTCOMES) == {*LOUD, *SILENT, *RIGHT}
