// Found: anything of the project, anything of CGAL.
#include <CGAL/Gmpq.h>

#include "number/leading_decimal.hpp"
#include "plumbline/number.hpp"
// Allowed.
#include <gmpxx.h>

#include "checker/line.hpp"
#include "line.hpp"
