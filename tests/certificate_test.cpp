#include "plumbline/output.hpp"

#include <catch2/catch.hpp>

#include "inputs/families.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/read.hpp"
#include "plumbline/structure.hpp"

using namespace plumbline;

namespace {

SegmentSet lines(const char* rows) { return evaluate(read_lines(rows, "test.lines")); }

/// Without its second line: the signature is tested elsewhere.
std::string unsigned_certificate(const SegmentSet& input) {
  std::string text = certificate(arrange(input), input);
  const std::size_t begin = text.find('\n') + 1;
  text.erase(begin, text.find('\n', begin) + 1 - begin);
  return text;
}

}  // namespace

TEST_CASE("the certificate of nothing is the unbounded face") {
  CHECK(unsigned_certificate({}) ==
        "plumbline certificate 1\n"
        "vertices 0\nedges 0\ncycles 0\n"
        "faces 1\nouter - depth 0 parent - holes isolated inside -\n"
        "components 0\nend\n");
}

TEST_CASE("a certificate names ends, crossings, pieces, cycles, faces and components") {
  // A triangle; a piece of its base again; an upright line through its top; a loose line inside.
  const SegmentSet input = lines(
      "0,0,4,0\n4,0,2,3\n2,3,0,0\n1,0,3,0\n2,-1,2,5\n"
      "1.5,0.5,1.5,0.75\n");
  CHECK(unsigned_certificate(input) ==
        "plumbline certificate 1\n"
        "vertices 10\n"
        "0 0 end 0 0\n1 0 end 3 0\n3/2 1/2 end 5 0\n3/2 3/4 end 5 1\n2 -1 end 4 0\n"
        "2 0 cross 0 4\n2 3 end 1 1\n2 5 end 4 1\n3 0 end 3 1\n4 0 end 0 1\n"
        "edges 10\n"
        "0 1 0:0\n0 6 2:0\n1 5 0:1 3:0\n2 3 5:0\n4 5 4:0\n5 6 4:1\n5 8 0:2 3:1\n6 7 4:2\n"
        "6 9 1:0\n8 9 0:3\n"
        "cycles 4\n"
        "+0 +2 +5 -1\n-0 +1 +7 -7 +8 -9 -6 -4 +4 -2\n+3 -3\n-5 +6 +9 -8\n"
        "faces 3\n"
        "outer - depth 0 parent - holes 1 isolated inside -\n"
        "outer 0 depth 1 parent 0 holes 2 isolated inside 13/8 15/8\n"
        "outer 3 depth 1 parent 0 holes isolated inside 5/2 3/2\n"
        "components 2\n0 0\n2 1\nend\n");
}

TEST_CASE("a point of the input gives a reason where nothing else does") {
  SegmentSet input = lines("0,0,2,0\n1,1,1,-1\n");
  const SourceId source = input.add_source({});
  input.add_point({1, 0}, source);               // on the crossing
  input.add_point({Rational(1, 2), 0}, source);  // on a segment
  input.add_point({5, 5}, source);
  input.add_point({0, 0}, source);  // an end
  const std::string text = unsigned_certificate(input);
  CHECK(text.find("vertices 7\n0 0 end 0 0\n1/2 0 point 1\n1 -1 end 1 1\n1 0 cross 0 1\n"
                  "1 1 end 1 0\n2 0 end 0 1\n5 5 point 2\n") != std::string::npos);
  CHECK(text.find("isolated 6 inside -\n") != std::string::npos);
}

TEST_CASE("both engines get the same certificate") {
  for (const std::string& family : inputs::families()) {
    const SegmentSet input = inputs::of_family(family, 11);
    CHECK(certificate(arrange(input, ExactEngine::Bucket), input) ==
          certificate(arrange(input, ExactEngine::Cgal), input));
  }
}

TEST_CASE("a complex of other segments gets no certificate") {
  const ExactComplex complex = arrange(lines("0,0,2,0\n"));
  CHECK_THROWS_AS(certificate(complex, lines("0,0,2,0\n5,5,6,6\n")), Error);
}

TEST_CASE("exact rows of segments read back as the same segments") {
  const SegmentSet input = lines("0.1,-2,1/3,1e3\n0,0,1e-30,22/7\n");
  const std::string rows = to_lines(input);
  CHECK(rows == "0.1,-2,1/3,1000\n0,0,0.000000000000000000000000000001,22/7\n");
  CHECK(lines(rows.c_str()).segments == input.segments);
}
