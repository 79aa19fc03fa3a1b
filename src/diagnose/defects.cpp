// The bounded list of defects, and its order.

#include <algorithm>

#include "diagnose/steps.hpp"

namespace plumbline::diagnose_steps {
namespace {

bool is_longest_first(DefectKind kind) {
  return kind == DefectKind::Duplicate || kind == DefectKind::Overlap || kind == DefectKind::Bridge;
}

/// The order of `diagnose`, within a kind. Total: two defects of a kind at the same place are of
/// other cells.
bool is_before(const Defect& a, const Defect& b) {
  if (a.open_area != b.open_area) return a.open_area > b.open_area;
  if (a.ring && b.ring && a.ring->fault != b.ring->fault) return a.ring->fault < b.ring->fault;
  if (a.size != b.size) return is_longest_first(a.kind) ? a.size > b.size : a.size < b.size;
  if (a.squared_size && b.squared_size && *a.squared_size != *b.squared_size) {
    return is_longest_first(a.kind) ? *a.squared_size > *b.squared_size
                                    : *a.squared_size < *b.squared_size;
  }
  if (!(a.where == b.where)) return a.where < b.where;
  if (a.vertices != b.vertices) return a.vertices < b.vertices;
  if (a.edges != b.edges) return a.edges < b.edges;
  return a.segments < b.segments;
}

std::size_t index(DefectKind kind) { return static_cast<std::size_t>(kind); }

}  // namespace

void Defects::keep_most_relevant(std::vector<Defect>& defects) const {
  std::sort(defects.begin(), defects.end(), is_before);
  if (defects.size() > most_listed_) defects.resize(most_listed_);
}

void Defects::add(Defect defect) {
  ++found_[index(defect.kind)];
  if (defect.proposed_tolerance) tolerances_.push_back(*defect.proposed_tolerance);
  std::vector<Defect>& defects = listed_[index(defect.kind)];
  defects.push_back(std::move(defect));
  // So often that what is kept stays bounded, so seldom that sorting costs little.
  if (defects.size() > 4 * most_listed_ + 1000) keep_most_relevant(defects);
}

void Defects::add_unlisted(DefectKind kind, std::size_t count, double proposed_tolerance) {
  found_[index(kind)] += count;
  tolerances_.insert(tolerances_.end(), count, proposed_tolerance);
}

void Defects::append(Defects other) {
  for (std::size_t kind = 0; kind < kDefectKinds; ++kind) {
    found_[kind] += other.found_[kind];
    std::move(other.listed_[kind].begin(), other.listed_[kind].end(),
              std::back_inserter(listed_[kind]));
  }
  tolerances_.insert(tolerances_.end(), other.tolerances_.begin(), other.tolerances_.end());
  accidents_.insert(accidents_.end(), other.accidents_.begin(), other.accidents_.end());
  cut_short_ += other.cut_short_;
}

std::vector<Defect> Defects::take_listed() {
  std::vector<Defect> result;
  for (std::vector<Defect>& defects : listed_) {
    keep_most_relevant(defects);
    std::move(defects.begin(), defects.end(), std::back_inserter(result));
    defects.clear();
  }
  return result;
}

std::vector<double> Defects::proposed_tolerances() const {
  std::vector<double> result = tolerances_;
  std::sort(result.begin(), result.end());
  return result;
}

Point midpoint(const Point& p, const Point& q) { return {(p.x + q.x) / 2, (p.y + q.y) / 2}; }

}  // namespace plumbline::diagnose_steps
