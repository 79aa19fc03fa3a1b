#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plumbline/engine.hpp"

/// Engines that are programs of their own and speak the protocol of
/// validation/study/adapters/README.md: cases in, models out. A program that crashes, hangs or
/// takes all memory has failed, and nothing else has.
namespace plumbline::programs {

/// What an engine's tolerance is.
enum class ToleranceKind {
  None,
  Grid,      ///< vertices are on a grid of this width
  Snap,      ///< vertices nearer than this are one
  Relative,  ///< a grid of so much of the drawing's longer side
};
std::string to_text(
    ToleranceKind kind);  ///< "none", "grid", "snap", "relative", as in the protocol

/// One way to call an engine.
struct Configuration {
  std::string name;
  std::string title;
  ToleranceKind tolerance_kind = ToleranceKind::None;
  double tolerance = 0;  ///< in drawing units, but of Relative; 0 of None
  std::string source;    ///< where the engine's own documentation has this way
};

/// What a program says of its engine.
struct Listing {
  std::string engine;  ///< its name
  std::string title;
  std::string version;
  std::string algorithm;  ///< what counts as one independent engine
  std::string licence;
  bool takes_rings = false;  ///< and no line work: nothing that can be checked here
  std::vector<Configuration> configurations;  ///< at least one; the first is the default
};
/// Runs `program --list`. Throws: Error BadFile for what cannot be started; BadInput, with what the
/// program said, where its engine is not here or it does not keep to the protocol.
Listing listing(const std::filesystem::path& program);

/// The engine of a program. Its parameters: `configuration`; `radius`, the tolerance of those
/// configurations that have one; the limits `seconds` and `memory`, in gigabytes. Named `name`, or
/// as the program says. Right radii are looked for where the tolerance is a snap distance and the
/// answer has faces.
///
/// An error, a crash, a timeout or memory that ran out is an Answer without a result, with one
/// failure that says so. Running it throws Error BadInput, with what the program said, where its
/// engine is not here, cannot have this radius or does not keep to the protocol. Isolated points
/// have no place in the protocol: the answer remarks on them. Throws: as `listing`; BadInput for
/// engines that take rings.
Engine engine(const std::filesystem::path& program, const std::string& name = "");

/// Programs that are engines have this before their names.
inline constexpr const char* kPrefix = "plumbline-engine-";

/// A program that is an engine by its file's name.
struct Program {
  std::string name;  ///< without kPrefix
  std::filesystem::path path;
};
/// Those in these folders, by name; of several with one name that of the first folder. Folders that
/// are not there, or cannot be read, hold none.
std::vector<Program> found_in(std::span<const std::filesystem::path> folders);

}  // namespace plumbline::programs
