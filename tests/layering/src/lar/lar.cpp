// Found: the exact engine, CGAL, a folder that is no layer.
#include <CGAL/Arrangement_2.h>

#include "plumbline/arrange.hpp"
#include "utils/strings.hpp"
// Allowed.
#include "lar/stages.hpp"
#include "plumbline/complex.hpp"
#include "plumbline/published_stages.hpp"
#include "stages.hpp"
