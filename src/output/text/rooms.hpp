#pragma once

#include <string>
#include <vector>

#include "plumbline/rooms.hpp"

namespace plumbline {

/// "3 rooms, 81.57 m2".
std::string rooms_line(const Rooms& rooms);
/// "12.50 m2"; in drawing units, six digits, where it is not known what they are.
std::string area_text(const Rooms& rooms, const Rational& area);
/// Layers without what binding a drawing put before their names, each once.
std::vector<std::string> own_names(const std::vector<std::string>& layers);
/// Lines on what was left out, and on texts in no room; "" where there is nothing to say.
std::string rest_text(const Rooms& rooms, const SegmentSet& input);

}  // namespace plumbline
