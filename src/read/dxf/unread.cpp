#include "read/dxf/unread.hpp"

#include <algorithm>
#include <array>

namespace plumbline::dxf {
namespace {

struct Unread {
  std::string_view type;
  const char* reason;
};
constexpr const char* kAnnotation = "annotation is not read";
constexpr const char* kPicture = "fills, pictures and masks are not read";
constexpr const char* kEndless = "endless lines are not read";
constexpr const char* kSolid = "surfaces and solids are not read";
constexpr std::array kUnread{
    Unread{"TEXT", kAnnotation},
    Unread{"MTEXT", kAnnotation},
    Unread{"ATTRIB", kAnnotation},
    Unread{"ATTDEF", kAnnotation},
    Unread{"DIMENSION", kAnnotation},
    Unread{"ARC_DIMENSION", kAnnotation},
    Unread{"LARGE_RADIAL_DIMENSION", kAnnotation},
    Unread{"LEADER", kAnnotation},
    Unread{"MULTILEADER", kAnnotation},
    Unread{"MLEADER", kAnnotation},
    Unread{"TOLERANCE", kAnnotation},
    Unread{"ACAD_TABLE", kAnnotation},
    Unread{"RTEXT", kAnnotation},
    Unread{"ARCALIGNEDTEXT", kAnnotation},
    Unread{"HATCH", kPicture},
    Unread{"MPOLYGON", kPicture},
    Unread{"IMAGE", kPicture},
    Unread{"WIPEOUT", kPicture},
    Unread{"OLEFRAME", kPicture},
    Unread{"OLE2FRAME", kPicture},
    Unread{"PDFUNDERLAY", kPicture},
    Unread{"DWFUNDERLAY", kPicture},
    Unread{"DGNUNDERLAY", kPicture},
    Unread{"POINT", "points are not read"},
    Unread{"RAY", kEndless},
    Unread{"XLINE", kEndless},
    Unread{"3DSOLID", kSolid},
    Unread{"BODY", kSolid},
    Unread{"REGION", kSolid},
    Unread{"SURFACE", kSolid},
    Unread{"MESH", kSolid},
    Unread{"VERTEX", "without a POLYLINE"},
    Unread{"VIEWPORT", "a view of the drawing, not a part of it"},
    Unread{"ACAD_PROXY_ENTITY", "known to the application only that made it"},
    Unread{"ACAD_PROXY_OBJECT", "known to the application only that made it"},
};

}  // namespace

const char* reason_not_read(std::string_view type) {
  const auto* found = std::find_if(kUnread.begin(), kUnread.end(),
                                   [type](const Unread& unread) { return unread.type == type; });
  return found == kUnread.end() ? "not understood" : found->reason;
}

}  // namespace plumbline::dxf
