// Arranges a drawing exactly, runs the float LAR pipeline on it and says where the two disagree.
// Usage: quickstart DRAWING

#include <iostream>

#include "plumbline/plumbline.hpp"

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: quickstart DRAWING\n";
    return 2;
  }
  const plumbline::SegmentSet input = plumbline::evaluate(plumbline::read(argv[1]));
  const plumbline::ExactComplex exact_complex = plumbline::arrange(input);

  const std::vector<plumbline::Rational> areas = plumbline::face_areas(exact_complex);
  for (std::size_t f = 1; f < exact_complex.face_count(); ++f) {
    std::cout << "face " << f << ": area " << plumbline::exact_text(areas[f]) << ", holes "
              << exact_complex.face_holes[f].size() << ", depth " << exact_complex.face_depth[f]
              << '\n';
  }

  const plumbline::lar::Result lar = plumbline::lar::arrange(input);
  const plumbline::Comparison verdict =
      plumbline::compare(exact_complex, lar.complex, lar.trace.radius);
  std::cout << (verdict.agree() ? "float LAR agrees\n" : "float LAR disagrees\n");
  for (const plumbline::Finding& finding : verdict.findings) {
    std::cout << to_text(finding.kind) << ' ' << to_text(finding.disagreement) << ": "
              << finding.message << '\n';
  }
} catch (const plumbline::Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
