// A program as an engine: each run starts it anew, so that no run depends on those before it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "engines/programs/failures.hpp"
#include "engines/programs/protocol.hpp"
#include "plumbline/engines/programs.hpp"
#include "plumbline/error.hpp"
#include "plumbline/number.hpp"

namespace plumbline::programs {
namespace {

constexpr const char* kConfiguration = "configuration";
constexpr const char* kRadius = "radius";
constexpr const char* kSeconds = "seconds";
constexpr const char* kMemory = "memory";

constexpr double kDefaultSeconds = 60;
constexpr double kDefaultMemory = 4;
constexpr std::size_t kShort = 12;   // characters of a title in a table
constexpr double kTrialSeconds = 5;  // of each run that advice takes
constexpr double kMostSeconds = 1e9;
constexpr double kMostMemory = 1U << 20U;  // gigabytes

/// Of a drawing's largest coordinate: a distance that roundings of doubles exceed.
constexpr double kUnresolved = 0x1p-46;

/// A parameter within its bounds.
double number_of(const Parameters& parameters, const char* name, double by_default, double most) {
  const auto found = parameters.find(name);
  if (found == parameters.end()) return by_default;
  const double value = std::get<double>(found->second);
  if (value > 0 && value <= most) return value;
  throw Error(ErrorCode::BadInput,
              fmt::format("the parameter {} is above 0 and at most {}", name, most), {},
              shortest_text(value));
}

/// What a run is asked for.
struct Asked {
  const Configuration* configuration;
  std::optional<double> tolerance;  ///< where it is not the configuration's own
  Limits limits;
  Parameters all;  ///< parameters as the engine runs

  Asked(const Listing& listing, const Parameters& parameters, const std::string& engine);
};

Asked::Asked(const Listing& listing, const Parameters& parameters, const std::string& engine)
    : configuration(&listing.configurations.front()) {
  const auto named = parameters.find(kConfiguration);
  if (named != parameters.end()) {
    const auto& name = std::get<std::string>(named->second);
    configuration =
        &*std::ranges::find(listing.configurations, name, &Configuration::name);  // it is a choice
  }
  const auto chosen = parameters.find(kRadius);
  if (chosen != parameters.end()) {
    tolerance = std::get<double>(chosen->second);
    if (configuration->tolerance_kind == ToleranceKind::None) {
      throw Error(ErrorCode::BadInput, "the configuration " + configuration->name + " of " +
                                           engine + " has no tolerance");
    }
    if (*tolerance < 0) {
      throw Error(ErrorCode::BadInput, "a negative tolerance", {}, shortest_text(*tolerance));
    }
  }
  const double seconds = number_of(parameters, kSeconds, kDefaultSeconds, kMostSeconds);
  const double memory = number_of(parameters, kMemory, kDefaultMemory, kMostMemory);
  limits = {seconds, static_cast<std::uint64_t>(memory * kGigabyte)};
  all = {{kConfiguration, configuration->name}, {kSeconds, seconds}, {kMemory, memory}};
  if (configuration->tolerance_kind != ToleranceKind::None) {
    all[kRadius] = tolerance.value_or(configuration->tolerance);
  }
}

double longer_side(const LineWork& work) {
  if (work.segments.empty()) return 0;
  PointD low = work.segments.front().a, high = low;
  for (const auto& [a, b] : work.segments) {
    low = {std::min({low.x, a.x, b.x}), std::min({low.y, a.y, b.y})};
    high = {std::max({high.x, a.x, b.x}), std::max({high.y, a.y, b.y})};
  }
  return std::max(high.x - low.x, high.y - low.y);
}

double largest_coordinate(const LineWork& work) {
  double largest = 0;
  for (const auto& [a, b] : work.segments) {
    for (const double x : {a.x, a.y, b.x, b.y}) largest = std::max(largest, std::abs(x));
  }
  return largest;
}

/// What the tolerance means for whoever compares.
void set_tolerance(Answer& answer, const Asked& asked, const LineWork& work) {
  const ToleranceKind kind = asked.configuration->tolerance_kind;
  if (kind == ToleranceKind::None) return;
  const double tolerance = asked.tolerance.value_or(asked.configuration->tolerance);
  answer.precision = kind == ToleranceKind::Relative ? tolerance * longer_side(work) : tolerance;
  const bool is_resolved = tolerance > kUnresolved * largest_coordinate(work);
  if (kind == ToleranceKind::Snap && is_resolved) answer.radius = tolerance;
}

std::string remark_on_points(std::size_t count) {
  return fmt::format("{} isolated point{} not sent: the protocol has lines alone", count,
                     count == 1 ? " is" : "s are");
}

class Runner {
 public:
  Runner(std::filesystem::path program, Listing listing, std::string name)
      : program_(std::move(program)), listing_(std::move(listing)), name_(std::move(name)) {}

  Answer operator()(const SegmentSet& input, const Parameters& parameters,
                    std::size_t /*threads*/) const {
    const Asked asked(listing_, parameters, name_);
    const LineWork work = rounded(input);
    Reply reply = ask(asked.configuration->name, work, asked.tolerance, asked.limits);
    if (reply.failure && reply.failure->kind == Failure::Kind::BadTolerance) {
      throw Error(ErrorCode::BadInput,
                  "the engine " + name_ + " cannot have this radius: it " + reply.failure->message);
    }
    Answer answer;
    if (reply.model) {
      answer = files::answer(*std::move(reply.model));
      answer.exact_complex.reset();  // its coordinates are doubles
    } else {
      answer.complex = complex_from_faces({});
      answer.compared = Compared::Nothing;
      answer.failures = {explained(*reply.failure, name_)};
    }
    answer.title = listing_.title + ", " + asked.configuration->title;
    answer.short_title = name_.size() < kShort ? name_ : "the engine";
    answer.parameters = asked.all;
    set_tolerance(answer, asked, work);
    if (answer.radius && answer.compared == Compared::All) {
      const Limits limits{std::min(asked.limits.seconds, kTrialSeconds), asked.limits.bytes};
      answer.with_radius = [*this, name = asked.configuration->name, limits](
                               const SegmentSet& same, double radius, std::size_t /*threads*/) {
        return trial(name, limits, same, radius);
      };
    }
    if (!work.points.empty()) {
      answer.remarks.push_back({{}, remark_on_points(work.points.size()), {}});
    }
    return answer;
  }

 private:
  Reply ask(const std::string& configuration, const LineWork& work, std::optional<double> tolerance,
            const Limits& limits) const {
    return reply_of(
        exchange(program_, {configuration}, case_text(work, tolerance), limits, Until::Line), name_,
        limits);
  }

  /// Radii that doubles do not resolve are raised. Throws: Error Limit where the engine fails.
  RadiusTrial trial(const std::string& configuration, const Limits& limits, const SegmentSet& input,
                    double radius) const {
    const LineWork work = rounded(input);
    radius = std::max(radius, kUnresolved * largest_coordinate(work));
    Reply reply = ask(configuration, work, radius, limits);
    if (!reply.model) throw Error(ErrorCode::Limit, name_ + ' ' + reply.failure->message);
    return {nearest(reply.model->complex), radius};
  }

  std::filesystem::path program_;
  Listing listing_;
  std::string name_;
};

Parameter configuration_parameter(const Listing& listing) {
  Parameter result{kConfiguration, Parameter::Type::Text,
                   "the way to call it [default: " + listing.configurations.front().name + "]"};
  for (const Configuration& c : listing.configurations) result.choices.push_back(c.name);
  return result;
}

}  // namespace

Listing listing(const std::filesystem::path& program) {
  const Limits limits{kDefaultSeconds, static_cast<std::uint64_t>(kDefaultMemory * kGigabyte)};
  return listing_of(exchange(program, {"--list"}, "", limits, Until::End), program);
}

Engine engine(const std::filesystem::path& program, const std::string& given_name) {
  Listing listed = listing(program);
  const std::string name = given_name.empty() ? listed.engine : given_name;
  if (listed.takes_rings) {
    throw Error(ErrorCode::BadInput, "the engine " + name + " takes rings, and no line work");
  }
  Engine result;
  result.name = name;
  result.version = listed.version;
  result.title = listed.title;
  result.parameters = {
      configuration_parameter(listed),
      {kRadius, Parameter::Type::Number,
       "of configurations that have a tolerance: the distance within which vertices become one, or "
       "the width of the grid, in drawing units [default: the configuration's own]"},
      {kSeconds, Parameter::Type::Number,
       "the time that it may take [default: " + shortest_text(kDefaultSeconds) + "]"},
      {kMemory, Parameter::Type::Number,
       "the gigabytes that it may write to [default: " + shortest_text(kDefaultMemory) + "]"}};
  result.run = Runner(program, std::move(listed), name);
  return result;
}

}  // namespace plumbline::programs
