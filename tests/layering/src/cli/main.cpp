// Found: a private header, a path that goes round the table.
#include "../lar/stages.hpp"
#include "report/picture.hpp"
// Allowed.
#include "cli/options.hpp"
#include "plumbline/plumbline.hpp"
