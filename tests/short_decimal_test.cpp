// Printed doubles read as the short decimals that they were meant to be.

#include <catch2/catch.hpp>

#include "number/short_decimal.hpp"
#include "plumbline/read.hpp"
#include "support/dxf_text.hpp"

using namespace plumbline;

namespace {

Number number(const std::string& text) { return parse_number(text); }
Number shortened(const std::string& text) { return short_decimal(number(text)); }

ReadOptions shortest() {
  ReadOptions options;
  options.shortest_decimals = true;
  return options;
}

}  // namespace

TEST_CASE("a printed double that lies next to a short decimal was meant to be that") {
  CHECK(shortened("420.34000000000003") == number("420.34"));
  CHECK(shortened("0.30000000000000004") == number("0.3"));
  CHECK(shortened("-0.30000000000000004") == number("-0.3"));
  CHECK(shortened("-43.065000000000026") == number("-43.065"));  // some operations later
  CHECK(shortened("35.749999999999986") == number("35.75"));
  CHECK(shortened("420.340000000000031832314562052488327026367187500") == number("420.34"));
  CHECK(shortened("9.999999999999999e22") == number("1e23"));
  CHECK(shortened("1.0000000000000001e-7") == number("1e-7"));
}

TEST_CASE("other numbers stay as they are") {
  for (const char* text : {"0", "0.1234567890123456", "1.00000000000001", "420.34", "1e23",
                           "-1e-25", "1/3", "1e400", "1e-400", "1e-320", "123456789012",
                           "123456789012.3", "1234567890123456", "3.141592653589793"}) {
    CHECK(shortened(text) == number(text));
  }
}

TEST_CASE("eight units in the last place are next to a short decimal, nine are not") {
  const auto above_one = [](int units) {
    return Number(Rational(1) + Rational(units, std::int64_t{1} << 52U));
  };
  CHECK(short_decimal(above_one(8)) == number("1"));
  CHECK(short_decimal(above_one(9)) == above_one(9));
}

TEST_CASE("every reader takes short decimals where it is asked to") {
  const std::string x = "420.34000000000003", plain = "420.34";
  const auto wkt = [](const std::string& n) { return "LINESTRING (0 0, " + n + " 7)"; };
  const auto rows = [](const std::string& n) { return "0,0," + n + ",7\n"; };
  const auto read_all = [&](const std::string& n, const ReadOptions& options) {
    const auto json = [&](const std::string& text) { return read_struct_json(text, "a", options); };
    return std::vector<Structure>{
        read_lines(rows(n), "a", options),
        read_svg("<svg xmlns='http://www.w3.org/2000/svg'><line x2='" + n +
                     "' y2='7'/><path transform='translate(" + n + ")' d='M 0 0 L 0 1'/></svg>",
                 "a", options),
        read_dxf(dxf_with("0 LINE 8 0 10 0 20 0 11 " + n + " 21 7"), "a", options),
        read_wkt(wkt(n), "a", options),
        read_csv("wkt\n\"" + wkt(n) + "\"\n", "a", options),
        read_csv(rows(n), "a", options),
        read_geojson(R"({"type": "LineString", "coordinates": [[0, 0], [)" + n + ", 7]]}", "a",
                     options),
        read_lar_json(R"({"V": [[0, 0], [)" + n + R"(, 7]], "EV": [[0, 1]]})", "a", options),
        json(R"({"root": "a", "defs": {"a": {"lines": [[[0, 0], [)" + n + ", 7]]]}}}")};
  };
  const std::vector<Structure> drifted = read_all(x, shortest()), meant = read_all(plain, {}),
                               as_written = read_all(x, {});
  for (std::size_t i = 0; i < meant.size(); ++i) {
    CAPTURE(i);
    const SegmentList segments = evaluate(meant[i]).segments;
    CHECK(evaluate(drifted[i]).segments == segments);
    CHECK_FALSE(evaluate(as_written[i]).segments == segments);
    CHECK(as_written[i].ledger.empty());
    REQUIRE(drifted[i].ledger.size() == 1);
    CHECK(drifted[i].ledger[0].what ==
          std::string(i == 1 ? "2 printed doubles" : "1 printed double") +
              " by decimals of at most 12 digits");
    CHECK(drifted[i].ledger[0].bound == "3e-14 units");
  }
}
