"""Results are whole and once; a report depends on them alone."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from study import responses, results
from study.dice import Dice
from study.words import OUTCOMES, TRUTHS

pytest.importorskip("matplotlib")

from study.agreement import agreement
from study.pictures import ulp_map
from study.report import files
from study.summary import in_page, summary
from study.tables import Study, differences, family_table, nearness, orders, silent_by_family


def row(engine: str, family: str, seed: int, truth: str, outcome: str, **more: Any) -> results.Row:
    base: results.Row = dict.fromkeys(results.SCHEMA.names)
    is_map = family.startswith("ulp")
    return base | {
        "engine": engine,
        "version": "1.0",
        "configuration": f"{engine}-c",
        "group": "ulp maps" if is_map else "campaign",
        "family": family,
        "size": 3 if is_map else 12,
        "scale": "unit",
        "seed": seed,
        "order": 0,
        "truth": truth,
        "title": engine.upper(),
        "algorithm": "same",
        "configuration_title": f"<{engine}>",
        "tolerance_kind": "snap",
        "tolerance": 1e-6,
        "source": "its manual",
        "segments": 12,
        "exact_vertices": 20,
        "exact_edges": 30,
        "exact_faces": seed % 2,
        "feature_size": 10.0 ** -(seed % 9),
        "fits_doubles": True,
        "both_engines": seed % 2 == 0,
        "outcome": outcome,
        "kind": "face lost" if outcome == "topology" else "",
        "faces_wrong": 1,
        "area": 0.5,
        "answer": outcome,
        "seconds": 0.001 * (seed + 1),
        **more,
    }


def made() -> list[results.Row]:
    dice = Dice("rows of the test")
    rows = [
        row(engine, family, seed, truth, OUTCOMES[dice.between(0, len(OUTCOMES) - 1)])
        for engine in ("a", "b")
        for family in ("lattice", "rings", "ulp map of a tee")
        for seed in range(9)
        for truth in (TRUTHS if family != "ulp map of a tee" else ("doubles",))
    ]
    swept = [
        row("a", "plan", seed, "doubles", outcome, ratio=ratio)
        for ratio, outcome in ((0.0, "moved"), (1e-12, "identical"), (1.0, "invalid"))
        for seed in range(9)
    ]
    return (
        rows
        + swept
        + [row("a", "rings", 1, "doubles", "identical", order=k, answer=str(k)) for k in (1, 2)]
    )


def study_of(rows: list[results.Row]) -> Study:
    return Study(results.sorted_once(pa.Table.from_pylist(rows, schema=results.SCHEMA)))


def test_a_report_is_the_same_bytes_twice_and_in_any_order_of_rows() -> None:
    rows = made()
    first = files(study_of(rows))
    Dice("another order").shuffle(rows)
    second = files(study_of(rows))
    assert first.keys() == second.keys()
    assert [name for name in first if first[name] != second[name]] == []
    assert {
        "study.md",
        "index.html",
        "overview.csv",
        "silent_doubles.svg",
        "times.svg",
        "tolerance_doubles.svg",
    } <= set(first)
    assert "&lt;a&gt;" in first["index.html"] and "<a>" not in first["index.html"]


def test_titles_of_a_map_are_apart() -> None:
    rows = [
        row(engine, "ulp map of a tee", seed, "doubles", "moved", configuration_title=title)
        for engine, title in (("a", "a configuration that is told in many words " * 2), ("b", "b"))
        for seed in range(9)
    ]
    figure = ulp_map(study_of(rows), "ulp map of a tee")
    assert figure is not None
    figure.draw_without_rendering()
    texts = [axes.title for axes in figure.axes if axes.title.get_text()]
    texts += [*figure.texts, *(figure.legends[0].get_texts())]
    boxes = [text.get_window_extent() for text in texts]
    assert len(boxes) == 3 + 1 + len(OUTCOMES)
    assert not [1 for k, box in enumerate(boxes) if box.count_overlaps(boxes[:k])]
    assert all(figure.bbox.containsx(x) for box in boxes for x in (box.x0, box.x1))


def test_agreement_counts_cells_within_intervals() -> None:
    def of(silent: int, count: int) -> Study:
        wrong = ["topology"] * silent + ["moved"] * (count - silent)
        return study_of([row("a", "rings", s, "doubles", o) for s, o in enumerate(wrong)])

    def counts(first: Study, second: Study) -> list[tuple[Any, ...]]:
        return [found[1:] for found in agreement(first, second).rows]

    assert counts(of(2, 10), of(3, 10)) == [(1, 1, 1, 1)] * 2
    assert counts(of(0, 4), of(10, 10)) == [(1, 0, 0, 0)] * 2
    assert counts(of(2, 4), of(80, 100)) == [(1, 1, 0, 1)] * 2
    assert agreement(of(0, 4), study_of([])).rows == [
        (name, 0, 0, 0, 0) for name in ("doubles", "all")
    ]
    assert "agreement.csv" in files(of(2, 10), of(3, 10))


def test_a_summary_has_the_best_configuration_of_each_engine() -> None:
    rows = [row("a", "rings", s, "doubles", "identical") for s in range(4)]
    worse = {"configuration": "a-d", "configuration_title": "worse"}
    rows += [row("a", "rings", s, "doubles", "topology", **worse) for s in range(4)]
    rows += [row("b", "rings", s, "doubles", "error" if s else "moved") for s in range(4)]
    rows += [row("b", "rings", s, "intended", "moved", fits_doubles=s > 0) for s in range(4)]
    assert summary(study_of(rows)).splitlines()[2:] == [
        "| A 1.0: <a> | 4 | 100.0 (51.0-100.0) | <3/4 | <3/4 | - |",
        "| B 1.0: <b> | 4 | 25.0 (4.6-69.9) | <3/4 | 75.0 (30.1-95.4) | 100.0 (43.9-100.0) |",
    ]
    assert summary(study_of([])) == ""


def test_a_summary_is_put_between_the_marks_of_a_page() -> None:
    page = "before\n<!-- validation/study/report -->\n{}<!-- end -->\nafter <!-- end -->\n"
    once = in_page(page.format(""), "| \\1 |\n")
    assert once == page.format("\n| \\1 |\n\n") == in_page(once, "| \\1 |\n")
    for without in ("", page.split("<!-- end")[0], page.format("") * 2):
        with pytest.raises(ValueError, match="no place"):
            in_page(without, "")


def test_the_page_of_the_study_has_the_summary_beside_its_tables() -> None:
    root = Path(__file__).resolve().parents[3]
    page = (root / "docs/study.md").read_text(encoding="utf-8")
    told = (root / "validation/results/study/lines/summary.md").read_text(encoding="utf-8")
    assert in_page(page, told) == page


def test_shares_are_in_order_whatever_order_rows_have() -> None:
    rows = made()[::-1]
    shares = silent_by_family(Study(pa.Table.from_pylist(rows, schema=results.SCHEMA)), "doubles")
    assert len(shares) == 4 and list(shares) == sorted(shares)


def test_engines_of_rings_have_tables_of_their_own() -> None:
    ring = {"group": "rings", "perimeter": 8.0, "compare_tolerance": 0.25, "area": 3.0}
    rows = [row("c", "squares", s, "doubles", "moved", **ring) for s in range(9)]
    found = files(study_of(rows))
    assert not [
        name for name in found if not name.startswith(("rings_", "study.", "summary.", "index."))
    ]
    assert found["rings_areas.csv"].splitlines()[1] == "C 1.0: <c>,9,1.5,1.5,0,-,-"
    both = files(study_of([*rows, *made()]))
    assert both["rings_areas.csv"] == found["rings_areas.csv"]
    assert "squares" not in both["silent_doubles.csv"]


def test_results_are_gathered_once(tmp_path: Path) -> None:
    path = tmp_path / "folder" / "results.parquet"
    rows = made()
    results.write_piece(path, rows[:20])
    results.write_piece(path, rows[10:])
    table = results.gather(path)
    assert len(table) == len(rows)
    assert results.gather(path).equals(table)
    assert len(results.units_done(table)) == len({tuple(r[k] for k in results.UNIT) for r in rows})
    assert not list(path.parent.glob("*.pieces/*.parquet"))


def test_results_of_before_there_were_sweeps_are_read(tmp_path: Path) -> None:
    table = study_of([r for r in made() if r["ratio"] is None]).all
    old = tmp_path / "old.parquet"
    pq.write_table(table.drop_columns(["ratio"]), old)
    assert results.load(old).equals(table)
    results.write_piece(old, [row("a", "plan", 3, "doubles", "moved", ratio=0.5)])
    together = results.gather(old)
    assert len(together) == len(table) + 1
    assert results.units_done(together) > results.units_done(table)


def test_a_response_is_of_the_sweep_alone() -> None:
    rows = made()
    refused = row("b", "plan", 1, "doubles", "error", ratio=0.0, kind="BadTolerance")
    unfit = row("a", "plan", 99, "doubles", "moved", ratio=1.0, fits_doubles=False)
    found = responses.table(study_of([*rows, refused, unfit]), "doubles").rows
    assert [(r[0], *r[3:8]) for r in found] == [
        ("plan", "0", 9, 9, 0, 0),
        ("plan", "1e-12", 9, 9, 0, 0),
        ("plan", "1", 9, 0, 9, 0),
    ]
    # And other tables are of engines' own tolerances alone.
    assert {r[1] for r in family_table(study_of(rows), "doubles").rows} == {"lattice", "rings"}


def test_differences_are_of_pairs() -> None:
    rows = [row("a", "rings", s, "doubles", "identical") for s in range(6)]
    rows += [row("b", "rings", s, "doubles", "topology" if s else "moved") for s in range(6)]
    (found,) = differences(study_of(rows)).rows
    assert found[2:5] == (6, 5, 0) and found[5] == found[6] == 2 / 2**5


def test_nearness_parts_drawings_by_their_least_distance() -> None:
    def of(seed: int, outcome: str, feature: float, within: float = 1e-9) -> results.Row:
        more = {"tolerance_kind": "none", "tolerance": 0.0, "compare_tolerance": within}
        return row("a", "rings", seed, "doubles", outcome, feature_size=feature, **more)

    rows = [of(0, "topology", 3e-16), of(1, "identical", 5e-16), of(2, "invalid", 2e-3)]
    rows += [of(3, "error", 2e-3, within=0.0), of(4, "moved", 1e-12, within=1e-6)]
    # Of the loud one nothing tells what vertices would match within.
    found = [r[1:4] for r in nearness(study_of(rows)).rows]
    assert found == [("1e-7", 1, 2), ("1e-6", 0, 1), ("1e3", 1, 1)]


def test_orders_tell_digits_from_cells() -> None:
    (found,) = orders(study_of(made())).rows
    assert found[1:3] == (1, "100.0 % (20.7-100.0)")
