// Found: CGAL, directly and through its public header.
#include <CGAL/Epeck.h>

#include "plumbline/cgal.hpp"
// Found: an engine, its stages and what explains them.
#include "engines/lar/explain/run.hpp"
#include "plumbline/engines/lar.hpp"
// Found: the independent checker.
#include "checker/verify.hpp"
// Allowed.
#include "arrange/sweep.hpp"
#include "complex/planarity.hpp"
