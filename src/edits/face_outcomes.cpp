// Faces whose boundary is the same on both sides match at once; the borders of the others are
// overlaid, and areas in common tell what became of what.

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "edits/edit_lines.hpp"
#include "edits/face_overlay.hpp"

namespace plumbline {
namespace {

using edits::After;
using edits::Before;
using edits::Both;
using edits::Complexes;
using edits::FaceOverlay;
using edits::Side;

/// What a face before and one after have in common.
struct Common {
  Rational area;
  FaceId largest;  ///< of the overlay's faces there
  Rational largest_area;
};

using CommonAreas = std::map<std::pair<FaceId, FaceId>, Common>;  ///< face before, face after

CommonAreas common_areas(const FaceOverlay& overlay) {
  CommonAreas result;
  for (std::size_t f = 1; f < overlay.complex.face_count(); ++f) {
    const std::pair faces(overlay.face[Before][f], overlay.face[After][f]);
    if (faces == std::pair(kUnbounded, kUnbounded)) continue;
    const Rational area = face_area(overlay.complex, FaceId(f));
    Common& common = result[faces];
    common.area += area;
    if (area <= common.largest_area) continue;
    common.largest = FaceId(f);
    common.largest_area = area;
  }
  return result;
}

/// Per side and face the one of the other side with which it shares most.
Both<std::map<FaceId, FaceId>> partners(const CommonAreas& areas) {
  Both<std::map<FaceId, FaceId>> result;
  Both<std::map<FaceId, const Rational*>> most;
  for (const auto& [pair, common] : areas) {  // ascending: of equal ones the first stays
    const Both<FaceId> faces = {pair.first, pair.second};
    for (const Side side : edits::kSides) {
      const Rational*& largest = most[side][faces[side]];
      if (largest && common.area <= *largest) continue;
      largest = &common.area;
      result[side][faces[side]] = faces[1 - side];
    }
  }
  return result;
}

/// Per pair of faces the edges around what they have in common that are a border on one side only.
using ChangedBorders = std::map<std::pair<FaceId, FaceId>, std::vector<EdgeId>>;

ChangedBorders changed_borders(const FaceOverlay& overlay) {
  ChangedBorders result;
  for (std::size_t e = 0; e < overlay.complex.edge_count(); ++e) {
    if (overlay.is_border[Before][e] == overlay.is_border[After][e]) continue;
    for (const bool is_right : {false, true}) {
      const FaceId f = overlay.complex.halfedge_face[halfedge(EdgeId(e), is_right)];
      result[{overlay.face[Before][f], overlay.face[After][f]}].push_back(EdgeId(e));
    }
  }
  return result;
}

std::map<FaceId, Rational> areas_of(const ExactComplex& complex, const std::vector<FaceId>& faces) {
  std::map<FaceId, Rational> result = {{kUnbounded, 0}};
  for (const FaceId f : faces) result[f] = face_area(complex, f);
  return result;
}

class Outcomes {
 public:
  Outcomes(const Complexes& complexes, const Both<std::vector<FaceId>>& changed,
           const std::vector<Edit>& all_edits)
      : changed_(changed),
        face_areas_{areas_of(*complexes[Before], changed[Before]),
                    areas_of(*complexes[After], changed[After])},
        overlay_(edits::overlay(complexes, changed, all_edits)),
        areas_(common_areas(overlay_)),
        partners_(partners(areas_)),
        borders_(changed_borders(overlay_)),
        edit_lines_(all_edits) {}

  std::vector<FaceOutcome> all() const {
    std::map<FaceId, std::size_t> children;
    for (const FaceId f : changed_[After]) ++children[parent(f)];
    std::vector<FaceOutcome> result;
    for (const FaceId f : changed_[After]) {
      const FaceId p = parent(f);
      if (p == kUnbounded) {
        result.push_back(outcome(FaceFate::Closed, p, f));
      } else if (children.at(p) > 1 || heir(p) != f) {
        result.push_back(outcome(FaceFate::Split, p, f));
      } else if (!is_same(p, f)) {
        result.push_back(outcome(FaceFate::Changed, p, f));
      }
    }
    for (const FaceId f : changed_[Before]) {
      const FaceId h = heir(f);
      if (h == kUnbounded) {
        result.push_back(outcome(FaceFate::Opened, f, h));
      } else if (parent(h) != f) {
        result.push_back(outcome(FaceFate::Joined, f, h));
      }
    }
    std::ranges::sort(result, [](const FaceOutcome& o, const FaceOutcome& p) {
      return std::tie(o.fate, o.where, o.before, o.after) <
             std::tie(p.fate, p.where, p.before, p.after);
    });
    return result;
  }

 private:
  FaceId parent(FaceId after) const { return partners_[After].at(after); }
  FaceId heir(FaceId before) const { return partners_[Before].at(before); }

  const Rational& area(Side side, FaceId f) const { return face_areas_[side].at(f); }

  bool is_same(FaceId before, FaceId after) const {
    const Rational& common = areas_.at({before, after}).area;
    return common == area(Before, before) && common == area(After, after);
  }

  FaceOutcome outcome(FaceFate fate, FaceId before, FaceId after) const {
    return {.fate = fate,
            .before = before,
            .after = after,
            .area_before = area(Before, before),
            .area_after = area(After, after),
            .where = interior_point(overlay_.complex, areas_.at({before, after}).largest),
            .edits = edits_between(before, after)};
  }

  /// Those that drew or removed borders of what the faces have in common. If all of its border were
  /// drawn before and after, both faces would be that.
  std::vector<std::size_t> edits_between(FaceId before, FaceId after) const {
    std::vector<std::size_t> result;
    const auto place = borders_.find({before, after});
    if (place == borders_.end()) return result;
    for (const EdgeId e : place->second) {
      const Edge edge = overlay_.complex.edges[e];
      const Segment piece = {overlay_.complex.vertices[edge.tail],
                             overlay_.complex.vertices[edge.head]};
      const std::vector<std::size_t> some = overlay_.is_border[Before][e]
                                                ? edit_lines_.that_removed(piece)
                                                : edit_lines_.that_drew(piece);
      result.insert(result.end(), some.begin(), some.end());
    }
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  const Both<std::vector<FaceId>>& changed_;
  const Both<std::map<FaceId, Rational>> face_areas_;
  const FaceOverlay overlay_;
  const CommonAreas areas_;
  const Both<std::map<FaceId, FaceId>> partners_;
  const ChangedBorders borders_;
  const edits::EditLines edit_lines_;
};

}  // namespace

std::vector<FaceOutcome> face_outcomes(const ExactComplex& before, const Repair& repair,
                                       const ExactComplex& after) {
  const Complexes complexes = {&before, &after};
  const Both<std::vector<FaceId>> changed = edits::changed_faces(complexes);
  if (changed[Before].empty() && changed[After].empty()) return {};
  return Outcomes(complexes, changed, repair.edits).all();
}

}  // namespace plumbline
