// The JSON of a check against its schema, docs/check.schema.json.

#include <rapidjson/document.h>
#include <rapidjson/schema.h>
#include <rapidjson/stringbuffer.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "plumbline/plumbline.hpp"
#include "support/engine_checks.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

rapidjson::Document parsed(const std::string& text) {
  rapidjson::Document document;
  document.Parse(text.c_str(), text.size());
  REQUIRE_FALSE(document.HasParseError());
  return document;
}

const rapidjson::SchemaDocument& schema() {
  static const rapidjson::Document text = [] {
    std::ifstream file(PLUMBLINE_CHECK_SCHEMA);
    std::stringstream content;
    content << file.rdbuf();
    return parsed(content.str());
  }();
  static const rapidjson::SchemaDocument document(text);
  return document;
}

/// Empty if the document fits the schema, else where it does not.
std::string misfit(const rapidjson::Document& document) {
  rapidjson::SchemaValidator validator(schema());
  if (document.Accept(validator)) return {};
  rapidjson::StringBuffer where;
  validator.GetInvalidDocumentPointer().StringifyUriFragment(where);
  return std::string(where.GetString()) + ": " + validator.GetInvalidSchemaKeyword();
}

std::string json_of(const std::string& drawing, std::optional<double> radius) {
  return to_json(check_lar(segments(drawing), radius));
}

}  // namespace

TEST_CASE("the JSON of a check fits its schema") {
  const auto drawing =
      GENERATE(as<std::string>(), "", "0 0 1 0", "+ 1 2",
               "0 0 4 0  4 0 4 0.01  4 0.01 0 4  0 4 0 0", "10 0 10.9 0.3  10.3 0.1 10.5 2",
               "0 0 1/3 1  0 1 1/7 0", "0 0 1e60 1  5 0 5 1e60", "0 0 1e-60 1  0 1 1e-70 0");
  for (const std::optional<double> radius : {std::optional<double>(), std::optional(0.1)}) {
    CHECK(misfit(parsed(json_of(drawing, radius))).empty());
  }
}

TEST_CASE("the schema refuses what is no check") {
  rapidjson::Document document = parsed(json_of("0 0 1 0  1.01 0 2 0", 0.1));
  REQUIRE(misfit(document).empty());
  REQUIRE(document["findings"].Size() > 0);
  rapidjson::Value& finding = document["findings"][0];

  SECTION("a missing member") { document.RemoveMember("findings"); }
  SECTION("an unknown member") { document.AddMember("extra", 1, document.GetAllocator()); }
  SECTION("a kind that there is not") { finding["kind"] = "wall"; }
  SECTION("a stage without a name") { finding["cause"]["stage"] = ""; }
  SECTION("a number for an exact coordinate") { finding["where"]["exact"][0] = 1; }
  SECTION("a cause without a rule") { finding["cause"]["rule"] = ""; }
  CHECK_FALSE(misfit(document).empty());
}
