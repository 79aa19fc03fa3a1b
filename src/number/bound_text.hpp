#pragma once

#include <string>

namespace plumbline {

/// A bound as people read it: rounded up to two digits, e.g. "0.0013".
std::string bound_text(double bound);

}  // namespace plumbline
