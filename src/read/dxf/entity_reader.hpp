#pragma once

#include <optional>
#include <string>

#include "read/dxf/polyline.hpp"
#include "read/dxf/space.hpp"
#include "read/dxf/tables.hpp"

namespace plumbline::dxf {

inline constexpr const char* kInPaperSpace = "in paper space";

/// Puts the entities of a drawing, record by record, into their spaces; a POLYLINE with the records
/// that follow it.
class EntityReader {
 public:
  /// Requires: the first four outlive the reader. Throws: Error BadInput for bad options.
  EntityReader(Drawing& drawing, const Names& names, const Layers& layers, Numbers& numbers,
               const ReadOptions& options);

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
  std::string reason_to_hide(const Entity& entity, const Layers::Layer& layer, bool in_block) const;
  void open_polyline(const Entity& entity, const Source& source, std::size_t space,
                     const std::string& layer);
  void add_vertex(const Entity& entity, const Source& source);
  void add_insert(const Entity& entity, const Source& source, std::size_t space,
                  const Layers::Layer& layer);
  void add_drawn(DrawnEntity drawn, const Source& source, std::size_t space,
                 const std::string& layer, bool has_height);

  Drawing& drawing_;
  const Names& names_;
  const Layers& layers_;
  Numbers& numbers_;
  Pen pen_;
  std::optional<Open> open_;
};

}  // namespace plumbline::dxf
