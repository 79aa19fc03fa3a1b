// What the SVG reader accepts as XML: well-formedness, encodings, entities.

#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "support/listing.hpp"

using plumbline::evaluate;
using plumbline::read_svg;
using namespace std::string_literals;

namespace {

std::string error_of(const std::string& text) {
  try {
    read_svg(text, "a.svg");
  } catch (const plumbline::Error& error) {
    CHECK(error.code() == plumbline::ErrorCode::BadInput);
    return error.what();
  }
  return "accepted";
}

/// ASCII text in UTF-16.
std::string utf16(const std::string& text, bool big_endian) {
  std::string wide;
  for (const char c : text) wide += big_endian ? "\0"s + c : c + "\0"s;
  return wide;
}

}  // namespace

TEST_CASE("malformed XML is refused with file, line and column") {
  const auto [text, start] = GENERATE(table<std::string, std::string>({
      {"", "a.svg:1:1: malformed XML: no element"},
      {" \n <!-- only -->", "a.svg:1:1: malformed XML: no element"},
      {"<svg>\n<g></svg>", "a.svg:2:6: malformed XML: start-end tags mismatch"},
      {"<svg>\n<g>", "a.svg:2:3: malformed XML: start-end tags mismatch"},
      {"<svg><line x1=5/></svg>", "a.svg:1:15: malformed XML: error parsing element attribute"},
      {"<svg><line x1='5/></svg>", "a.svg:1:1"},
      {"<svg/>\n<svg/>", "a.svg:2:1: malformed XML: second root element: \"svg\""},
      {"<svg/>\n junk ", "a.svg:2:2: malformed XML: text outside the root element: \"junk\""},
      {"junk<svg/>", "a.svg:1:1: malformed XML: text outside the root element: \"junk\""},
      {"<svg>\n  <line x1='1' x2='2' x1='3'/></svg>",
       "a.svg:2:3: malformed XML: duplicate attribute: \"x1\""},
      {"<html/>", "a.svg:1:1: the root element is not svg: \"html\""},
      {"<svg>\n<g id='\x01'/></svg>", "a.svg:2:8: control character in the text"},
      {"<svg/>\0<svg/>"s, "a.svg:1:7: control character in the text"},
      {"<svg>\n<g id='\xff'/></svg>", "a.svg:2:8: text is not valid UTF-8"},
      {"<svg id='\xc3'/>", "a.svg:1:10: text is not valid UTF-8"},
      {"<?xml version='1.0' encoding='klingon'?><svg/>",
       "a.svg:1:1: unknown encoding: \"klingon\""},
      {"<?xml version='1.0' encoding='UTF-8//IGNORE'?><svg/>", "a.svg:1:1: unknown encoding"},
      {"\x89PNG\r\n", "a.svg:1:1: text is not valid UTF-8"},
  }));
  CAPTURE(text);
  CHECK(error_of(text).substr(0, start.size()) == start);
}

TEST_CASE("a duplicate is found among few attributes and among many") {
  for (const int count : {2, 5, 16, 17, 40, 3000}) {
    std::string attributes;
    for (int i = 0; i < count; ++i) attributes += " a" + std::to_string(i) + "='1'";
    CHECK(error_of("<svg" + attributes + "/>") == "accepted");
    CHECK(error_of("<svg" + attributes + " a" + std::to_string(count / 2) + "='2'/>") ==
          "a.svg:1:1: malformed XML: duplicate attribute: \"a" + std::to_string(count / 2) + "\"");
  }
}

TEST_CASE("every encoding of the same drawing is read, with its line numbers") {
  const std::string plain = "<svg>\n<g id='A'>\n<line x2='1'/></g></svg>";
  const std::string expected = "0 0, 1 0 | a.svg:3:1 line (A)\n";
  CHECK(listing(read_svg(plain, "a.svg")) == expected);
  CHECK(listing(read_svg("\xEF\xBB\xBF" + plain, "a.svg")) == expected);
  CHECK(listing(read_svg("\xFF\xFE" + utf16(plain, false), "a.svg")) == expected);
  CHECK(listing(read_svg("\xFE\xFF" + utf16(plain, true), "a.svg")) == expected);
  CHECK(listing(read_svg(utf16(plain, false), "a.svg")) == expected);
  CHECK(listing(read_svg(utf16(plain, true), "a.svg")) == expected);
}

TEST_CASE("names keep their characters, from any encoding that the document declares") {
  CHECK(listing(read_svg("<?xml version='1.0' encoding='ISO-8859-1'?><svg><g id='K\xfc"
                         "che'><line x2='1'/></g></svg>",
                         "a.svg")) == "0 0, 1 0 | a.svg:1:64 line (Küche)\n");
  CHECK(listing(read_svg("<svg><g id='Küche &amp; B&#xe4;d'><line x2='1'/></g></svg>", "a.svg")) ==
        "0 0, 1 0 | a.svg:1:36 line (Küche & Bäd)\n");
}

TEST_CASE("a declaration of UTF-16 in a text of single bytes is overlooked") {
  CHECK(error_of("<?xml version='1.0' encoding='utf-16'?><svg/>") == "accepted");
}

TEST_CASE("entities of the internal subset are replaced in attributes") {
  const auto set = evaluate(read_svg(R"(<?xml version="1.0"?>
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG [1.1]//EN" "http://www.w3.org/svg11.dtd" [
  <!-- <!ENTITY ns "http://wrong.example"> -->
  <!ENTITY ns "http://www.w3.org/2000/svg">
  <!ENTITY ns "http://the.second.declaration.does.not.count">
  <!ENTITY half '.5'>
  <!ENTITY end "1&half; 2">
  <!ENTITY outside SYSTEM "file:///etc/passwd">
  <!ENTITY % parameter "ignored > this">
]>
<svg xmlns="&ns;"><polyline id="&none;" points="0 0 &end;&half;"/></svg>)",
                                     "a.svg"));
  CHECK(segments_of(set) == "0 0, 1.5 2.5\n");
  CHECK(set.sources.at(0).id == "&none;");
}

TEST_CASE("entities within themselves, bombs and entities with markup are refused") {
  const auto refused = [](const std::string& declarations, const std::string& content) {
    return error_of("<!DOCTYPE svg [" + declarations + "]>\n<svg>" + content + "</svg>");
  };
  CHECK(refused("<!ENTITY a '&b;'><!ENTITY b '&a;'>", "<g id='&a;'/>").substr(0, 38) ==
        "a.svg:2:6: entities nested too deep: \"");
  CHECK(refused("<!ENTITY wall '<line/>'>", "<g>&wall;</g>") ==
        "a.svg:2:6: an entity with markup is not understood yet: \"&wall;\"");
  std::string bomb = "<!ENTITY e0 'ha'>";
  for (int i = 1; i <= 12; ++i) {
    bomb += "<!ENTITY e" + std::to_string(i) + " '";
    for (int k = 0; k < 10; ++k) bomb += "&e" + std::to_string(i - 1) + ";";
    bomb += "'>";
  }
  try {
    read_svg("<!DOCTYPE svg [" + bomb + "]><svg id='&e12;'/>", "a.svg");
    FAIL("no error");
  } catch (const plumbline::Error& error) {
    CHECK(error.code() == plumbline::ErrorCode::Limit);
  }
}

TEST_CASE("a reference to an external entity is an error with its place") {
  const auto error = [](const std::string& content) {
    return error_of(
        "<!DOCTYPE svg [<!ENTITY wall SYSTEM 'wall.svg'><!ENTITY in '&wall;'>]>\n<svg>" + content +
        "</svg>");
  };
  CHECK(error("<g>&amp;</g>") == "accepted");
  CHECK(error("<g>&wall;</g>") == "a.svg:2:6: external entities are not read: \"&wall;\"");
  CHECK(error("<g id='&wall;'/>") == "a.svg:2:6: external entities are not read: \"&wall;\"");
  CHECK(error("<g id='&in;'/>") == "a.svg:2:6: external entities are not read: \"&wall;\"");
}

TEST_CASE("comments, instructions, CDATA and text between elements draw nothing") {
  CHECK(listing(read_svg("<?xml version='1.0'?><?pi?><!-- c --><svg>text<![CDATA[<line x2='9'/>]]>"
                         "<?pi <line x2='8'/>?><line x2='1'/></svg><!-- end -->\n",
                         "a.svg")) == "0 0, 1 0 | a.svg:1:94 line\n");
}

TEST_CASE("an element with very many attributes is read at once") {
  std::string text = "<svg><line x2='1'";
  for (int i = 0; i < 200'000; ++i) text += " a" + std::to_string(i) + "=''";
  CHECK(evaluate(read_svg(text + "/></svg>", "a.svg")).segments.size() == 1);
}
