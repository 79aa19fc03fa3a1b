// The independent checker on certificates written by hand.

#include "verify/verify.hpp"

#include <catch2/catch.hpp>

#include "certificate_text.hpp"

using plumbline_verify::Outcome;
using plumbline_verify::verify;

TEST_CASE("two segments that cross are proved") {
  const auto verdict =
      verify("0,0,2,2\n0,2,2,0\n",
             certificate_text::with_signature("plumbline certificate 1\n"
                                              "signature 0123456789abcdef0123456789abcdef\n"
                                              "vertices 5\n"
                                              "0 0 end 0 0\n"
                                              "0 2 end 1 0\n"
                                              "1 1 cross 0 1\n"
                                              "2 0 end 1 1\n"
                                              "2 2 end 0 1\n"
                                              "edges 4\n"
                                              "0 2 0:0\n"
                                              "1 2 1:0\n"
                                              "2 3 1:1\n"
                                              "2 4 0:1\n"
                                              "cycles 1\n"
                                              "+0 -1 +1 +3 -3 +2 -2 -0\n"
                                              "faces 1\n"
                                              "outer - depth 0 parent - holes 0 isolated inside -\n"
                                              "components 1\n"
                                              "0 0\n"
                                              "end\n"));
  CHECK(verdict.reason.empty());
  CHECK(verdict.outcome == Outcome::Proved);
}
