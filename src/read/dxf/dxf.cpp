// DXF -> Structure: one walk over the records; spaces are put together at its end.

#include <optional>
#include <utility>

#include "plumbline/error.hpp"
#include "plumbline/read.hpp"
#include "read/drawing_tolerance.hpp"
#include "read/dxf/binary.hpp"
#include "read/dxf/entity_reader.hpp"
#include "read/dxf/space.hpp"
#include "read/dxf/tables.hpp"
#include "structure/dxf_units.hpp"

namespace plumbline {
namespace dxf {
namespace {

// Groups of a BLOCK.
constexpr int kName = 2;
constexpr int kBase = 10;
constexpr int kExternalPath = 1;
constexpr std::int64_t kExternal = 4 | 8;  ///< reference or overlay

enum class Section { None, Tables, Blocks, Entities, Other };

Section section_named(std::string_view name) {
  if (name == "TABLES") return Section::Tables;
  if (name == "BLOCKS") return Section::Blocks;
  if (name == "ENTITIES") return Section::Entities;
  return Section::Other;  // what they hold draws nothing
}

bool is_model_space(const std::string& key) {
  return key == "*model_space" || key == "$model_space";
}

bool is_paper_space(const std::string& key) {
  return key.starts_with("*paper_space") || key.starts_with("$paper_space");
}

class DxfReader {
 public:
  DxfReader(std::string_view text, const std::string& file_name, const ReadOptions& options,
            const Rational& least_tolerance)
      : file_name_(file_name),
        records_(text, file_name),
        numbers_(options.shortest_decimals),
        layers_(names_, options),
        styles_(text, file_name, names_),
        entities_(drawing_, names_, layers_, styles_, numbers_, options, least_tolerance) {}

  bool has_curves() const { return entities_.has_curves(); }

  Structure read() {
    bool ended = false;
    while (!ended && records_.next(record_)) {
      ended = record_.type == "EOF";
      if (!ended) visit();
    }
    if (!has_section_) {
      throw Error(ErrorCode::BadInput, "no section: this is no DXF text", {file_name_, 1, 0});
    }
    entities_.finish();
    if (!ended) {
      const Source end{0, records_.line(), 0, "EOF", {}, {}};
      if (section_ == Section::None) {
        drawing_.tally.remark(end, "the file ends without EOF");
      } else {
        drawing_.tally.leave_out(end, "the file ends inside a section", false);
      }
    }
    layers_.check_choice(file_name_);
    Structure structure = std::move(drawing_).structure(file_name_);
    structure.layers = layers_.declared();
    structure.unit = std::move(unit_);
    numbers_.add_to(structure.ledger);
    return structure;
  }

 private:
  void visit() {
    if (record_.type == "SECTION") return open_section();
    if (record_.type == "ENDSEC") return close_section();
    switch (section_) {
      case Section::None:
        return leave_out("outside of any section", false);
      case Section::Tables:
        return visit_table();
      case Section::Blocks:
        return visit_block();
      case Section::Entities:
        return entities_.visit(record_, 0);
      case Section::Other:
        return;
    }
  }

  Entity entity() { return {record_, numbers_}; }

  void leave_out(const char* reason, bool harmless) {
    drawing_.tally.leave_out(entities_.source(record_), reason, harmless);
  }

  void open_section() {
    close_section();
    has_section_ = true;
    const std::string_view name = entity().text(kName);
    section_ = section_named(name);
    if (name != "HEADER") return;
    const Header header = header_of(record_);
    names_.set_encoding(header.version, header.code_page);
    if (std::int64_t code = 0; parse_integer(header.units, code)) unit_ = unit_of_code(code);
  }

  void close_section() {
    entities_.finish();
    section_ = Section::None;
    block_.reset();
    inside_block_ = false;
  }

  void visit_table() {
    if (record_.type != "LAYER") return;
    try {
      layers_.add(entity());
    } catch (const Unusable& problem) {
      drawing_.tally.refuse(entities_.source(record_), {problem.reason, problem.text, true});
    }
  }

  void visit_block() {
    if (record_.type == "BLOCK") {
      open_block();
    } else if (record_.type == "ENDBLK") {
      entities_.finish();
      inside_block_ = false;
      block_.reset();
    } else if (block_) {
      entities_.visit(record_, *block_);
    } else if (!inside_block_) {
      leave_out("outside of any block", false);
    } else if (block_problem_ != nullptr) {
      leave_out(block_problem_, block_problem_ == kInPaperSpace);
    }
  }

  /// Sets the space that the following entities are in, or why they are in none.
  void open_block() {
    entities_.finish();
    inside_block_ = true;
    block_.reset();
    block_problem_ = nullptr;
    const std::string_view name = entity().text(kName);
    const std::string key = names_.key(name);
    if (is_model_space(key)) {
      block_ = 0;
    } else if (is_paper_space(key)) {
      block_problem_ = kInPaperSpace;
    } else if (drawing_.blocks.count(key) != 0) {
      block_problem_ = "in the second definition of a block";
    } else {
      add_block(key);
    }
  }

  void add_block(const std::string& key) {
    Space space;
    space.name = names_.utf8(entity().text(kName));
    space.line = record_.line;
    try {
      if (entity().has(kBase)) space.base = entity().exact_point(kBase);
      if ((entity().integer(kFlags, 0) & kExternal) != 0) {
        space.tally.refuse(entities_.source(record_), {"external reference is not followed",
                                                       names_.utf8(entity().text(kExternalPath))});
      }
    } catch (const Unusable& problem) {
      block_problem_ = "in a block that is refused";
      drawing_.tally.refuse(entities_.source(record_), problem);
      return;
    }
    block_ = drawing_.spaces.size();
    drawing_.blocks.emplace(key, *block_);
    drawing_.spaces.push_back(std::move(space));
  }

  const std::string& file_name_;
  RecordReader records_;
  Record record_;
  Numbers numbers_;
  Names names_;
  Layers layers_;
  Drawing drawing_;
  MlineStyles styles_;
  EntityReader entities_;
  std::optional<LengthUnit> unit_;
  Section section_ = Section::None;
  bool has_section_ = false;
  bool inside_block_ = false;
  std::optional<std::size_t> block_;  ///< the space of the open block
  const char* block_problem_ = nullptr;
};

}  // namespace
}  // namespace dxf

Structure read_dxf(std::string_view text, const std::string& file_name,
                   const ReadOptions& options) {
  std::string converted;
  if (dxf::is_binary(text)) text = converted = dxf::text_of_binary(text, file_name);
  const auto read = [&](const ReadOptions& how, const Rational& least_tolerance) {
    dxf::DxfReader reader(text, file_name, how, least_tolerance);
    Structure drawing = reader.read();
    return Reading{std::move(drawing), reader.has_curves()};
  };
  Structure structure = read_within_tolerance(options, read);
  structure.angle_bound = options.angle_bound;
  return structure;
}

}  // namespace plumbline
