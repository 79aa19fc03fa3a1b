// The XML test files of JTS and GEOS.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <pugixml.hpp>

#include "cases/foreign/foreign.hpp"
#include "cases/foreign/well_known_text.hpp"
#include "plumbline/read.hpp"

namespace plumbline::foreign {

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
void add_geometry(SegmentSet& set, const pugi::xml_node& node, const char* name) {
  if (!node.child(name)) return;
  std::string text = trimmed(node.child_value(name));
  const SourceId source = set.add_source({});
  // JTS reads up to the last bracket, and one file has a stray quote behind it.
  if (const std::size_t last = text.rfind(')'); last != std::string::npos) {
    if (last + 1 < text.size()) {
      set.rejected.push_back({{}, "text after a geometry", text.substr(last + 1)});
    }
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

/// One `test` of a case, in small letters as far as case does not matter.
struct Test {
  std::string operation, first, second, outcome;
};

std::string small_letters(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::vector<Test> tests_of(const pugi::xml_node& node) {
  std::vector<Test> result;
  for (const pugi::xml_node& test : node.children("test")) {
    for (const pugi::xml_node& op : test.children("op")) {
      result.push_back({small_letters(op.attribute("name").value()),
                        small_letters(op.attribute("arg1").value()),
                        small_letters(op.attribute("arg2").value()), trimmed(op.child_value())});
    }
  }
  return result;
}

/// The polygons of a text, if it is one of those alone.
std::optional<Geometry> polygons(const std::string& text) {
  try {
    Geometry result = geometry(text);
    if (!result.polygons.empty() && result.parts.empty()) return result;
  } catch (const Error&) {  // binary, say
  }
  return std::nullopt;
}

/// The largest absolute value of a coordinate.
double reach(const SegmentSet& set) {
  double most = 0;
  for (const Segment& s : set.segments) {
    for (const PointD& p : {nearest(s.a), nearest(s.b)}) {
      most = std::max({most, std::abs(p.x), std::abs(p.y)});
    }
  }
  return most;
}

/// What a boolean operation on two polygons is said to give; nothing if the test is of another
/// kind.
std::optional<AreaClaim> area_claim(const pugi::xml_node& node, const Test& test,
                                    const SegmentSet& input, std::size_t first_clip) {
  using Operation = AreaClaim::Operation;
  static const std::map<std::string, Operation> operations{
      {"intersection", Operation::Intersection},
      {"union", Operation::Union},
      {"difference", Operation::Difference},
      {"symdifference", Operation::Xor}};
  const bool is_new = test.operation.ends_with("ng");
  const auto found =
      operations.find(test.operation.substr(0, test.operation.size() - (is_new ? 2 : 0)));
  const bool is_swapped = test.first == "b" && test.second == "a";
  if (found == operations.end() || (!is_swapped && (test.first != "a" || test.second != "b"))) {
    return std::nullopt;
  }
  if (!polygons(trimmed(node.child_value("a"))) || !polygons(trimmed(node.child_value("b")))) {
    return std::nullopt;
  }
  try {
    Operation operation = found->second;
    if (is_swapped && operation == Operation::Difference) operation = Operation::ReverseDifference;
    // JTS's snapping moves corners by some 1e-12 of the coordinates.
    constexpr double kSnapped = 1e-11;
    const Geometry result = geometry(test.outcome);
    return AreaClaim{AreaClaim::Rule::EvenOdd, operation,        first_clip, area(result),
                     kSnapped * reach(input),  perimeter(result)};
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// What the file says of geometries a and b.
void add_claims(Case& one, const pugi::xml_node& node, std::size_t first_clip) {
  for (const Test& test : tests_of(node)) {
    const std::string text = trimmed(node.child_value(test.first == "b" ? "b" : "a"));
    const bool is_predicate = test.operation == "isvalid" || test.operation == "issimple";
    const bool is_known = test.outcome == "true" || test.outcome == "false";
    if (is_predicate && is_known && !is_hexadecimal(text)) {
      const auto kind = test.operation == "isvalid" ? Claim::Kind::Valid : Claim::Kind::Simple;
      one.claims.push_back({kind, text, test.outcome == "true"});
    } else if (const auto claim = area_claim(node, test, one.input, first_clip)) {
      one.areas.push_back(*claim);
    } else {
      one.unexamined.push_back(test.operation);
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
    add_geometry(one.input, node, "a");
    const std::size_t first_clip = one.input.segments.size();
    add_geometry(one.input, node, "b");
    add_claims(one, node, first_clip);
    cases.push_back(std::move(one));
  }
  return cases;
}

}  // namespace plumbline::foreign
