#pragma once

// Found: rooms below, a private header.
#include "geometry/text.hpp"
#include "plumbline/complex.hpp"
#include "plumbline/engines/lar_stages.hpp"
// Allowed.
#include <vector>

#include "plumbline/number.hpp"
