// The report as JSON; documented in docs/json.md.

#include "output/json/check_json.hpp"
#include "plumbline/report.hpp"

namespace plumbline {

std::string to_json(const Check& check) {
  JsonWriter json;
  json.StartObject();
  write_check(json, check);
  write_input(json, check.input);
  json.EndObject();
  return json.take();
}

}  // namespace plumbline
