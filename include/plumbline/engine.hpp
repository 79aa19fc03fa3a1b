#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "plumbline/compare.hpp"
#include "plumbline/engine/cell_lists.hpp"

/// The seam between the exact side and whatever arranges line work otherwise: `check` holds the
/// Answer of any Engine against the exact complex and knows none. An engine's own computation never
/// sees the exact side; only what explains its runs (Run) may.
namespace plumbline {

/// Something that the user of an engine may choose.
struct Parameter {
  enum class Type { Number, Integer, Text };
  std::string name;
  Type type = Type::Number;
  std::string description;                ///< with its unit and what it is by default
  std::vector<std::string> choices = {};  ///< of a Text; none: any
};
using ParameterValue = std::variant<double, std::int64_t, std::string>;
/// By name. What is not there is as the engine has it by default.
using Parameters = std::map<std::string, ParameterValue>;

/// Pieces in doubles, each with the input segments that it is part of.
struct LineWork {
  std::vector<SegmentD> segments;  ///< those without length count for nothing
  Lists<SegmentId> sources;        ///< per segment
  std::vector<PointD> points;      ///< isolated points
};
/// Every coordinate of the input rounded to the nearest double.
LineWork rounded(const SegmentSet& input);
/// The arrangement of the pieces, their doubles taken as exact. **Exact**. Its sources are those of
/// the pieces. Cost and errors: as `arrange`.
ExactComplex arrange(const LineWork& work, std::size_t threads);

// What happens to a drawing before any engine sees it.
inline constexpr const char* kDrawing = "drawing";      ///< its own digits leave it open (Drift)
inline constexpr const char* kParse = "parse";          ///< a number became the nearest double
inline constexpr const char* kTransform = "transform";  ///< a coordinate that maps gave did

/// Why a finding is there.
struct Cause {
  std::string stage;  ///< kDrawing, kParse, kTransform, one of Answer::stages, or the engine's name
  std::size_t round = 0;    ///< of an engine that repeats stages, from 1; 0 outside of rounds
  std::string rule;         ///< the name of the divergence, as in docs/divergences.md
  std::string explanation;  ///< one sentence: what the stage did there
  std::string advice;       ///< one sentence: what would have avoided it
  /// The stage, with those in `with`, makes the finding: with the output of the last of them
  /// continued exactly all of it is there, with the input of one of them nothing of it.
  bool confirmed = false;
  /// With the stage replaced by its exact counterpart and the later ones run as they are, these
  /// make the finding again. None: not tried, as for kParse and kTransform, and on large drawings.
  std::optional<bool> remade = {};
  /// Of a stage that joins what is near: how far apart what it joined there is. **Rounded**.
  std::optional<double> distance = {};
  /// The largest radius with which the engine was run and the finding was not there, nor with any
  /// smaller one that was tried; so with the least of some findings none of them was there. None:
  /// there is no such radius, or none were tried.
  std::optional<double> radius_without = {};
  /// Other stages that have a part in the finding, or in what it follows from, as causes without
  /// further ones.
  std::vector<Cause> with = {};
};
struct Explained {
  Finding finding;
  Cause cause;
};

/// What a stage of a run left behind. Continued exactly from there, it is `Run::continued`.
struct StageOutput {
  std::string stage;
  std::size_t round = 0;  ///< from 1; 0 outside of rounds
  bool changed = true;    ///< if not, `work` is left out: it is that of the output before
  LineWork work;
  bool cuts = false;    ///< it is this stage's task that pieces meet in common ends only
  bool is_cut = false;  ///< the later stages never cut again, whether they do or not
};

/// A run of an engine stage by stage, as attribution looks at it.
class Run {
 public:
  Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  virtual ~Run() = default;

  /// The outputs of the stages that have line work, in their order. The first is that of
  /// kTransform: the rounded input. Coordinates are the drawing's.
  virtual std::vector<StageOutput> outputs() const = 0;
  /// The complex that exact stages would make of this output: by default its arrangement.
  virtual ExactComplex continued(const StageOutput& output, std::size_t threads) const;
  /// The stage after the last of `outputs` that made a finding.
  virtual std::string late_stage(const Finding& finding) const = 0;
  /// The cause, whose stage and round are known, with rule, explanation and advice.
  virtual Cause explained(const Finding& finding, Cause cause) const = 0;
  /// The result with this one stage (of this round) replaced by its exact counterpart, whose output
  /// is rounded for the stages after it; none where that can't be done in doubles.
  virtual std::optional<FloatComplex> with_exact(const std::string& stage,
                                                 std::size_t round) const = 0;
  /// An earlier stage that is to blame instead if, replaced by its exact counterpart, it makes the
  /// finding go away; none by default.
  virtual std::optional<std::string> suspect(const Cause& cause) const;
  /// The cause with its rule named more closely, where another finding gave it its name.
  virtual Cause refined(const Finding& finding, Cause cause) const;
};

/// What an engine makes of the same input with another radius.
struct RadiusTrial {
  FloatComplex complex;
  double radius = 0;  ///< as the engine used it
};
using WithRadius =
    std::function<RadiusTrial(const SegmentSet& input, double radius, std::size_t threads)>;

/// What an engine, or someone else's program, makes of a drawing.
struct Answer {
  std::string engine;  ///< its name
  std::string version;
  std::string title;  ///< in pictures and pages: "float LAR", or the file that it was read from
  std::string short_title;  ///< the same in at most 12 characters
  Parameters parameters;    ///< as the engine was run: all that it has
  FloatComplex complex;     ///< in canonical order, right or wrong
  /// The same where coordinates are no doubles: then this one is compared.
  std::optional<ExactComplex> exact_complex = {};
  Compared compared = Compared::All;
  /// Vertices nearer than this are one to the engine; none: it merges nothing. In drawing units.
  std::optional<double> radius = {};
  /// To which it gives coordinates, by its own promise: the width of a grid, say. In drawing units.
  std::optional<double> precision = {};
  /// Where the radius comes from: "number", the name of a preset (`preset_radius`), or "segment":
  /// chosen by the engine, a quarter of the shortest segment.
  std::string radius_from = {};
  std::vector<Rejected> dropped = {};    ///< what it left out, of a file `title`
  std::vector<Remark> remarks = {};      ///< on what it did not leave out; of the same file
  std::vector<Explained> failures = {};  ///< what the engine itself says is wrong
  std::vector<std::string> stages = {};  ///< in their order; none: it can't be looked into
  std::function<std::shared_ptr<const Run>()> trace =
      {};                       ///< makes the run; none where no stages are
  WithRadius with_radius = {};  ///< of an engine for which radii that are right can be looked for
};

/// Something that arranges line work.
struct Engine {
  std::string name;  ///< "lar": of the command line, of JSON, of the folder
  std::string version;
  std::string title;
  std::vector<Parameter> parameters;
  /// `threads` (0: as many as there are cores) does not change the answer. Throws: Error.
  std::function<Answer(const SegmentSet& input, const Parameters& parameters, std::size_t threads)>
      run;
};

/// What the engine makes of the input. Throws: Error BadInput for a parameter that it has not, of
/// another type or none of its choices; as the engine.
Answer answer_of(const Engine& engine, const SegmentSet& input, const Parameters& parameters = {},
                 std::size_t threads = 0);

/// The value that a text stands for. Throws: Error BadInput for one that the engine has not.
ParameterValue parameter_value(const Engine& engine, const std::string& name,
                               std::string_view text);

/// An answer of lines alone: their distinct ends and the lines as they are, uncut; `sources` per
/// line, or none. Vertices and edges are compared, faces are not.
FloatComplex lines_alone(std::span<const SegmentD> lines, const Lists<SegmentId>& sources = {});

}  // namespace plumbline
