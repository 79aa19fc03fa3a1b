// Loose ends: gaps, undershoots, overshoots, near-misses, dangles.

#include <catch2/catch.hpp>

#include "support/diagnoses.hpp"

using namespace plumbline;

TEST_CASE("two lines that end near each other leave a gap") {
  // The ring does not close: (0, 0) and (-0.3, 0.4) are 1/2 apart.
  const std::string ring = "0 0 10 0  10 0 10 10  10 10 0 10  0 10 -0.3 0.4";
  CHECK(list(ring, "0.5") == "gap at -0.15 0.2 squared 0.25 tolerance 0.5 of 1 4\n");
  // The ends of a double line run side by side: no gap.
  CHECK(list(kRoom + "2 0 2 5  2.1 0 2.1 5", "0.2").find("gap") == std::string::npos);
}

TEST_CASE("of two ends near each other one may be short and the other one long") {
  // A corner at (10, 0).
  CHECK(list("0 0 10.03 0  10 0.02 10 8  10 8 0 8  0 8 0 0", "0.05") ==
        "undershoot at 10 0.02 squared 0.0004 tolerance 0.02 of 1 2\n"
        "overshoot at 10.03 0 squared 0.0009 tolerance 0.030000000000000002 of 1 2\n");
  const SegmentSet room = segments("0 0 10.03 0  10 0.02 10 8  10 8 0 8  0 8 0 0");
  const Diagnosis result = diagnosis(room, "0.05");
  CHECK(result.defects.at(0).message ==
        "a line ends 0.02 short of another one, on the boundary of a face of area 80 that gaps "
        "leave open");
  CHECK(result.defects.at(1).message ==
        "a line goes 0.03 beyond where one that is cut short would meet it");
  // On one line, they leave a gap, wherever lines cross near it.
  CHECK(list("0 0 5 0  5.06 0 10 0  4.9 -9 4.9 9", "0.07").starts_with("gap at 5.03 0"));
}

TEST_CASE("ends that lead to one point are one gap") {
  const std::string box = rectangle(0, 0, 10, 8);
  CHECK(list(box + "0 4 4.97 4  5.03 4 10 4  5 0 5 3.97  5 4.03 5 8", "0.1") ==
        "gap at 5 4 squared 0.0009 tolerance 0.030000000000000002 of 5 6 7 8\n");
  CHECK(list(box + "0 4 4.97 4  5.031 4 10 4  5 0 5 3.96", "0.1") ==
        "gap at 5 4 squared 0.0016 tolerance 0.04 of 5 6 7\n");
  // Two combs that face each other: as many gaps as there are teeth.
  std::string combs;
  for (int i = 0; i < 5; ++i) {
    const std::string y = std::to_string(i) + ".5 ";
    combs += "0 " + y + "4.5 " + y + "5.5 " + y + "10 " + y;
  }
  CHECK(diagnosis(segments(rectangle(0, 0, 10, 8) + combs), "2").count(DefectKind::Gap) == 5);
}

TEST_CASE("gaps that leave a face open come first, the largest first") {
  // Of the rooms 2 x 10 and 8 x 10 the lesser one; the stub parts nothing.
  const Diagnosis result =
      diagnosis(segments(kRoom + "2 0 2 9.5  2 5 9.6 5  20 20 30 20  25 21 25 20.4"), "0.5");
  REQUIRE(result.count(DefectKind::Undershoot) == 3);
  CHECK(result.defects.at(0).open_area.value_or(0) == Approx(40));
  CHECK(result.defects.at(1).open_area.value_or(0) == Approx(20));
  CHECK_FALSE(result.defects.at(2).open_area);
  // A wall in three pieces opens the room twice.
  const Diagnosis pieces = diagnosis(
      segments("0 0 5 0  5.06 0 5.1 0  5.15 0 10 0  10 0 10 8  10 8 0 8  0 8 0 0"), "0.1");
  REQUIRE(pieces.count(DefectKind::Gap) == 2);
  CHECK(pieces.defects.at(0).open_area.value_or(0) == Approx(80));
  CHECK(pieces.defects.at(1).open_area.value_or(0) == Approx(80));
  CHECK(by_effect(result) == std::vector<std::size_t>{0, 1, 2, 3, 4});
}

TEST_CASE("a line that ends short of another one is an undershoot") {
  CHECK(list(kRoom + "5 0 5 9.75", "0.25") ==
        "undershoot at 5 9.75 squared 0.0625 tolerance 0.25 of 3 5\n");
  // Slanted: (5, 9) is 1 / sqrt(2) away from the line of slope 1 through (5, 10).
  CHECK(list("0 5 10 15  10 15 10 0  10 0 0 5  5 2.5 5 9", "1") ==
        "undershoot at 5 9 squared 0.5 tolerance 0.7071067811865476 of 1 4\n");
}

TEST_CASE("a line that runs beyond one that it crosses is an overshoot") {
  CHECK(list(kRoom + "5 0 5 10.25", "0.25") ==
        "overshoot at 5 10.25 squared 0.0625 tolerance 0.25 of 5\n");
  // A tick of its own is a dangle.
  CHECK(list(kRoom + "5 10 5 10.25", "0.25") ==
        "dangle at 5 10.25 squared 0.0625 tolerance 0.25 of 5\n");
}

TEST_CASE("the nearest explanation of a loose end wins") {
  // 0.2 beyond the one line, 0.1 short of the next.
  CHECK(
      list(kRoom + rectangle(-5, -5, 20, 20) + "0 10.3 10 10.3  10.3 0 10.3 10  5 0 5 10.2", "0.35")
          .find("undershoot at 5 10.2 squared 0.01 tolerance 0.1") != std::string::npos);
}

TEST_CASE("a corner near a line that it does not touch is a near-miss") {
  // The triangle's corner (5, 9.5) is 1/2 below the room's upper side.
  CHECK(list(kRoom + "3 3 7 3  7 3 5 9.5  5 9.5 3 3", "0.5") ==
        "near-miss at 5 9.5 squared 0.25 tolerance 0.5 of 3 6 7\n");
  // Two corners, 0.3 and 0.4 apart: one defect, at their middle.
  CHECK(list(kRoom + rectangle(20, 20, 30, 30) + "10 10 19.7 19.6  19.7 19.6 30 5  30 5 10 10",
             "0.5") == "near-miss at 19.85 19.8 squared 0.25 tolerance 0.5 of 5 8 9 10\n");
}

TEST_CASE("what a short way along the lines explains is no near-miss") {
  // A room with a small niche, and a circle in fine chords.
  CHECK(list("0 0 4 0  4 0 4 -1  4 -1 5 -1  5 -1 5 0  5 0 9 0  9 0 9 9  9 9 0 9  0 9 0 0", "2") ==
        "");
  std::string circle;
  for (int i = 0; i < 72; ++i) {
    const double a = i * 5 * 3.14159265358979 / 180, b = (i + 1) % 72 * 5 * 3.14159265358979 / 180;
    for (const double t : {a, b}) {
      circle += shortest_text(std::cos(t)) + ' ' + shortest_text(std::sin(t)) + ' ';
    }
  }
  CHECK(list(circle, "0.2") == "");
}

TEST_CASE("a line with a loose end dangles, one with two is one defect") {
  CHECK(list(kRoom + "5 0 5 3  5 3 6 4", "0.1") ==
        "dangle at 6 4 size " + shortest_text(3 + std::sqrt(2.0)) + " of 5 6\n");
  CHECK(list("0 0 3 4", "0.1") == "dangle at 0 0 squared 25 of 1\n");
  const Diagnosis free_line = diagnosis(segments("0 0 3 4"), "0.1");
  CHECK(free_line.tips == 2);
  CHECK(free_line.defects.at(0).vertices.size() == 2);
}
