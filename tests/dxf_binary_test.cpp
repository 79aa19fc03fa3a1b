#include <bit>
#include <catch2/catch.hpp>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "support/listing.hpp"

using plumbline::read_dxf;

namespace {

/// Writes groups as a binary DXF has them, with codes of one byte (up to R12) or two.
class Writer {
 public:
  explicit Writer(bool wide_codes) : wide_codes_(wide_codes) {}

  Writer& text(int code, const std::string& value) {
    put_code(code);
    bytes_ += value;
    bytes_ += '\0';
    return *this;
  }
  Writer& real(int code, double value) {
    put_code(code);
    put(std::bit_cast<std::uint64_t>(value), 8);
    return *this;
  }
  Writer& integer(int code, std::uint64_t value, int size) {
    put_code(code);
    put(value, size);
    return *this;
  }
  Writer& line(double ax, double ay, double bx, double by) {
    return text(0, "LINE").text(8, "0").real(10, ax).real(20, ay).real(11, bx).real(21, by);
  }
  std::string bytes() const { return bytes_; }

 private:
  void put(std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xffU);
  }
  void put_code(int code) {
    if (wide_codes_) return put(static_cast<std::uint64_t>(code), 2);
    if (code < 255) return put(static_cast<std::uint64_t>(code), 1);
    put(255, 1);
    put(static_cast<std::uint64_t>(code), 2);
  }

  bool wide_codes_;
  std::string bytes_{"AutoCAD Binary DXF\r\n\x1a\0", 22};
};

Writer entities(bool wide_codes) {
  Writer writer(wide_codes);
  writer.text(0, "SECTION").text(2, "ENTITIES");
  return writer;
}

std::string error_of(const std::string& bytes) {
  try {
    read_dxf(bytes, "a.dxf");
  } catch (const plumbline::Error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("doubles of a binary DXF are the dyadic rationals that they are") {
  for (const bool wide_codes : {false, true}) {
    Writer writer = entities(wide_codes);
    writer.line(0.1, -0.375, 1e22, 0x1p-1074).text(0, "ENDSEC").text(0, "EOF");
    const auto set = evaluate(read_dxf(writer.bytes() + "trash", "a.dxf"));
    REQUIRE(set.segments.size() == 1);
    CHECK(set.segments[0].a.x == plumbline::Rational("3602879701896397/36028797018963968"));
    CHECK(set.segments[0].a.y == plumbline::Rational(-3, 8));
    CHECK(set.segments[0].b.x == plumbline::parse_decimal("1e22"));
    CHECK(set.segments[0].b.y * plumbline::rational_from(0x1p1000) ==
          plumbline::rational_from(0x1p-74));
  }
}

TEST_CASE("values of every type are passed over by their size") {
  for (const bool wide_codes : {false, true}) {
    Writer writer = entities(wide_codes);
    writer.text(0, "LINE").text(8, "A").integer(70, 1, 2).integer(90, 70000, 4);
    writer.integer(160, 7, 8).integer(290, 1, 1).text(330, "1F").integer(370, 25, 2);
    writer.text(310, std::string("\x03"
                                 "ab",
                                 3));  // 3 bytes, the last of them the writer's 0
    writer.integer(420, 255, 4).real(460, 1.5).text(1001, "APP").real(1010, 9).integer(1071, 5, 4);
    writer.text(1004, std::string("\x03\n0", 3));
    writer.real(10, 1).real(20, 2).real(11, 3).real(21, 4).text(0, "EOF");
    CHECK(listing(read_dxf(writer.bytes(), "a.dxf")) == "1 2, 3 4 | a.dxf:6 LINE (A)\n");
  }
}

TEST_CASE("a number that is none is listed with its entity") {
  Writer writer = entities(true);
  const double zero = 0;
  writer.line(0, 0, 1 / zero, 1).line(0, zero / zero, 1, 1).line(0, 0, 1, 1);
  writer.text(0, "ENDSEC").text(0, "EOF");
  CHECK(listing(read_dxf(writer.bytes(), "a.dxf")) ==
        "0 0, 1 1 | a.dxf:30 LINE (0)\n"
        "rejected:\n"
        "a.dxf:6 LINE (0): not a number: group 11: inf\n"
        "a.dxf:18 LINE (0): not a number: group 20: nan\n");
}

TEST_CASE("a binary DXF that is cut off or has an unknown group is refused with its byte") {
  const std::string begin = entities(true).bytes();
  CHECK(begin.size() == 43);
  CHECK(error_of(begin + std::string("\x0a\0\0\0", 4)) ==
        "a.dxf: the file ends inside a group at byte 45");
  CHECK(error_of(begin + std::string("\x08\0abc", 5)) ==
        "a.dxf: the file ends inside a text at byte 45");
  CHECK(error_of(begin + std::string("\x50\0\0", 3)) == "a.dxf: unknown group code 80 at byte 43");
  CHECK(error_of(begin.substr(0, 22)) == "a.dxf:1: no section: this is no DXF text");
}

TEST_CASE("a line break in a text does not break the sequence of groups") {
  Writer writer = entities(true);
  writer.text(0, "TEXT")
      .text(1, "a\n0\nLINE\r\n8")
      .line(0, 0, 1, 1)
      .text(0, "ENDSEC")
      .text(0, "EOF");
  CHECK(listing(read_dxf(writer.bytes(), "a.dxf")) ==
        "0 0, 1 1 | a.dxf:10 LINE (0)\n"
        "rejected:\na.dxf:6 TEXT (0): has no group 10\n");
}
