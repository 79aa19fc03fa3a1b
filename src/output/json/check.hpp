#pragma once

#include "output/json/writer.hpp"
#include "plumbline/check.hpp"

namespace plumbline::json {

/// The members of a check up to the findings, the ladder included: all but those that tell where
/// the drawing's items come from.
Part check_members(const Check& check);

}  // namespace plumbline::json
