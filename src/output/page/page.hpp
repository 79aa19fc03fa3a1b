#pragma once

#include <string>
#include <string_view>

#include "output/page/data.hpp"

namespace plumbline {

/// A page that loads nothing, whatever names the drawing holds: `body` and `script` are ours, the
/// title and what is shown without scripts texts. The script finds the data in the elements
/// "report" and "arrays", packed.
std::string page_with_data(const std::string& title, const std::string& style,
                           std::string_view body, const std::string& without_script,
                           const PageData& data, std::string_view script);

}  // namespace plumbline
