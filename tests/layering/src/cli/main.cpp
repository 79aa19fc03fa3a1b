// Found: a private header, a path that goes round the table.
#include "../engines/lar/stages/points.hpp"
#include "output/svg/kit.hpp"
// Allowed.
#include "cli/options.hpp"
#include "plumbline/plumbline.hpp"
