// Found: CGAL, directly and through its public header.
#include <CGAL/Epeck.h>

#include "plumbline/cgal.hpp"
// Allowed.
#include "arrange/sweep.hpp"
#include "plumbline/lar.hpp"
// Found: the independent checker.
#include "verify/verify.hpp"
