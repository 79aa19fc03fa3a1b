// The peer: CGAL's arrangement, by aggregated insertion.

#include <CGAL/version.h>

#include "contenders.hpp"
#include "plumbline/cgal.hpp"

namespace plumbline::bench {

Job prepare_cgal(const SegmentSet& input) {
  auto curves = std::make_shared<std::vector<cgal::Traits::Curve_2>>();
  curves->reserve(input.segments.size());
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    curves->emplace_back(cgal::to_cgal(input.segments[s]), SegmentId(s));
  }
  return [curves] {
    const auto result = std::make_shared<cgal::Arrangement>();
    CGAL::insert(*result, curves->begin(), curves->end());
    return Outcome{result, [result] {
                     return Cells{result->number_of_vertices(), result->number_of_edges(),
                                  result->number_of_faces()};
                   }};
  };
}

std::string cgal_version() { return CGAL_VERSION_STR; }

}  // namespace plumbline::bench
