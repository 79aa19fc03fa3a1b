#pragma once

#include "output/json/writer.hpp"
#include "plumbline/diagnose.hpp"

namespace plumbline {

/// The members of a diagnosis, written into the open object. Documented in docs/json.md.
void write_diagnosis(JsonWriter& json, const Diagnosis& diagnosis, const SegmentSet& input);

}  // namespace plumbline
