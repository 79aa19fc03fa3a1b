// The log of a repair, as `to_json` writes it, back to what was changed.

#include "plumbline/error.hpp"
#include "plumbline/pipeline.hpp"
#include "read/input_file.hpp"
#include "read/json_tree.hpp"
#include "read/struct_json_values.hpp"

namespace plumbline {
namespace {

/// The member of this name, which must be there.
JsonValue member(const JsonValue& object, const char* key) {
  expect(object, JsonType::Object, "an object");
  const JsonValue value = object.find(key);
  if (!value) object.fail("no member \"" + std::string(key) + "\"");
  return value;
}

JsonValue list(const JsonValue& object, const char* key) {
  const JsonValue value = member(object, key);
  expect(value, JsonType::Array, "a list");
  return value;
}

Point point(const JsonValue& value) {
  expect(value, JsonType::Array, "a point");
  if (value.size() != 2) value.fail("not a point of two coordinates");
  const auto number = [](const JsonValue& coordinate) {
    expect(coordinate, JsonType::String, "an exact number, as text");
    try {
      return parse_decimal(coordinate.text());
    } catch (const Error& error) {
      coordinate.fail(error.message());
    }
  };
  const JsonValue x = value.first();
  return {number(x), number(x.next())};
}

Segment segment(const JsonValue& value) {
  return {point(member(value, "from")), point(member(value, "to"))};
}

SourcedSegment sourced(const JsonValue& value, const std::vector<std::string>& files) {
  const JsonValue element = member(value, "element");
  member(element, "line");
  const Source source = source_of(element, "line", files);
  const std::string file = source.file < files.size() ? files[source.file] : "";
  return {segment(value), source, file};
}

}  // namespace

RepairLog read_repair_log(const std::filesystem::path& file) {
  const InputFile input(file);
  ByteStream bytes = input.stream();
  const JsonTree tree(bytes);
  const JsonValue root = tree.root();
  expect(root, JsonType::Object, "a log of a repair");
  const JsonValue format = root.find("format");
  if (!format || format.text() != "plumbline repair 1") {
    (format ? format : root).fail("not a log of `plumbline repair` of format 1");
  }
  std::vector<std::string> files;
  const JsonValue names = list(root, "files");
  for (JsonValue name = names.first(); name; name = name.next()) files.push_back(string_of(name));
  RepairLog log;
  log.input_signature = string_of(member(root, "input_signature"));
  log.output_signature = string_of(member(root, "output_signature"));
  const JsonValue all = list(root, "changes");
  for (JsonValue value = all.first(); value; value = value.next()) {
    NetChange& change = log.changes.emplace_back();
    const JsonValue before = list(value, "before"), after = list(value, "after");
    for (JsonValue line = before.first(); line; line = line.next()) {
      change.before.push_back(sourced(line, files));
    }
    for (JsonValue line = after.first(); line; line = line.next()) {
      change.after.push_back(segment(line));
    }
  }
  return log;
}

SegmentSet undo(const SegmentSet& output, const RepairLog& log) {
  if (rounded_signature(output) != log.output_signature) {
    throw Error(ErrorCode::BadInput, "this is not the drawing that the repair of the log made");
  }
  SegmentSet input = undo(output, log.changes);
  if (rounded_signature(input) != log.input_signature) {
    throw Error(ErrorCode::BadInput, "the log does not lead back to the drawing that it is of");
  }
  return input;
}

}  // namespace plumbline
