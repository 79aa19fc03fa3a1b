#pragma once

// Found: layers above, a private header.
#include "lar/stages.hpp"
#include "plumbline/complex.hpp"
#include "plumbline/lar_stages.hpp"
// Allowed.
#include <vector>

#include "plumbline/number.hpp"
