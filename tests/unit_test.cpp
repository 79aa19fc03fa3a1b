// What a drawing unit is, by what files say.

#include <catch2/catch.hpp>

#include "plumbline/read.hpp"
#include "support/dxf_text.hpp"

namespace {

using plumbline::dxf_with;

std::string text_of(const std::optional<plumbline::LengthUnit>& unit) {
  return unit ? unit->name + " " + unit->metres.get_str() : "none";
}

std::string of_dxf(const std::string& variables) {
  const std::string header = "0 SECTION 2 HEADER " + variables + " 0 ENDSEC";
  return text_of(
      plumbline::read_dxf(dxf_with("0 LINE 8 0 10 0 20 0 11 1 21 1", header), "a.dxf").unit);
}

std::string of_svg(const std::string& attributes) {
  return text_of(plumbline::read_svg("<svg " + attributes + "/>", "a.svg").unit);
}

}  // namespace

TEST_CASE("$INSUNITS says what the unit of a DXF is, exactly; $MEASUREMENT does not") {
  const auto of_code = [](const std::string& code) { return of_dxf("9 $INSUNITS 70 " + code); };
  CHECK(of_code("1") == "in 127/5000");
  CHECK(of_code("2") == "ft 381/1250");
  CHECK(of_code("4") == "mm 1/1000");
  CHECK(of_code("5") == "cm 1/100");
  CHECK(of_code("6") == "m 1");
  CHECK(of_code("13") == "um 1/1000000");
  CHECK(of_code("21") == "US survey ft 1200/3937");
  CHECK(of_code("24") == "US survey mi 6336000/3937");
  CHECK(of_code("0") == "none");
  CHECK(of_code("25") == "none");
  CHECK(of_code("x") == "none");
  CHECK(of_dxf("9 $MEASUREMENT 70 1") == "none");
  CHECK(of_dxf("9 $MEASUREMENT 70 1 9 $INSUNITS 70 6 9 $LUNITS 70 2") == "m 1");
}

TEST_CASE("a width or height in a unit of length says what a user unit of an SVG is") {
  CHECK(of_svg("width='210mm' height='297mm' viewBox='0 0 210 297'") == "mm 1/1000");
  CHECK(of_svg("width='21cm' viewBox='0 0 210 297'") == "mm 1/1000");
  CHECK(of_svg("height='8in' viewBox='0 0 4 4'") == "user unit 127/2500");
  CHECK(of_svg("width='72pt' height='1in' viewBox='0 0 72 72'") == "pt 127/360000");
  CHECK(of_svg("width='10mm'") == "px 127/480000");
  CHECK(of_svg("width='100' height='100'") == "none");
  CHECK(of_svg("width='100px' height='100px' viewBox='0 0 1 1'") == "none");
  CHECK(of_svg("width='100%' viewBox='0 0 1 1'") == "none");
  CHECK(of_svg("width='-1mm'") == "none");
  CHECK(of_svg("width='xmm' viewBox='0 0 1 1'") == "none");
}

TEST_CASE("where width and height differ, the user unit is that of the fitted viewBox") {
  const std::string box = "width='20mm' height='40mm' viewBox='0 0 10 10'";
  CHECK(of_svg(box) == "user unit 1/500");
  CHECK(of_svg(box + " preserveAspectRatio='xMidYMid slice'") == "user unit 1/250");
  CHECK(of_svg(box + " preserveAspectRatio='none'") == "none");
}
