#pragma once

#include "output/json/writer.hpp"
#include "plumbline/check.hpp"

namespace plumbline {

/// The members of `report_json` up to the findings, the ladder included: all but those that tell
/// where the drawing's items come from. Written into the open object.
void write_check(JsonWriter& json, const Check& check);

}  // namespace plumbline
