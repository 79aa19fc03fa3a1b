// A repair as a page: the drawing before and after, and lists of what was done to it.

#include "output/json/input.hpp"
#include "output/page/arrays.hpp"
#include "output/page/assets.hpp"
#include "output/page/page.hpp"
#include "output/svg/repair_parts.hpp"
#include "output/svg/sheet.hpp"
#include "output/text/edits.hpp"
#include "output/text/escape.hpp"
#include "output/text/verdict.hpp"
#include "plumbline/output.hpp"

namespace plumbline {
namespace {

constexpr std::size_t kFacesOfEdit = 6, kEditsWithoutScript = 1000;
constexpr std::size_t kElementsOfEdit = 20;

using Integers = std::vector<std::uint32_t>;

/// Ends of lines, for arrays of the page.
struct Ends {
  std::vector<double> ax, ay, bx, by;

  void add(const Point& a, const Point& b) {
    const PointD p = nearest(a), q = nearest(b);
    ax.push_back(p.x);
    ay.push_back(p.y);
    bx.push_back(q.x);
    by.push_back(q.y);
  }
  void put_into(PageArrays& arrays, const std::string& name) const {
    arrays.add(name + ".ax", ax);
    arrays.add(name + ".ay", ay);
    arrays.add(name + ".bx", bx);
    arrays.add(name + ".by", by);
  }
};

std::uint32_t whole(std::size_t value) { return static_cast<std::uint32_t>(value); }

void add_lines(PageArrays& arrays, const std::vector<LinePart>& parts) {
  Integers fates;
  Ends ends;
  for (const LinePart& part : parts) {
    fates.push_back(whole(static_cast<std::size_t>(part.fate)));
    ends.add(part.segment.a, part.segment.b);
  }
  arrays.add("lines.fate", fates);
  ends.put_into(arrays, "lines");
}

/// Of each edit its lines before, then those after.
void add_edits(PageArrays& arrays, const std::vector<Edit>& edits) {
  Integers before, after;
  Ends ends;
  for (const Edit& edit : edits) {
    before.push_back(whole(edit.before.size()));
    after.push_back(whole(edit.after.size()));
    for (const auto* lines : {&edit.before, &edit.after}) {
      for (const Line& line : *lines) ends.add(line.a, line.b);
    }
  }
  arrays.add("edits.before", before);
  arrays.add("edits.after", after);
  ends.put_into(arrays, "edits");
}

/// The boundaries of faces: how many each has, how many points each of these.
void add_faces(PageArrays& arrays, const std::vector<ShownFace>& faces, const ExactComplex& before,
               const ExactComplex& after) {
  Integers rings, points;
  std::vector<double> x, y;
  for (const ShownFace& face : faces) {
    const ExactComplex& complex = face.is_after ? after : before;
    std::vector<CycleId> cycles{complex.face_outer[face.face]};
    for (const CycleId hole : complex.face_holes[face.face]) cycles.push_back(hole);
    rings.push_back(whole(cycles.size()));
    for (const CycleId cycle : cycles) {
      points.push_back(whole(complex.cycles[cycle].size()));
      for (const HalfedgeId h : complex.cycles[cycle]) {
        const PointD p = complex.vertices.nearest(complex.origin(h));
        x.push_back(p.x);
        y.push_back(p.y);
      }
    }
  }
  arrays.add("faces.rings", rings);
  arrays.add("faces.points", points);
  arrays.add("faces.x", x);
  arrays.add("faces.y", y);
}

std::vector<std::string> element_texts(const SegmentSet& input,
                                       const std::vector<SegmentId>& segments) {
  std::vector<std::string> texts;
  for (const SourceId source : sources_of(input, segments)) {
    if (texts.size() == kElementsOfEdit) {
      texts.emplace_back("\u2026");
      break;
    }
    const Source& from = input.sources[source];
    texts.push_back(to_text(from, input.files) + (from.layer.empty() ? "" : " on " + from.layer));
  }
  return texts;
}

std::string json_of(const Repair& repair, const SegmentSet& input,
                    const std::vector<ShownFace>& faces, const PageArrays& arrays) {
  using namespace json;
  const std::vector<std::string> rooms = room_texts(repair, kFacesOfEdit);
  const std::vector<double> areas = effects(repair);
  const auto shared = [&input](std::size_t number, const auto& of,
                               const std::vector<SegmentId>& segments) {
    return members(member("number", number), member("kind", to_text(of.kind)),
                   member("size", nearest_sqrt(of.squared_size)),
                   member("squared_size", exact_text(of.squared_size)),
                   member("where", place(of.where)),
                   member("at", place_text_of(of.where, of.squared_size)),
                   member("element", element_text(input, segments)),
                   member("elements", element_texts(input, segments)));
  };
  const auto edit = [&](std::size_t e) {
    return object(shared(e + 1, repair.edits[e], segments_of(repair.edits[e])),
                  member("message", rooms[e]), member("area", areas[e]));
  };
  const auto refusal = [&](std::size_t r) {
    const Refusal& refused = repair.refused[r];
    return object(shared(r + 1, refused, refused.segments), member("message", refused.reason));
  };
  const auto face = [&](std::size_t f) {
    return object(member("number", f + 1), member("kind", faces[f].what),
                  member("title", faces[f].title), member("is_after", faces[f].is_after),
                  member("is_other", faces[f].is_other), member("area", faces[f].area),
                  member("where", place(faces[f].where)),
                  member("edits", list(faces[f].edits, [](std::size_t e) { return e + 1; })));
  };
  const auto entry = [](const PageArrays::Entry& e) {
    return object(member("name", e.name), member("type", e.type), member("count", e.count),
                  member("reference", e.reference), member("index", e.index));
  };
  return document(object(
      member("line", repair_line(repair)), member("tolerances", to_text(repair.tolerances)),
      member("reasons", repair.reasons), member("anchored", repair.anchored.size()),
      member("y_up", input.y_up), member("edits", list(repair.edits.size(), edit)),
      member("refused", list(repair.refused.size(), refusal)),
      member("faces", list(faces.size(), face)), member("arrays", list(arrays.entries(), entry))));
}

}  // namespace

std::string to_html(const Repair& repair, const SegmentSet& input, const ExactComplex& before,
                    const ExactComplex& after) {
  const std::vector<ShownFace> faces = shown_faces(repair, after);
  PageArrays arrays;
  add_lines(arrays, line_parts(input, repair));
  add_edits(arrays, repair.edits);
  add_faces(arrays, faces, before, after);
  return page_with_data(svg::sheet::titled(input, "repair"),
                        std::string(kPageStyle) + std::string(kRepairStyle), kRepairBody,
                        to_text(repair, input, kEditsWithoutScript),
                        {json_of(repair, input, faces, arrays), arrays.bytes()}, kRepairScript);
}

}  // namespace plumbline
