// fits_schema SCHEMA [DEFINITION]: whether the JSON on standard input fits the schema, or one of
// its definitions. If not, prints where, and fails.

#include <rapidjson/document.h>
#include <rapidjson/schema.h>
#include <rapidjson/stringbuffer.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace {

rapidjson::Document parsed(std::istream& stream) {
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  rapidjson::Document document;
  document.Parse(text.c_str(), text.size());
  if (document.HasParseError()) throw std::runtime_error("no JSON");
  return document;
}

/// The schema of one of the definitions.
void choose(rapidjson::Document& schema, const std::string& name) {
  auto& allocator = schema.GetAllocator();
  if (!schema["definitions"].HasMember(name.c_str())) throw std::runtime_error("no " + name);
  rapidjson::Value of(rapidjson::kObjectType);
  of.AddMember("$ref", rapidjson::Value(("#/definitions/" + name).c_str(), allocator), allocator);
  rapidjson::Value all(rapidjson::kArrayType);
  all.PushBack(of, allocator);
  schema.RemoveMember("anyOf");
  schema.AddMember("allOf", all, allocator);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) throw std::runtime_error("usage: fits_schema SCHEMA [DEFINITION]");
  std::ifstream file(argv[1]);
  rapidjson::Document text = parsed(file);
  if (argc > 2) choose(text, argv[2]);
  const rapidjson::SchemaDocument schema(text);
  rapidjson::SchemaValidator validator(schema);
  if (parsed(std::cin).Accept(validator)) return 0;
  rapidjson::StringBuffer where;
  validator.GetInvalidDocumentPointer().StringifyUriFragment(where);
  std::cout << where.GetString() << ": " << validator.GetInvalidSchemaKeyword() << '\n';
  return 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
