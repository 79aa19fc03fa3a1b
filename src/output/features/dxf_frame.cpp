// Header, tables, blocks and objects that programs expect of a DXF R2000 file. Handles below 100
// (hexadecimal) are those that AutoCAD itself gives.

#include "output/features/dxf_frame.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace plumbline::features {
namespace {

constexpr const char* kPaperSpace = "1B";
constexpr const char* kPlotStyle = "F";

class Frame {
 public:
  Frame(const DxfFrame& frame, Groups entities) : frame_(frame), entities_(std::move(entities)) {}

  std::string file() {
    std::string text = entities_.take();
    tables();
    Groups head;
    header(head);
    text.insert(0, head.take() + tables_ + blocks() + section("ENTITIES"));
    ((text += "0\nENDSEC\n") += objects()) += "0\nEOF\n";
    return text;
  }

 private:
  static std::string section(const std::string& name) { return "0\nSECTION\n2\n" + name + "\n"; }

  void header(Groups& out) const {
    if (!frame_.comment.empty()) out.text(999, dxf_text(frame_.comment));
    out.append(section("HEADER"));
    const auto variable = [&out](const char* name) { out.text(9, name); };
    variable("$ACADVER");
    out.text(1, "AC1015");
    variable("$DWGCODEPAGE");
    out.text(3, "ANSI_1252");
    variable("$INSUNITS");
    out.integer(70, frame_.unit);
    variable("$EXTMIN");
    out.point(10, frame_.least);
    variable("$EXTMAX");
    out.point(10, frame_.greatest);
    variable("$HANDSEED");
    out.text(5, handle_seed_);
    out.append("0\nENDSEC\n" + section("CLASSES") + "0\nENDSEC\n");
  }

  /// A record of a table: its type, handle, table and class.
  static void record(Groups& out, const char* type, const char* table, const char* subclass,
                     const char* handle = nullptr) {
    out.text(0, type);
    handle == nullptr ? static_cast<void>(out.handle()) : out.text(5, handle);
    out.text(330, table);
    out.text(100, "AcDbSymbolTableRecord");
    out.text(100, subclass);
  }

  static void table(Groups& out, const char* name, const char* handle, std::size_t count) {
    out.text(0, "TABLE");
    out.text(2, name);
    out.text(5, handle);
    out.text(330, "0");
    out.text(100, "AcDbSymbolTable");
    out.integer(70, static_cast<std::int64_t>(count));
  }

  void tables() {
    Groups& out = entities_;  // which numbers the handles
    out.append(section("TABLES"));
    viewport(out);
    line_types(out);
    layers(out);
    style(out);
    for (const auto& [name, handle] : {std::pair{"VIEW", "6"}, {"UCS", "7"}}) {
      table(out, name, handle, 0);
      out.text(0, "ENDTAB");
    }
    table(out, "APPID", "9", 1);
    record(out, "APPID", "9", "AcDbRegAppTableRecord", "12");
    out.text(2, "ACAD");
    out.integer(70, 0);
    out.text(0, "ENDTAB");
    table(out, "DIMSTYLE", "A", 0);
    out.text(100, "AcDbDimStyleTable");
    out.text(0, "ENDTAB");
    block_records(out);
    out.text(0, "ENDSEC");
    handle_seed_ = out.next_handle();
    tables_ = out.take();
  }

  /// The view that shows the whole drawing.
  void viewport(Groups& out) const {
    constexpr double kMargin = 1.05;
    const PointD size{frame_.greatest.x - frame_.least.x, frame_.greatest.y - frame_.least.y};
    const double height = kMargin * std::max({size.x, size.y, 1e-9});
    table(out, "VPORT", "8", 1);
    record(out, "VPORT", "8", "AcDbViewportTableRecord", "29");
    out.text(2, "*ACTIVE");
    out.integer(70, 0);
    out.flat_point(10, {0, 0});
    out.flat_point(11, {1, 1});
    out.flat_point(12, {frame_.least.x + size.x / 2, frame_.least.y + size.y / 2});
    out.point(16, {0, 0});
    out.point(17, {0, 0});
    out.real(40, height);
    out.real(41, 1);
    out.text(0, "ENDTAB");
  }

  static void line_types(Groups& out) {
    constexpr std::array<std::array<const char*, 3>, 3> kTypes{
        {{"ByBlock", "14", ""}, {"ByLayer", "15", ""}, {"Continuous", "16", "Solid line"}}};
    table(out, "LTYPE", "5", kTypes.size());
    for (const auto& [name, handle, description] : kTypes) {
      record(out, "LTYPE", "5", "AcDbLinetypeTableRecord", handle);
      out.text(2, name);
      out.integer(70, 0);
      out.text(3, description);
      out.integer(72, 65);  // always
      out.integer(73, 0);
      out.real(40, 0);
    }
    out.text(0, "ENDTAB");
  }

  void layers(Groups& out) const {
    const bool has_zero =
        std::ranges::find(frame_.layers, "0", &DxfLayer::name) != frame_.layers.end();
    table(out, "LAYER", "2", frame_.layers.size() + (has_zero ? 0 : 1));
    const auto add = [&out](const DxfLayer& layer, const char* handle) {
      record(out, "LAYER", "2", "AcDbLayerTableRecord", handle);
      out.text(2, layer.name);
      out.integer(70, 0);
      out.integer(62, layer.colour);
      out.text(6, "Continuous");
      out.text(390, kPlotStyle);
    };
    if (!has_zero) add({"0", kWhiteOrBlack}, "10");
    for (const DxfLayer& layer : frame_.layers) add(layer, layer.name == "0" ? "10" : nullptr);
    out.text(0, "ENDTAB");
  }

  static void style(Groups& out) {
    table(out, "STYLE", "3", 1);
    record(out, "STYLE", "3", "AcDbTextStyleTableRecord", "11");
    out.text(2, "Standard");
    out.integer(70, 0);
    out.real(40, 0);
    out.real(41, 1);
    out.real(50, 0);
    out.integer(71, 0);
    out.real(42, 1);
    out.text(3, "txt");
    out.text(4, "");
    out.text(0, "ENDTAB");
  }

  static void block_records(Groups& out) {
    table(out, "BLOCK_RECORD", "1", 2);
    for (const auto& [name, handle] :
         {std::pair{"*Model_Space", kModelSpace}, {"*Paper_Space", kPaperSpace}}) {
      record(out, "BLOCK_RECORD", "1", "AcDbBlockTableRecord", handle);
      out.text(2, name);
    }
    out.text(0, "ENDTAB");
  }

  static std::string blocks() {
    Groups out;
    out.append(section("BLOCKS"));
    constexpr std::array<std::array<const char*, 4>, 2> kBlocks{
        {{"*Model_Space", kModelSpace, "20", "21"}, {"*Paper_Space", kPaperSpace, "1C", "1D"}}};
    for (const auto& [name, record, begin, end] : kBlocks) {
      out.text(0, "BLOCK");
      out.text(5, begin);
      out.text(330, record);
      out.text(100, "AcDbEntity");
      out.text(8, "0");
      out.text(100, "AcDbBlockBegin");
      out.text(2, name);
      out.integer(70, 0);
      out.point(10, {0, 0});
      out.text(3, name);
      out.text(1, "");
      out.text(0, "ENDBLK");
      out.text(5, end);
      out.text(330, record);
      out.text(100, "AcDbEntity");
      out.text(8, "0");
      out.text(100, "AcDbBlockEnd");
    }
    out.text(0, "ENDSEC");
    return out.take();
  }

  static void dictionary(Groups& out, const char* handle, const char* owner) {
    out.text(0, "DICTIONARY");
    out.text(5, handle);
    out.text(330, owner);
    out.text(100, "AcDbDictionary");
    out.integer(281, 1);
  }

  static std::string objects() {
    Groups out;
    out.append(section("OBJECTS"));
    dictionary(out, "C", "0");
    for (const auto& [name, handle] : {std::pair{"ACAD_GROUP", "D"}, {"ACAD_PLOTSTYLENAME", "E"}}) {
      out.text(3, name);
      out.text(350, handle);
    }
    dictionary(out, "D", "C");
    out.text(0, "ACDBDICTIONARYWDFLT");
    out.text(5, "E");
    out.text(330, "C");
    out.text(100, "AcDbDictionary");
    out.integer(281, 1);
    out.text(3, "Normal");
    out.text(350, kPlotStyle);
    out.text(100, "AcDbDictionaryWithDefault");
    out.text(340, kPlotStyle);
    out.text(0, "ACDBPLACEHOLDER");
    out.text(5, kPlotStyle);
    out.text(330, "E");
    out.text(0, "ENDSEC");
    return out.take();
  }

  const DxfFrame& frame_;
  Groups entities_;
  std::string tables_;
  std::string handle_seed_;
};

}  // namespace

std::string dxf_file(const DxfFrame& frame, Groups entities) {
  return Frame(frame, std::move(entities)).file();
}

}  // namespace plumbline::features
