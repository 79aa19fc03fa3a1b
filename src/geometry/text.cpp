// Points and segments as text and as doubles; sources as text.

#include "plumbline/error.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline {

PointD nearest(const Point& p) { return {nearest_double(p.x), nearest_double(p.y)}; }

PointD nearest(const NumberPoint& p) { return {nearest_double(p.x), nearest_double(p.y)}; }

Point exact(const PointD& p) { return {rational_from(p.x), rational_from(p.y)}; }

std::string to_text(const Point& p) { return exact_text(p.x) + " " + exact_text(p.y); }

std::string to_text(const NumberPoint& p) { return to_text(Point{p.x.rational(), p.y.rational()}); }

std::string to_text(const Segment& s) { return to_text(s.a) + ", " + to_text(s.b); }

std::string to_text(const Source& source, const std::vector<std::string>& files) {
  const std::string file = source.file < files.size() ? files[source.file] : "";
  std::string text = to_text(Place{file, source.line, source.column});
  const auto append = [&text](const std::string& part) {
    if (!text.empty()) text += ' ';
    text += part;
  };
  if (!source.element.empty()) append(source.element);
  if (!source.id.empty()) append("#" + source.id);
  if (!source.path.empty()) append("(" + source.path + ")");
  return text;
}

}  // namespace plumbline
