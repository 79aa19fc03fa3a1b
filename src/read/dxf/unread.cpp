#include "read/dxf/unread.hpp"

#include <algorithm>
#include <array>

namespace plumbline::dxf {
namespace {

constexpr const char* kAnnotation = "annotation is not read";
constexpr const char* kPicture = "fills, pictures and masks are not read";
constexpr const char* kView = "lights and cameras are not drawn";
constexpr const char* kEndless = "endless lines are not read";
constexpr const char* kSolid = "surfaces and solids are not read";
constexpr std::array kUnread{
    Unread{"DIMENSION", kAnnotation, true},
    Unread{"ARC_DIMENSION", kAnnotation, true},
    Unread{"LARGE_RADIAL_DIMENSION", kAnnotation, true},
    Unread{"LEADER", kAnnotation, true},
    Unread{"MULTILEADER", kAnnotation, true},
    Unread{"MLEADER", kAnnotation, true},
    Unread{"TOLERANCE", kAnnotation, true},
    Unread{"ACAD_TABLE", kAnnotation, true},
    Unread{"RTEXT", kAnnotation, true},
    Unread{"ARCALIGNEDTEXT", kAnnotation, true},
    Unread{"HATCH", kPicture, true},
    Unread{"MPOLYGON", "its boundary is not read", false},
    Unread{"IMAGE", kPicture, true},
    Unread{"WIPEOUT", kPicture, true},
    Unread{"OLEFRAME", kPicture, true},
    Unread{"OLE2FRAME", kPicture, true},
    Unread{"PDFUNDERLAY", kPicture, true},
    Unread{"DWFUNDERLAY", kPicture, true},
    Unread{"DGNUNDERLAY", kPicture, true},
    Unread{"POINT", "points are not read", true},
    Unread{"LIGHT", kView, true},
    Unread{"CAMERA", kView, true},
    Unread{"SUN", kView, true},
    Unread{"GEOPOSITIONMARKER", kAnnotation, true},
    Unread{"RAY", kEndless, false},
    Unread{"XLINE", kEndless, false},
    Unread{"3DSOLID", kSolid, false},
    Unread{"BODY", kSolid, false},
    Unread{"REGION", kSolid, false},
    Unread{"SURFACE", kSolid, false},
    Unread{"MESH", kSolid, false},
    Unread{"VERTEX", "without a POLYLINE", false},
    Unread{"VIEWPORT", "a view of the drawing, not a part of it", true},
    Unread{"ACAD_PROXY_ENTITY", "known to the application only that made it", false},
    Unread{"ACAD_PROXY_OBJECT", "known to the application only that made it", false},
};

}  // namespace

Unread unread(std::string_view type) {
  const auto* found = std::find_if(kUnread.begin(), kUnread.end(),
                                   [type](const Unread& unread) { return unread.type == type; });
  return found == kUnread.end() ? Unread{type, "not understood", false} : *found;
}

}  // namespace plumbline::dxf
