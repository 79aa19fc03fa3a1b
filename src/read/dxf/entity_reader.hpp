#pragma once

#include <optional>
#include <string>

#include "read/dxf/mline.hpp"
#include "read/dxf/polyline.hpp"
#include "read/dxf/space.hpp"
#include "read/dxf/tables.hpp"

namespace plumbline::dxf {

inline constexpr const char* kInPaperSpace = "in paper space";

/// Puts the entities of a drawing, record by record, into their spaces; a POLYLINE with the records
/// that follow it.
class EntityReader {
 public:
  /// Requires: the first five outlive the reader. Throws: Error BadInput for bad options.
  EntityReader(Drawing& drawing, const Names& names, Layers& layers, MlineStyles& styles,
               Numbers& numbers, const ReadOptions& options, const Rational& least_tolerance);

  bool has_curves() const { return pen_.has_curves(); }
  /// Takes the next entity of a space.
  void visit(const Record& record, std::size_t space);
  /// Draws a POLYLINE that waits for more vertices. To be called at the end of each space.
  void finish();
  /// The record as a source: its line, its type and its handle.
  Source source(const Record& record) const;

 private:
  /// A POLYLINE whose vertices are being collected; without a value for one that is left out.
  struct Open {
    Source source;
    std::string layer;
    std::size_t space;
    std::optional<Polyline> polyline;
    bool has_height = false;
  };

  void add(const Entity& entity, const Source& source, std::size_t space);
  /// Whether the entity is not to be seen, which is then listed.
  bool hides(const Entity& entity, const Source& source, Space& in, const Layers::Layer& layer);
  bool is_drawn(std::string_view type) const;
  DrawnEntity drawn(const Entity& entity);
  void open_polyline(const Entity& entity, const Source& source, std::size_t space,
                     const std::string& layer);
  void add_vertex(const Entity& entity, const Source& source);
  void add_insert(const Entity& entity, const Source& source, std::size_t space,
                  const Layers::Layer& layer);
  void add_text(const Entity& entity, const Source& source, Space& in, const std::string& layer);
  void add_drawn(DrawnEntity drawn, const Source& source, std::size_t space,
                 const std::string& layer, bool has_height);

  Drawing& drawing_;
  const Names& names_;
  Layers& layers_;
  MlineStyles& styles_;
  Numbers& numbers_;
  Pen pen_;
  std::optional<Open> open_;
  bool hides_attributes_ = false;  ///< those of the last INSERT
};

}  // namespace plumbline::dxf
