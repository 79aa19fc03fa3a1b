"""Two arrangements held against each other; the ladder; certificates."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import plumbline
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

SQUARE = "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))"

coordinate = st.integers(0, 5)
drawings = st.lists(
    st.tuples(coordinate, coordinate, coordinate, coordinate).filter(lambda s: s[:2] != s[2:]),
    min_size=1,
    max_size=10,
)


@settings(max_examples=40, deadline=None)
@given(drawings, st.randoms())
def test_order_and_direction_of_lines_make_no_difference(drawing: Any, random: Any) -> None:
    other = [s if random.random() < 0.5 else (*s[2:], *s[:2]) for s in drawing]
    random.shuffle(other)
    comparison = plumbline.compare(drawing, other)
    assert comparison
    assert comparison.agree
    assert comparison.matched_edges == comparison.exact_counts.edges


@settings(max_examples=40, deadline=None)
@given(drawings, drawings)
def test_they_agree_at_no_tolerance_just_if_they_are_the_same(a: Any, b: Any) -> None:
    assert bool(plumbline.compare(a, b)) == plumbline.same(a, b)


def test_what_the_second_one_lacks_is_missing() -> None:
    both = "GEOMETRYCOLLECTION (POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0)), LINESTRING (5 5, 6 6))"
    lacking = plumbline.compare(both, SQUARE)
    assert {f.disagreement for f in lacking.findings} == {"missing"}
    assert {f.disagreement for f in plumbline.compare(SQUARE, both).findings} == {"extra"}
    assert repr(lacking) == f"<Comparison: disagree, {len(lacking.findings)} findings>"


def test_faces_that_differ_have_the_exact_area_between_them() -> None:
    other = "POLYGON ((0 0, 3 0, 3 3, 1 3.5, 0 3, 0 0))"
    areas = {f.area for f in plumbline.compare(SQUARE, other).findings if f.kind == "face"}
    assert areas == {Fraction(3, 4)}


@pytest.mark.parametrize("tolerance", [-1, float("nan"), float("inf"), "x", None, [1], 10**400])
def test_bad_tolerances_of_comparisons_are_refused(tolerance: Any) -> None:
    with pytest.raises(plumbline.Error):
        plumbline.compare(SQUARE, SQUARE, tolerance)


# The ladder.


def test_the_first_critical_radius_is_the_least_distance() -> None:
    drawing = [(0, 0, 4, 0), (1, "0.25", 3, 2)]
    ladder = plumbline.ladder(drawing)
    sizes = plumbline.arrange(drawing).feature_size()
    assert ladder.steps[0].squared_radius == sizes.squared_vertex_edge == Fraction(1, 16)
    assert ladder.steps[0].radius == 0.25
    assert ladder.is_complete
    assert ladder.steps[-1].vertices == 1
    assert "0.25" in ladder.to_text()
    assert ladder.to_svg().startswith("<svg")


def test_a_ladder_ends_where_it_is_told_to() -> None:
    drawing = [(0, 0, 1, 0), (3, 0, 7, 0), (15, 0, 31, 0)]
    assert [step.radius for step in plumbline.ladder(drawing).steps] == [1, 2, 4, 8, 16]
    assert len(plumbline.ladder(drawing, max_steps=3)) == 3
    assert not plumbline.ladder(drawing, max_steps=3).is_complete
    assert [s.radius for s in plumbline.ladder(drawing, largest_radius="4.5").steps] == [1, 2, 4]


def test_the_ladder_of_a_check_is_that_of_its_drawing() -> None:
    drawing = plumbline.arrange([(0, 0, 4, 0), (1, "0.25", 3, 2)])
    of_check = plumbline.cross_check(drawing).ladder
    assert [s.squared_radius for s in of_check.steps] == [
        s.squared_radius for s in plumbline.ladder(drawing).steps
    ]
    assert of_check.right_radii


@pytest.mark.parametrize(
    "arguments", [{"max_steps": -1}, {"max_steps": 2.5}, {"largest_radius": -1}]
)
def test_bad_limits_of_ladders_are_refused(arguments: Any) -> None:
    with pytest.raises(plumbline.Error):
        plumbline.ladder(SQUARE, **arguments)


def test_of_nothing_there_is_no_ladder() -> None:
    with pytest.raises(plumbline.Error, match="nothing drawn"):
        plumbline.ladder([])


# Certificates.


@settings(max_examples=40, deadline=None)
@given(drawings)
def test_certificates_are_proved(drawing: Any) -> None:
    exact = plumbline.arrange(drawing)
    verdict = plumbline.verify(drawing, plumbline.certificate(exact))
    assert verdict
    assert verdict.counts.vertices == exact.counts.vertices
    assert verdict.counts.edges == exact.counts.edges
    assert verdict.counts.faces == exact.counts.faces
    assert verdict.counts.pieces == len(exact.edge_segments.indices)


def test_certificates_have_the_signature_of_the_arrangement(examples: Path) -> None:
    exact = plumbline.arrange(examples / "office-plan.svg")
    proof = plumbline.certificate(exact)
    assert proof.split(b"\n")[1].decode() == f"signature {exact.signature}"
    assert plumbline.verify(exact.lines, proof).proved


DRAWING = [(0, 0, 2, 2), (0, 2, 2, 0), (0, 0, 0, 2), ("1/3", "0.1", 5, 5)]


@settings(max_examples=150, deadline=None)
@given(st.data())
def test_forged_certificates_are_refused(data: st.DataObject) -> None:
    proof = plumbline.certificate(DRAWING)
    at = data.draw(st.integers(0, len(proof) - 1))
    byte = data.draw(st.integers(0, 255).filter(lambda b: b != proof[at]))
    verdict = plumbline.verify(DRAWING, proof[:at] + bytes([byte]) + proof[at + 1 :])
    assert not verdict
    assert verdict.reason
    assert repr(verdict).startswith("<Verdict: refused: ")


@pytest.mark.parametrize("forged", [b"", b"\xff\xfe", b"plumbline certificate 1\n"])
def test_what_is_no_certificate_is_refused(forged: bytes) -> None:
    assert not plumbline.verify(DRAWING, forged)


def test_a_certificate_is_of_these_lines_alone(tmp_path: Path) -> None:
    proof = plumbline.certificate(DRAWING)
    (tmp_path / "proof").write_bytes(proof)
    assert plumbline.verify(DRAWING, tmp_path / "proof")
    assert not plumbline.verify(DRAWING[::-1], proof)
    assert not plumbline.verify(DRAWING[:-1], proof)
    tenth = np.array([[0.1, 0, 1, 1]])
    doubles = plumbline.certificate(tenth)
    assert plumbline.verify(tenth, doubles)
    assert not plumbline.verify(tenth, doubles, numbers="decimals")


def test_a_refusal_says_which_line_is_wrong() -> None:
    proof = plumbline.certificate(DRAWING)
    lines = proof.split(b"\n")
    at = lines.index(b"vertices 8")
    lines[at] = b"vertices 9"
    verdict = plumbline.verify(DRAWING, b"\n".join(lines))
    assert not verdict.proved
    assert verdict.line > at
    assert str(verdict) == verdict.report
    assert f"line {verdict.line}" in verdict.report


def test_certificates_are_bytes_or_paths() -> None:
    with pytest.raises(plumbline.Error, match="bytes or a path"):
        plumbline.verify(DRAWING, "plumbline certificate 1")  # type: ignore[arg-type]
