// Found: the exact engine, CGAL, the comparison, what explains the stages, a folder that is no
// room.
#include <CGAL/Arrangement_2.h>

#include "engines/lar/explain/run.hpp"
#include "plumbline/arrange.hpp"
#include "plumbline/compare.hpp"
#include "utils/strings.hpp"
// Allowed.
#include "engines/lar/stages/points.hpp"
#include "plumbline/complex.hpp"
#include "plumbline/engines/lar_stages.hpp"
#include "points.hpp"
