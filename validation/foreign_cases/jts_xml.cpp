// The XML test files of JTS and GEOS.

#include <algorithm>
#include <cctype>
#include <pugixml.hpp>

#include "foreign_cases/foreign.hpp"
#include "plumbline/read.hpp"

namespace foreign {

using namespace plumbline;

namespace {

std::string trimmed(std::string text) {
  const auto is_blank = [](unsigned char c) { return std::isspace(c) != 0; };
  text.erase(std::find_if_not(text.rbegin(), text.rend(), is_blank).base(), text.end());
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), is_blank));
  return text;
}

bool is_hexadecimal(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(),
                                      [](unsigned char c) { return std::isxdigit(c) != 0; });
}

/// Adds a geometry's segments; what its reader refuses, or all of it, is rejected.
void add_geometry(SegmentSet& set, std::string text) {
  const SourceId source = set.add_source({});
  // JTS reads up to the last bracket, and one file has a stray quote behind it.
  if (const std::size_t last = text.rfind(')'); last != std::string::npos) {
    if (last + 1 < text.size())
      set.rejected.push_back({{}, "text after a geometry", text.substr(last + 1)});
    text.resize(last + 1);
  }
  try {
    const SegmentSet more =
        evaluate(is_hexadecimal(text) ? read_wkb(text, "") : read_wkt(text, ""));
    for (const Segment& s : more.segments) set.add(s, source);
    set.rejected.insert(set.rejected.end(), more.rejected.begin(), more.rejected.end());
  } catch (const Error& error) {
    set.rejected.push_back({{}, error.message(), error.offending_text()});
  }
}

/// What the file says of geometry a or b.
void add_claims(Case& one, const pugi::xml_node& node) {
  for (const pugi::xml_node& test : node.children("test")) {
    for (const pugi::xml_node& op : test.children("op")) {
      const std::string name = op.attribute("name").value();
      if (name != "isValid" && name != "isSimple") continue;
      const bool is_b = op.attribute("arg1").value() == std::string("B");
      const std::string text = trimmed(node.child_value(is_b ? "b" : "a"));
      const std::string outcome = trimmed(op.child_value());
      if (is_hexadecimal(text) || (outcome != "true" && outcome != "false")) {
        one.input.rejected.push_back({{}, "claim on binary or without outcome: " + name, outcome});
        continue;
      }
      one.claims.push_back(
          {name == "isValid" ? Claim::Kind::Valid : Claim::Kind::Simple, text, outcome == "true"});
    }
  }
}

}  // namespace

std::vector<Case> jts_xml(std::string_view text) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result) throw Error(ErrorCode::BadInput, std::string("not XML: ") + result.description());
  const pugi::xml_node run = document.child("run");
  if (!run) throw Error(ErrorCode::BadInput, "not a test file: no run");
  std::vector<Case> cases;
  for (const pugi::xml_node& node : run.children("case")) {
    Case one;
    one.name = trimmed(node.child_value("desc"));
    for (const char* geometry : {"a", "b"}) {
      if (node.child(geometry)) add_geometry(one.input, trimmed(node.child_value(geometry)));
    }
    add_claims(one, node);
    cases.push_back(std::move(one));
  }
  return cases;
}

}  // namespace foreign
