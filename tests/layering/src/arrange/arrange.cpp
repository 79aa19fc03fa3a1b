// Allowed.
#include "plumbline/arrange.hpp"

#include <CGAL/Arrangement_2.h>

#include "plumbline/cgal.hpp"
