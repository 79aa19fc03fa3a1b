#pragma once

// Found: a layer above, a private header.
#include "lar/stages.hpp"
#include "plumbline/complex.hpp"
// Allowed.
#include <vector>

#include "plumbline/number.hpp"
