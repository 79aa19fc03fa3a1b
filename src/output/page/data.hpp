#pragma once

#include <string>

#include "plumbline/check.hpp"

namespace plumbline {

/// What the page knows of a check.
struct PageData {
  std::string json;    ///< the members of `report_json` but `sources` and `segments`, and `page`
  std::string arrays;  ///< geometry, areas and sources: the bytes of PageArrays
};

/// Member `page` of the JSON is {y_up, arrays, same_incidences, exact_areas, kinds, ids}: the
/// directory of the arrays; the complexes whose incidences are those of the complex as authored,
/// and are left out; exact areas of its faces, "" where they are long; files, elements and paths
/// that sources share; and of sources that have an id their index and id.
PageData page_data(const Check& check);

}  // namespace plumbline
