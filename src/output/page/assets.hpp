#pragma once

#include <string_view>

namespace plumbline {

/// The files of src/web as they are, put into the library at build time by
/// cmake/embed.cmake.
extern const std::string_view kPageBody;      ///< page.html
extern const std::string_view kPageStyle;     ///< page.css
extern const std::string_view kPageScript;    ///< bundle/report.js
extern const std::string_view kRoomsStyle;    ///< rooms.css
extern const std::string_view kRoomsScript;   ///< bundle/rooms.js
extern const std::string_view kRepairBody;    ///< repair.html
extern const std::string_view kRepairStyle;   ///< repair.css, to come after page.css
extern const std::string_view kRepairScript;  ///< bundle/repair.js

}  // namespace plumbline
