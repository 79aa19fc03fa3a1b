"""The same lines, drawn otherwise, are the same subdivision."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import plumbline
import shapely
from drawings import segments
from hypothesis import assume, given, settings
from hypothesis import strategies as st

Rows = list[tuple[Fraction, ...]]
few = settings(deadline=None, max_examples=80)


def exact(drawing: list[tuple[str, ...]]) -> Rows:
    return [tuple(map(Fraction, row)) for row in drawing]


@few
@given(segments, st.randoms(use_true_random=False))
def test_order_direction_and_repetition_do_not_matter(
    drawing: list[tuple[str, ...]], random: Random
) -> None:
    rows = exact(drawing)
    other = [row if random.random() < 0.5 else row[2:] + row[:2] for row in rows]
    other += [random.choice(rows) for _ in range(3)]
    random.shuffle(other)
    a, b = plumbline.arrange(rows), plumbline.arrange(other)
    assert a == b
    assert (shapely.normalize(a.to_shapely()) == shapely.normalize(b.to_shapely())).all()


@few
@given(segments, st.fractions(Fraction(1, 9), Fraction(8, 9), max_denominator=9))
def test_a_line_in_two_parts_is_that_line_with_a_point_on_it(
    drawing: list[tuple[str, ...]], t: Fraction
) -> None:
    rows = exact(drawing)
    ax, ay, bx, by = rows[0]
    assume((ax, ay) != (bx, by))
    middle = (ax + t * (bx - ax), ay + t * (by - ay))
    parts = [(ax, ay, *middle), (*middle, bx, by), *rows[1:]]
    whole, parted = plumbline.arrange(rows), plumbline.arrange(parts)
    assert plumbline.same(parted, plumbline.arrange(rows, points=[middle]))
    assert parted.counts.faces == whole.counts.faces
    assert parted.areas == whole.areas


@few
@given(segments, st.tuples(*[st.integers(-3, 3)] * 6))
def test_an_affine_map_maps_all(
    drawing: list[tuple[str, ...]], m: tuple[int, int, int, int, int, int]
) -> None:
    a, b, c, d, e, f = m
    determinant = a * d - b * c
    assume(determinant != 0)

    def mapped(x: Fraction, y: Fraction) -> tuple[Fraction, Fraction]:
        return a * x + b * y + e, c * x + d * y + f

    rows = exact(drawing)
    here = plumbline.arrange(rows)
    there = plumbline.arrange([(*mapped(*row[:2]), *mapped(*row[2:])) for row in rows])
    assert there.counts == here.counts
    assert sorted(there.points) == sorted(mapped(*p) for p in here.points)
    assert sorted(there.areas) == sorted(abs(determinant) * area for area in here.areas)


@few
@given(segments)
def test_edges_of_an_arrangement_are_arranged_already(drawing: list[tuple[str, ...]]) -> None:
    a = plumbline.arrange(drawing)
    points = a.points
    again = plumbline.arrange([(*points[t], *points[h]) for t, h in a.edges.tolist()])
    assert again == a


@few
@given(segments)
def test_both_exact_engines_agree(drawing: list[tuple[str, ...]]) -> None:
    assert plumbline.arrange(drawing) == plumbline.arrange(drawing, exact_engine="cgal")
