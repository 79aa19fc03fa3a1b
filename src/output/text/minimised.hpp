#pragma once

#include <string>

#include "plumbline/output/minimised.hpp"

namespace plumbline {

/// "engine lar repaired (float LAR), radius 0.001, tolerance 0.001", with its parameters.
std::string version_line(const Minimised& minimised);
/// A parameter's value as --set takes it.
std::string value_text(const ParameterValue& value);
/// A table of vertices, edges and faces, exact and answered; lines begin with `indent`.
std::string count_table(const Minimised& minimised);
/// The segments as rows of shortest decimals of their doubles.
std::string rows_of(const SegmentSet& drawing);
/// "(1/3, 0.5)", and the nearest doubles where a coordinate is no short decimal.
std::string exact_place(const Point& place);
/// What was kept constant, a sentence a line: representable or not, where the radius comes from.
std::string constants_text(const Minimised& minimised);

}  // namespace plumbline
