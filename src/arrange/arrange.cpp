#include "plumbline/arrange.hpp"

#include "arrange/cgal_engine.hpp"

namespace plumbline {

ExactComplex arrange(const SegmentSet& input) { return cgal_engine(input); }

}  // namespace plumbline
