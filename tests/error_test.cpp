#include "plumbline/error.hpp"

#include <catch2/catch.hpp>

using plumbline::Error;
using plumbline::ErrorCode;

TEST_CASE("an error says place, message and offending text in one line") {
  const Error error(ErrorCode::BadInput, "not a number", {"plan.svg", 3, 7}, "1e");
  CHECK(std::string(error.what()) == "plan.svg:3:7: not a number: \"1e\"");
}

TEST_CASE("an error shortens its offending text and keeps it on the line") {
  const Error error(ErrorCode::BadInput, "too long", {},
                    std::string(30, '9') + "\n" + std::string(90, '9'));
  CHECK(error.offending_text().size() == 60);
  CHECK(std::string(error.what()).find('\n') == std::string::npos);
}

TEST_CASE("an unknown line or column is left out of a place") {
  CHECK(to_text(plumbline::Place{"a.svg", 0, 0}) == "a.svg");
  CHECK(to_text(plumbline::Place{"", 4, 0}) == "line 4");
  CHECK(to_text(plumbline::Place{}).empty());
}

TEST_CASE("a broken promise is an internal error in every build type") {
  CHECK_NOTHROW(plumbline::ensure(true, "never"));
  CHECK_THROWS_AS(plumbline::ensure(false, "half-edge without twin"), Error);
}

TEST_CASE("what turns the direction of a text is not shown as it is") {
  const std::string mark = "\xEF\xBF\xBD";
  // U+202E, U+2066, U+061C, U+200F, U+2028; not their neighbours U+202F, U+2065.
  CHECK(plumbline::line_text("a\xE2\x80\xAE"
                             "b\xE2\x81\xA6\xD8\x9C\xE2\x80\x8F\xE2\x80\xA8") ==
        "a" + mark + "b" + mark + mark + mark + mark);
  CHECK(plumbline::line_text("\xE2\x80\xAF\xE2\x81\xA5\xD8\xA7") ==
        "\xE2\x80\xAF\xE2\x81\xA5\xD8\xA7");
}
