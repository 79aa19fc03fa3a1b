#include <rapidjson/document.h>
#include <zlib.h>

#include <catch2/catch.hpp>
#include <map>

#include "output/page/arrays.hpp"
#include "plumbline/output.hpp"
#include "support/checks.hpp"

using namespace plumbline;

namespace {

/// What stands between the first `begin` of the page and the next `end`.
std::string between(const std::string& page, const std::string& begin, const std::string& end) {
  const std::size_t from = page.find(begin);
  REQUIRE(from != std::string::npos);
  const std::size_t to = page.find(end, from + begin.size());
  REQUIRE(to != std::string::npos);
  return page.substr(from + begin.size(), to - from - begin.size());
}

/// What `packed` packed.
std::string unpacked(const std::string& text) {
  std::string bytes;
  std::uint32_t bits = 0;
  unsigned count = 0;
  static const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6U | static_cast<std::uint32_t>(digits.find(c));
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255U);
  }
  std::string result(1 << 20, '\0');
  uLongf size = result.size();
  REQUIRE(uncompress(reinterpret_cast<Bytef*>(result.data()), &size,
                     reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) == Z_OK);
  result.resize(size);
  return result;
}

std::string page_json(const std::string& page) {
  return unpacked(between(page, "<script type=\"text/plain\" id=\"report\">", "</script>"));
}

}  // namespace

TEST_CASE("base64 is as in RFC 4648, section 10") {
  CHECK(base64("").empty());
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xFB\xFF") == "+/8=");
}

TEST_CASE("the page holds the JSON report's findings and counts, and names its arrays") {
  const Check check = Example().checked();
  rapidjson::Document page, report;
  page.Parse(page_json(to_html(check)).c_str());
  report.Parse(to_json(check).c_str());
  REQUIRE(!page.HasParseError());
  CHECK(page["findings"] == report["findings"]);
  CHECK(page["counts"] == report["counts"]);
  CHECK(page["files"] == report["files"]);
  CHECK(!page.HasMember("segments"));
  std::map<std::string, unsigned> counts;
  for (const auto& array : page["page"]["arrays"].GetArray()) {
    counts[array["name"].GetString()] = array["count"].GetUint();
  }
  CHECK(counts.at("authored.x") == 4);
  CHECK(counts.at("authored.tail") == 4);
  CHECK(counts.at("authored.cycles") == 8);
  CHECK(counts.at("float.x") == 3);
  CHECK(counts.at("float.area") == 2);
  CHECK(counts.at("segment_source") == 4);
  CHECK(std::string(page["page"]["exact_areas"][1].GetString()) == "8.02");
}

TEST_CASE("a complex with the incidences of the one as authored is not stored twice") {
  rapidjson::Document page;
  page.Parse(
      page_json(to_html(Agreement{segments("0 0 1 0  1 0 0 1  0 1 0 0")}.checked())).c_str());
  const auto& same = page["page"]["same_incidences"];
  CHECK(std::string(same[same.Size() - 1].GetString()) == "float");
  for (const auto& array : page["page"]["arrays"].GetArray()) {
    CHECK(std::string(array["name"].GetString()) != "float.tail");
  }
}

TEST_CASE("names from outside are no markup and no script in the page") {
  Example example;
  const std::string evil = "</script><script>alert(1)</script><!--<script>]]>&\"'\xFF";
  example.input.files[0] = evil;
  example.input.sources = {};
  for (std::uint32_t line = 1; line <= 4; ++line) {
    example.input.sources.push_back({0, line, 1, evil, evil, evil});
  }
  example.input.rejected = {{{0, 7, 2, evil, evil, evil}, evil, evil}};
  example.input.ledger = {{{0, 7, 2, evil, evil, evil}, evil, evil}};
  Check check = example.checked();
  check.answer.title = evil;
  check.comparison.findings[0].message = evil;
  check.causes.resize(check.comparison.findings.size());
  check.causes[0] = {"prune", 1, evil, evil, evil, true, {}};
  const std::string page = to_html(check), plain = to_html(Example().checked());
  const auto occurrences = [](const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
      ++count;
    }
    return count;
  };
  for (const char* word : {"<script", "</script", "<!--", "alert(1)</"}) {
    INFO(word);
    CHECK(occurrences(page, word) == occurrences(plain, word));
  }
  rapidjson::Document json;
  json.Parse<rapidjson::kParseValidateEncodingFlag>(page_json(page).c_str());
  REQUIRE(!json.HasParseError());
  const std::string kept = evil.substr(0, evil.size() - 1) + "\uFFFD";
  CHECK(json["files"][0].GetString() == kept);
  CHECK(json["page"]["kinds"][0]["element"].GetString() == kept);
  CHECK(json["findings"][0]["message"].GetString() == kept);
}

TEST_CASE("the page loads nothing: its policy forbids it, and nothing asks for it") {
  const std::string page = to_html(Example().checked());
  CHECK(page.find("default-src 'none'") != std::string::npos);
  for (const char* word : {" src=", "href=", "@import", "url(", "fetch(", "XMLHttpRequest",
                           "WebSocket", "import(", "sendBeacon"}) {
    INFO(word);
    CHECK(page.find(word) == std::string::npos);
  }
  for (std::size_t at = page.find("://"); at != std::string::npos; at = page.find("://", at + 1)) {
    const std::string address = page.substr(at, 30);
    INFO(address);
    const bool is_name = address.find("://www.w3.org/") == 0;    // of an XML namespace
    const bool is_notice = address.find("://github.com/") == 0;  // in licence notices
    CHECK((is_name || is_notice));
  }
}

TEST_CASE("drawings of nothing and of one point have a page") {
  for (const char* text : {"", "+ 1 1", "0 0 5 0"}) {
    rapidjson::Document json;
    json.Parse(page_json(to_html(Agreement{segments(text)}.checked())).c_str());
    CHECK(!json.HasParseError());
  }
}
