// The independent checker on certificates written by hand, and on texts that are none.

#include "checker/verify.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "support/hand_certificates.hpp"

using hand_certificates::cases;
using plumbline_checker::Outcome;
using plumbline_checker::report;
using plumbline_checker::Verdict;
using plumbline_checker::verify;

namespace {

const hand_certificates::Case& crossing() { return cases().at("a crossing"); }

}  // namespace

TEST_CASE("certificates written by hand are proved") {
  for (const auto& [name, item] : cases()) {
    INFO(name);
    const Verdict verdict = verify(item.input, item.certificate);
    CHECK(verdict.reason.empty());
    CHECK(verdict.outcome == Outcome::Proved);
  }
}

TEST_CASE("a certificate of one input is refused for all others") {
  for (const auto& [name, item] : cases()) {
    for (const auto& [other_name, other] : cases()) {
      INFO(name << " with the certificate of " << other_name);
      CHECK((verify(item.input, other.certificate).outcome == Outcome::Proved) ==
            (name == other_name));
    }
  }
}

TEST_CASE("the verdict counts what was proved") {
  const auto& item = cases().at("a square in a square, points in both, a segment beside them");
  const Verdict verdict = verify(item.input, item.certificate);
  CHECK(verdict.counts.segments == 9);
  CHECK(verdict.counts.points == 2);
  CHECK(verdict.counts.vertices == 12);
  CHECK(verdict.counts.edges == 9);
  CHECK(verdict.counts.cycles == 5);
  CHECK(verdict.counts.faces == 3);
  CHECK(verdict.counts.components == 5);
  CHECK(verdict.counts.isolated_vertices == 2);
  CHECK(report(verdict).find("V - E + F = 12 - 9 + 3 = 1 + 5") != std::string::npos);
}

TEST_CASE("rows without length are counted and named in the report") {
  const auto& item = cases().at("points on a segment and beside it, a row without length");
  const Verdict verdict = verify(item.input, item.certificate);
  CHECK(verdict.counts.without_length == 1);
  CHECK(report(verdict).find("1 row of a segment without length") != std::string::npos);
}

TEST_CASE("an input means the numbers in it, however they are written") {
  const std::string& certificate = crossing().certificate;
  for (const char* input : {"\xEF\xBB\xBF"
                            "0,0,1,1\r\n\r\n 0 ,\t0.5,1,0\r\n",
                            "0,0,1,1\n0,1/2,1,0", "-0,+0,1.,1e0\n.0,5E-1,10e-1,0",
                            "0/7,0,3/3,0.1e1\n0e5,.5,1,0\n\n\n", "00,0,01,1\n0,50e-2,1,0\n"}) {
    INFO(input);
    CHECK(verify(input, certificate).reason.empty());
  }
}

TEST_CASE("an input that cannot be read is bad, with its line") {
  const auto refused = [](const std::string& input) {
    const Verdict verdict = verify(input, crossing().certificate);
    CHECK(verdict.outcome == Outcome::BadInput);
    return report(verdict);
  };
  CHECK(refused("0,0,1,1\n0,0,1\n") ==
        "the input cannot be read: line 2: a row of 3 numbers, not of 4 or 2\n");
  CHECK(refused("1\n") == "the input cannot be read: line 1: a row of 1 numbers, not of 4 or 2\n");
  CHECK(refused("0,0,1,1,1\n") ==
        "the input cannot be read: line 1: a row of more than 4 numbers\n");
  for (const char* number : {"",     "x",     "1x",      "0x1",      "nan",
                             "inf",  "1e",    "1e+",     "e5",       ".",
                             "1..2", "1.2.3", "--1",     "+-1",      "1/0",
                             "1/-2", "1/2/3", "1/",      "/2",       "1.5/2",
                             "1 2",  "1e1.5", "1e10001", "1e-10001", "1e99999999999999999999"}) {
    INFO(number);
    CHECK(refused("\n" + std::string(number) + ",0,1,1\n")
              .find("line 2: \"" + std::string(number) + "\"") != std::string::npos);
  }
  CHECK(refused(std::string("0,0,1,\0", 7)).find("line 1: \"?\" is not a number") !=
        std::string::npos);
  CHECK(refused("<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n").find("line 1") !=
        std::string::npos);
  CHECK(refused(std::string(10'001, '1') + ",0,1,1\n").find("1111...\" is not") !=
        std::string::npos);
}

TEST_CASE("numbers as long as an input may have are proved") {
  const std::string digits(10'000, '9');
  for (const std::string& far : {digits, "1" + std::string(10'000, '0'), "1/" + digits}) {
    const std::string input = "0,0," + (far[1] == '0' ? "1e10000" : far) + ",0\n";
    const std::string certificate = hand_certificates::complete(
        "vertices 2\n0 0 end 0 0\n" + far + " 0 end 0 1\n" +
        "edges 1\n0 1 0:0\ncycles 1\n+0 -0\nfaces 1\n"
        "outer - depth 0 parent - holes 0 isolated inside -\ncomponents 1\n0 0\n");
    CHECK(verify(input, certificate).reason.empty());
  }
}

TEST_CASE("directions and distances that doubles do not tell apart are told apart") {
  const std::string zeros(39, '0');
  const std::string far = "1" + zeros + "0";
  const std::string further = "1" + zeros + "1";
  const std::string between =
      "2" + zeros + "1/2" + zeros + "0";  // the lines are 10^-40 apart there
  const std::string input =
      "0,0," + far + "," + far + "\n0,0," + far + "," + further + "\n1," + between + "\n";
  const std::string certificate = hand_certificates::complete(
      "vertices 4\n0 0 end 0 0\n1 " + between + " point 0\n" + far + " " + far + " end 0 1\n" +
      far + " " + further +
      " end 1 1\nedges 2\n0 2 0:0\n0 3 1:0\ncycles 1\n+0 -0 +1 -1\nfaces 1\n" +
      "outer - depth 0 parent - holes 0 isolated 1 inside -\ncomponents 2\n0 0\n1 0\n");
  CHECK(verify(input, certificate).reason.empty());
  const std::string below = "0,0," + far + "," + far + "\n1,1\n";
  CHECK(report(verify(below, hand_certificates::complete(
                                 "vertices 3\n0 0 end 0 0\n1 1 point 0\n" + far + " " + far +
                                 " end 0 1\nedges 1\n0 2 0:0\ncycles 1\n+0 -0\nfaces 1\n"
                                 "outer - depth 0 parent - holes 0 isolated 1 inside -\n"
                                 "components 2\n0 0\n1 0\n"))) ==
        "refused: line 5: vertex 1 lies on edge 0 at (1, 1)\n");
}

TEST_CASE("any beginning of a certificate is refused") {
  const auto& item = cases().at("a square in a square, points in both, a segment beside them");
  for (std::size_t length = 0; length < item.certificate.size(); ++length) {
    INFO(length);
    CHECK(verify(item.input, item.certificate.substr(0, length)).outcome == Outcome::Refused);
  }
}

TEST_CASE("any certificate with another byte somewhere is refused") {
  for (const auto& [name, item] : cases()) {
    for (std::size_t at = 0; at < item.certificate.size(); ++at) {
      for (const char byte : {'0', '1', '2', '-', '+', ' ', '\n', '\r', '\0', '/', ':', '\xff'}) {
        std::string text = item.certificate;
        if (text[at] == byte) continue;
        text[at] = byte;
        const Verdict verdict = verify(item.input, text);
        INFO(name << ", byte " << at << ": " << text);
        CHECK(verdict.outcome == Outcome::Refused);
      }
    }
  }
}

TEST_CASE("coordinates may be as long as crossings of the input are, or 1000 letters") {
  const auto refusal = [](std::size_t digits) {
    std::string text = crossing().certificate;
    text.replace(text.find("1/3 1/3"), 3, std::string(digits, '1'));
    return report(verify(crossing().input, text));
  };
  CHECK_THAT(refusal(1000), Catch::Contains("vertex 3 should come before the one before it"));
  CHECK_THAT(refusal(1001), Catch::Contains("line 6: a coordinate is longer than any"));
}

TEST_CASE("counts beyond the text ask for no memory") {
  for (const char* count :
       {"999999999", "1000000000000000000", "18446744073709551616", "-1", "1e9"}) {
    for (const char* section : {"vertices 5", "edges 4", "cycles 1", "faces 1", "components 1"}) {
      std::string text = crossing().certificate;
      const std::string name(section, std::string(section).find(' ') + 1);
      text.replace(text.find(section), std::string(section).size(), name + count);
      INFO(text);
      CHECK(verify(crossing().input, text).outcome == Outcome::Refused);
    }
  }
}
