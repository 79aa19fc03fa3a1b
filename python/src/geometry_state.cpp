// Segments as pickle keeps them: arrays of numbers, tuples of all else.

#include <nanobind/stl/array.h>
#include <nanobind/stl/tuple.h>

#include <array>
#include <tuple>

#include "core.hpp"
#include "plumbline/geometry.hpp"

namespace plumbline::python {
namespace {

using Texts = std::vector<std::string>;
using Mantissas = nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Digits = nb::ndarray<const std::int8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Indices = nb::ndarray<const std::uint32_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Doubles = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// Instead of a count of digits: the number is a text, its mantissa which one.
constexpr std::int8_t kText = -1;

/// Decimals as mantissas and digits; other numbers as texts.
using NumberState = std::tuple<nb::object, nb::object, Texts>;

NumberState number_state(const SegmentSet& set) {
  std::vector<std::int64_t> mantissas;
  std::vector<std::int8_t> digits;
  Texts texts;
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    for (const Number& number : set.segments.numbers(i)) {
      const bool decimal = number.is_decimal();
      mantissas.push_back(decimal ? number.mantissa() : static_cast<std::int64_t>(texts.size()));
      digits.push_back(decimal ? static_cast<std::int8_t>(number.digits()) : kText);
      if (!decimal) texts.push_back(number.rational().get_str(16));
    }
  }
  return {array(std::move(mantissas)), array(std::move(digits)), std::move(texts)};
}

void set_numbers(SegmentSet& set, const NumberState& state) {
  const auto mantissas = nb::cast<Mantissas>(std::get<0>(state));
  const auto digits = nb::cast<Digits>(std::get<1>(state));
  const Texts& texts = std::get<2>(state);
  const auto number = [&](std::size_t i) {
    const std::int64_t mantissa = mantissas.data()[i];
    if (digits.data()[i] != kText) return Number::decimal(mantissa, digits.data()[i]);
    return Number(Rational(texts.at(static_cast<std::size_t>(mantissa)), 16));
  };
  for (std::size_t i = 0; i + 3 < mantissas.shape(0); i += 4) {
    set.segments.push_back({number(i), number(i + 1)}, {number(i + 2), number(i + 3)});
  }
}

using SourceState = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::string,
                               std::string, std::string, std::string>;

SourceState state_of(const Source& s) {
  return {s.file, s.line, s.column, s.element, s.id, s.path, s.layer};
}
Source source_of(const SourceState& s) {
  return {std::get<0>(s), std::get<1>(s), std::get<2>(s), std::get<3>(s),
          std::get<4>(s), std::get<5>(s), std::get<6>(s)};
}

using RejectedState = std::tuple<SourceState, std::string, std::string, bool>;
using RemarkState = std::tuple<SourceState, std::string, std::string>;
using LabelState = std::tuple<std::uint32_t, std::string, std::optional<Texts>, double>;
using LayerState = std::tuple<std::string, std::optional<std::uint32_t>, bool>;
using RingState = std::array<std::uint32_t, 3>;
using UnitState = std::optional<std::array<std::string, 2>>;

Texts texts_of(const Point& p) { return {p.x.get_str(), p.y.get_str()}; }
Point point_of(const Texts& texts) { return {Rational(texts.at(0)), Rational(texts.at(1))}; }

/// What there is apart from segments, in the order of SegmentSet's members.
using RestState = std::tuple<std::vector<RingState>, std::vector<Texts>, std::vector<std::uint32_t>,
                             std::vector<LabelState>, std::vector<LayerState>,
                             std::vector<RejectedState>, std::vector<RemarkState>,
                             std::vector<RemarkState>, std::string, UnitState, double, bool>;

RestState rest_state(const SegmentSet& set) {
  RestState state;
  auto& [rings, points, point_source, labels, layers, rejected, remarks, ledger, crs, unit,
         authored_unit, y_up] = state;
  for (const Ring& r : set.rings) {
    rings.push_back({r.first, r.count, static_cast<std::uint32_t>(r.role)});
  }
  for (const Point& p : set.points) points.push_back(texts_of(p));
  for (const SourceId s : set.point_source) point_source.push_back(static_cast<std::uint32_t>(s));
  for (const Label& label : set.labels) {
    labels.emplace_back(static_cast<std::uint32_t>(label.source), label.text,
                        label.place ? std::optional(texts_of(*label.place)) : std::nullopt,
                        label.height);
  }
  for (const Layer& layer : set.layers) layers.emplace_back(layer.name, layer.rgb, layer.hidden);
  for (const Rejected& item : set.rejected) {
    rejected.emplace_back(state_of(item.source), item.reason, item.text, item.harmless);
  }
  for (const Remark& item : set.remarks) {
    remarks.emplace_back(state_of(item.source), item.what, item.text);
  }
  for (const Replacement& item : set.ledger) {
    ledger.emplace_back(state_of(item.source), item.what, item.bound);
  }
  crs = set.crs;
  if (set.unit) unit = {set.unit->name, set.unit->metres.get_str()};
  authored_unit = set.authored_unit;
  y_up = set.y_up;
  return state;
}

void set_rest(SegmentSet& set, const RestState& state) {
  const auto& [rings, points, point_source, labels, layers, rejected, remarks, ledger, crs, unit,
               authored_unit, y_up] = state;
  for (const RingState& r : rings) set.rings.push_back({r[0], r[1], static_cast<RingRole>(r[2])});
  for (const Texts& p : points) set.points.push_back(point_of(p));
  for (const std::uint32_t s : point_source) set.point_source.emplace_back(s);
  for (const auto& [source, text, place, height] : labels) {
    set.labels.push_back(
        {SourceId(source), text, place ? std::optional(point_of(*place)) : std::nullopt, height});
  }
  for (const auto& [name, rgb, hidden] : layers) set.layers.push_back({name, rgb, hidden});
  for (const auto& [source, reason, text, harmless] : rejected) {
    set.rejected.push_back({source_of(source), reason, text, harmless});
  }
  for (const auto& [source, what, text] : remarks) {
    set.remarks.push_back({source_of(source), what, text});
  }
  for (const auto& [source, what, bound] : ledger) {
    set.ledger.push_back({source_of(source), what, bound});
  }
  set.crs = crs;
  if (unit) set.unit = LengthUnit{(*unit)[0], Rational((*unit)[1])};
  set.authored_unit = authored_unit;
  set.y_up = y_up;
}

using State = std::tuple<std::vector<std::string>, std::vector<SourceState>, NumberState,
                         nb::object, nb::object, RestState>;

State state_of(const SegmentSet& set) {
  std::vector<SourceState> sources;
  sources.reserve(set.sources.size());
  for (const Source& s : set.sources) sources.push_back(state_of(s));
  const std::uint32_t* item = numbers(set.segment_source);
  return {set.files,
          std::move(sources),
          number_state(set),
          array(std::vector<std::uint32_t>(item, item + set.segment_source.size())),
          array(std::vector<double>(set.rounding)),
          rest_state(set)};
}

SegmentSet set_of(const State& state) {
  const auto& [files, sources, numbers, item, rounding, rest] = state;
  SegmentSet set;
  set.files = files;
  for (const SourceState& s : sources) set.sources.push_back(source_of(s));
  set_numbers(set, numbers);
  const auto items = nb::cast<Indices>(item);
  for (std::size_t i = 0; i < items.shape(0); ++i) set.segment_source.emplace_back(items.data()[i]);
  const auto roundings = nb::cast<Doubles>(rounding);
  set.rounding.assign(roundings.data(), roundings.data() + roundings.shape(0));
  set_rest(set, rest);
  return set;
}

}  // namespace

void bind_state(nb::class_<SegmentSet>& type) {
  type.def("__getstate__", [](const SegmentSet& set) { return state_of(set); })
      .def("__setstate__",
           [](SegmentSet& set, const State& state) { new (&set) SegmentSet(set_of(state)); });
}

}  // namespace plumbline::python
