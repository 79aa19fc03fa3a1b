// The options that several commands have.

#include <charconv>
#include <cmath>

#include "cli/options.hpp"
#include "cli/suggestions.hpp"
#include "plumbline/error.hpp"

namespace plumbline::cli {
namespace {

constexpr const char* kFile =
    "A drawing: .svg, .svgz, .dxf, .lines, .geojson, .json, .wkt, .wkb or .csv; - is standard "
    "input";

/// A number of bytes: "512M", "4G", "4GiB"; powers of 1024.
std::uint64_t bytes(const std::string& size) {
  std::string number = size;
  const bool is_negative = size.find('-') != size.npos;
  const std::string wrong = CLI::AsSizeValue(false)(number);
  std::uint64_t result = 0;
  if (is_negative || !wrong.empty() || !CLI::detail::lexical_cast(number, result) || result == 0) {
    throw Error(ErrorCode::BadInput, "not a size, as 500M or 4G", {}, size);
  }
  return result;
}

double seconds(const std::string& text) {
  constexpr double kMost = 1e9;  // three decades
  double result = 0;
  if (CLI::detail::lexical_cast(text, result) && result > 0 && result <= kMost) return result;
  throw Error(ErrorCode::BadInput, "not a positive number of seconds, at most 1e9", {}, text);
}

}  // namespace

std::string file_of(const std::string& argument) {
  return argument == "-" ? "/dev/stdin" : argument;
}

void add_size(CLI::App& command, const std::string& name, std::optional<Rational>& size,
              const std::string& what) {
  command
      .add_option_function<std::string>(
          name,
          [&size, name](const std::string& text) {
            try {
              size = parse_decimal(text);
            } catch (const Error&) {
              throw Error(ErrorCode::BadInput, name + " is a number, in drawing units", {}, text);
            }
          },
          what)
      ->type_name("SIZE");
}

CLI::Validator integer(std::int64_t least, std::int64_t most) {
  const auto refuse = [least, most](const std::string& text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_integer = error == std::errc() && end == text.data() + text.size();
    if (is_integer && value >= least && value <= most) return std::string();
    std::string range;
    if (most != kAnyInteger) {
      range = " from " + std::to_string(least) + " to " + std::to_string(most);
    } else if (least == 0) {
      range = " of 0 or more";
    }
    return "not an integer" + range + ": " + text;
  };
  return {refuse, ""};
}

CLI::Validator positive() {
  const auto refuse = [](const std::string& text) {
    double value = 0;
    const bool is_right =
        CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0;
    return is_right ? std::string() : "not a finite, positive number: " + text;
  };
  return {refuse, ""};
}

CLI::Validator radius() {
  const auto refuse = [](const std::string& text) -> std::string {
    // What has digits is told of as a number.
    if (is_preset(text) || text.empty() || text.find_first_of("0123456789") != text.npos) return "";
    const std::vector<std::string> presets(kRadiusPresets.begin(), kRadiusPresets.end());
    const std::string meant = did_you_mean(text, presets);
    return "not " + text + (meant.empty() ? ", but " : meant + " It is ") +
           "a number, larlib, plasm or drawing";
  };
  return {refuse, "larlib|plasm|drawing"};
}

CLI::Validator finite() {
  const auto refuse = [](const std::string& text) {
    double value = 0;
    const bool is_finite = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
    return is_finite ? std::string() : "not a finite number: " + text;
  };
  return {refuse, ""};
}

void add_common(CLI::App& command, CommonArguments& arguments) {
  Limits& limits = arguments.limits;
  command.option_defaults()->group("Common");
  CLI::Option* json =
      command.add_flag("--json", arguments.json, "Say what is found as one JSON object");
  CLI::Option* quiet =
      command.add_flag("-q,--quiet", arguments.quiet, "Say nothing but errors")->excludes(json);
  command
      .add_flag("-v,--verbose", arguments.verbose, "Say on standard error how long each part takes")
      ->excludes(quiet);
  command
      .add_option_function<std::string>(
          "--max-memory",
          [&](const std::string& size) {
            limits.bytes = bytes(size);
            limits.memory = size;
          },
          "Give up, with exit code 2, where more memory would be needed; 500M, 4G [default: what "
          "there is]")
      ->type_name("SIZE");
  command
      .add_option_function<std::string>(
          "--timeout", [&](const std::string& text) { limits.seconds = seconds(text); },
          "Give up after so long, with exit code 2 [default: never]")
      ->type_name("SECONDS");
}

namespace {

void add_layers(CLI::App& command, InputArguments& arguments) {
  command.option_defaults()->group("Layers");
  ReadOptions& reading = arguments.reading;
  command
      .add_option(
          "--layers", reading.layers,
          "Read these layers only: names with * and ?, in any case, several with commas; of "
          "SVG also ids and labels of groups and shapes; of GeoJSON what --layer-property "
          "says")
      ->delimiter(',')
      ->type_name("GLOB");
  command.add_option("--without-layers", reading.without_layers, "Leave these layers out")
      ->delimiter(',')
      ->type_name("GLOB");
  command
      .add_option("--layer-property", reading.layer_property,
                  "The property of GeoJSON features that names their layer [default: layer]")
      ->type_name("NAME");
  command.add_flag("--hidden", reading.hidden,
                   "Also draw what the drawing hides: layers that are off, frozen or not printed, "
                   "what is not displayed; else it is left out and listed");
  command.add_flag(
      "--hatches", reading.hatches,
      "Also draw the boundaries of a DXF's hatches, each on a layer of its own: that of "
      "the hatch with \" HATCH\" behind its name");
  command
      .add_flag_callback(
          "--visible",
          [&] {
            arguments.notes.emplace_back(
                "--visible has no effect now: what is hidden is left out unless --hidden is given");
          },
          "")
      ->group("");
}

}  // namespace

void add_file(CLI::App& command, InputArguments& arguments, const char* what) {
  command
      .add_option_function<std::string>(
          "FILE", [&](const std::string& name) { arguments.file = file_of(name); },
          what == nullptr ? kFile : what)
      ->required()
      ->type_name("");
}

void add_reading(CLI::App& command, InputArguments& arguments) {
  command.option_defaults()->group("Reading");
  command
      .add_option("--from", arguments.reading.format,
                  "Format of FILE: " + listed({kFormats.begin(), kFormats.end()}) +
                      " [default: by the file's ending; without one, as on standard input, by its "
                      "first bytes]")
      ->transform(one_of({kFormats.begin(), kFormats.end()}))
      ->type_name("FORMAT");
  command
      .add_option_function<std::string>(
          "--flatten",
          [&](const std::string& tolerance) {
            arguments.reading.chord_tolerance = parse_decimal(tolerance);
            if (sgn(arguments.reading.chord_tolerance) > 0) return;
            throw Error(ErrorCode::BadInput, "the tolerance of curves is not positive", {},
                        tolerance);
          },
          "Curves become chords no further than this from the curve, in the units of the curve's "
          "own coordinates [default: 0.001 x the curve's longer side; of small curves 0.0002 x the "
          "drawing's, at most 0.1 x their own]")
      ->type_name("TOLERANCE");
  command
      .add_option("--angle", arguments.reading.angle_bound,
                  "Rotations become rational ones, their angles within this [default: 1e-15]")
      ->check(positive())
      ->type_name("RADIANS");
  command.add_flag(
      "!--keep-curves", arguments.reading.join_curves,
      "Leave curves where the file's numbers have them; else they meet what lies within "
      "the rounding of these, as the ledger lists");
  command.add_flag(
      "--shortest-decimals", arguments.reading.shortest_decimals,
      "Read what a program printed of a double as the decimal of at most 12 digits next to it, "
      "where there is one: 420.34000000000003 as 420.34; the ledger counts them");
  command.add_flag("--lenient", arguments.lenient,
                   "Go on without what looks like geometry and cannot be read, also where nothing "
                   "can; without it that is an error, exit code 2 (check: the exit code is then "
                   "1, also where all that was read agrees)");
  command
      .add_option("--max-segments", arguments.reading.max_segments,
                  "Give up, with exit code 2, where the drawing has more segments (eval: segments "
                  "or cells), repetitions of what is stored once counted [default: any number]")
      ->check(integer(0))
      ->type_name("N");
  add_layers(command, arguments);
  add_common(command, arguments);
}

CLI::Option* add_output(CLI::App& command, std::optional<std::string>& output,
                        std::optional<std::string>& format, const std::string& what,
                        const std::vector<std::string_view>& formats) {
  CLI::Option* file = command.add_option("-o,--output", output, what)->type_name("FILE");
  command
      .add_option("--format", format,
                  "Format of -o: " + listed(formats) + " [default: by the file's ending; " +
                      std::string(formats.front()) + " on standard output, -o -]")
      ->transform(one_of({formats.begin(), formats.end()}))
      ->needs(file)
      ->type_name("FORMAT");
  return file;
}

void add_threads(CLI::App& command, std::size_t& threads) {
  command
      .add_option("--threads", threads,
                  "Use at most N threads [default: one for each core]; never changes the result")
      ->check(integer(1, 1024))
      ->type_name("N");
}

Range door_range(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) {
    throw Error(ErrorCode::BadInput, "--doors needs LEAST..MOST", {}, text);
  }
  Range range{parse_decimal(text.substr(0, dots)), parse_decimal(text.substr(dots + 2))};
  if (sgn(range.least) < 0 || range.least > range.most || text.find("...") != std::string::npos) {
    throw Error(ErrorCode::BadInput, "LEAST and MOST are widths, 0 or more, the lesser one first",
                {}, text);
  }
  return range;
}

ExactEngine exact_engine(const std::string& name) {
  if (name == "bucket") return ExactEngine::Bucket;
  if (name == "cgal") return ExactEngine::Cgal;
  throw Error(ErrorCode::BadInput, "unknown exact engine; there are bucket and cgal", {}, name);
}

void add_exact_engine(CLI::App& command, DrawingArguments& arguments) {
  command.option_defaults()->group("Arranging");
  command
      .add_option_function<std::string>(
          "--exact-engine",
          [&](const std::string& name) { arguments.exact_engine = exact_engine(name); },
          "Arrange with bucket (the default) or cgal (the reference, slower)")
      ->transform(one_of({"bucket", "cgal"}))
      ->type_name("NAME");
  command.add_flag("--both-engines", arguments.both_engines, "Arrange with both and compare");
  command
      .add_flag_callback(
          "--verify",
          [&] {
            arguments.both_engines = true;
            arguments.notes.emplace_back(
                "--verify is --both-engines now; plumbline-verify verifies certificates");
          },
          "")
      ->group("");
}

void add_files(CLI::App& command, DrawingArguments& arguments) {
  command
      .add_option_function<std::vector<std::string>>(
          "FILE",
          [&](const std::vector<std::string>& names) {
            for (const std::string& name : names) arguments.files.push_back(file_of(name));
            arguments.file = arguments.files.front();
          },
          std::string(kFile) +
              ". Of several each is told in a line, and the worst exit code counts")
      ->required()
      ->type_name("");
}

namespace {

struct NamedUnit {
  std::vector<std::string> names;  ///< the usual one first
  long numerator, denominator;     ///< of metres
};

const std::vector<NamedUnit>& units() {
  static const std::vector<NamedUnit> table{
      {{"mm", "millimetre", "millimetres", "millimeter", "millimeters"}, 1, 1000},
      {{"cm", "centimetre", "centimetres", "centimeter", "centimeters"}, 1, 100},
      {{"dm", "decimetre", "decimetres", "decimeter", "decimeters"}, 1, 10},
      {{"m", "metre", "metres", "meter", "meters"}, 1, 1},
      {{"km", "kilometre", "kilometres", "kilometer", "kilometers"}, 1000, 1},
      {{"in", "inch", "inches"}, 254, 10000},
      {{"ft", "foot", "feet"}, 3048, 10000}};
  return table;
}

/// A unit by its name, or a number of metres.
LengthUnit unit_of(const std::string& text) {
  for (const NamedUnit& unit : units()) {
    if (std::ranges::find(unit.names, CLI::detail::to_lower(text)) == unit.names.end()) continue;
    Rational metres(unit.numerator, unit.denominator);
    metres.canonicalize();
    return {unit.names.front(), metres};
  }
  try {
    LengthUnit unit{"", parse_decimal(text)};
    if (sgn(unit.metres) > 0) return unit;
  } catch (const Error&) {
    // told below, with what would do
  }
  throw Error(ErrorCode::BadInput,
              "--unit is mm, cm, dm, m, km, in or ft, or how many metres a drawing unit is", {},
              text);
}

}  // namespace

void add_drawing(CLI::App& command, DrawingArguments& arguments) {
  add_exact_engine(command, arguments);
  command
      .add_option_function<std::string>(
          "--unit", [&](const std::string& text) { arguments.unit = unit_of(text); },
          "What a drawing unit is, whatever the file says: mm, cm, dm, m, km, in, ft, or a number "
          "of metres")
      ->type_name("UNIT");
  add_threads(command, arguments.threads);
  add_reading(command, arguments);
}

void add_old_engine(CLI::App& command, DrawingArguments& arguments) {
  command
      .add_option_function<std::string>(
          "--engine",
          [&](const std::string& name) {
            arguments.exact_engine = exact_engine(name);
            arguments.notes.push_back("--engine is --exact-engine now");
          },
          "")
      ->group("");
}

}  // namespace plumbline::cli
