// Engines that are programs: whatever they do, there is an answer, a finding or words.

#include "plumbline/engines/programs.hpp"

#include <signal.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "plumbline/arrange.hpp"
#include "plumbline/check.hpp"
#include "plumbline/error.hpp"
#include "plumbline/output.hpp"
#include "plumbline/pipeline.hpp"
#include "support/segments.hpp"

using namespace plumbline;

namespace {

const std::filesystem::path kFake = PLUMBLINE_FAKE_ENGINE;

Parameters how(const std::string& configuration) { return {{"configuration", configuration}}; }

Check checked(const std::string& drawing, const Parameters& parameters) {
  const SegmentSet input = segments(drawing);
  return check(input, arrange(input), answer_of(programs::engine(kFake), input, parameters));
}

/// "engine-crash: fake crashed: SIGABRT": the only finding, without a result.
std::string failure(Parameters parameters) {
  parameters.insert({"seconds", 20.0});
  const Check failed = checked("0 0 1 0  0 1 1 1", parameters);
  CHECK_FALSE(failed.agree());
  CHECK(failed.comparison.compared == Compared::Nothing);
  REQUIRE(failed.comparison.findings.size() == 1);
  REQUIRE(failed.causes.size() == 1);
  CHECK(failed.comparison.findings[0].kind == CellKind::Complex);
  CHECK(failed.causes[0].stage == "fake");
  CHECK_FALSE(failed.causes[0].advice.empty());
  CHECK_THAT(to_text(failed), Catch::StartsWith("disagree: no result, fake "));
  return failed.causes[0].rule + ": " + failed.comparison.findings[0].message;
}

/// An empty folder, removed in the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "plumbline-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  std::filesystem::path program(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = *this / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("a program says what it is") {
  const programs::Listing listing = programs::listing(kFake);
  CHECK(listing.engine == "fake");
  CHECK(listing.version == "1.5");
  REQUIRE(listing.configurations.size() > 3);
  CHECK(listing.configurations[0].tolerance_kind == programs::ToleranceKind::None);
  CHECK(listing.configurations[1].tolerance_kind == programs::ToleranceKind::Snap);
  CHECK(listing.configurations[1].tolerance == 0.25);
  CHECK(listing.configurations[1].source == "its only page");

  const Engine engine = programs::engine(kFake);
  CHECK(engine.name == "fake");
  CHECK(engine.version == "1.5");
  CHECK(engine.parameters.at(0).choices.at(0) == "uncut");
  CHECK(programs::engine(kFake, "other").name == "other");
}

TEST_CASE("what a program answers is compared, and laid to it") {
  CHECK(checked("0 0 4 0  4 0 4 3  0 0 0 3", {}).agree());
  const Check crossed = checked("0 0 4 4  0 4 4 0", how("uncut"));
  CHECK_FALSE(crossed.agree());
  CHECK(crossed.answer.engine == "fake");
  CHECK(crossed.answer.version == "1.5");
  CHECK(crossed.answer.title == "The Fake, the way uncut");
  CHECK(crossed.answer.parameters ==
        Parameters{{"configuration", std::string("uncut")}, {"seconds", 60.0}, {"memory", 4.0}});
  REQUIRE_FALSE(crossed.causes.empty());
  for (const Cause& cause : crossed.causes) CHECK(cause.stage == "fake");
}

TEST_CASE("a program gets the nearest doubles and gives them back") {
  const SegmentSet input = segments("0.1 1e-300 123456789.123456789 0.30000000000000004");
  const Answer answer = answer_of(programs::engine(kFake), input);
  CHECK(answer.complex.vertices ==
        std::vector<PointD>{{0.1, 1e-300}, {123456789.123456789, 0.30000000000000004}});
}

TEST_CASE("a tolerance is sent where the configuration has one, and else refused") {
  const auto with = [](const std::string& name, double tolerance) {
    Parameters parameters = how(name);
    parameters["radius"] = tolerance;
    return parameters;
  };
  const std::string drawing = "0.1 0 4 0";
  CHECK(checked(drawing, how("snapped")).answer.radius == 0.25);
  CHECK(checked(drawing, with("snapped", 0.125)).answer.radius == 0.125);
  CHECK(checked(drawing, with("snapped", 0.125)).answer.complex.vertices[0] == PointD{0.125, 0});
  const Check gridded = checked(drawing, with("gridded", 1));
  CHECK_FALSE(gridded.answer.radius);
  CHECK(gridded.answer.precision == 1);
  CHECK(gridded.answer.complex.vertices[0] == PointD{0, 0});
  CHECK(gridded.comparison.tolerance == 1);
  CHECK(gridded.agree());
  CHECK_THROWS_WITH(checked(drawing, with("uncut", 0.1)),
                    Catch::Contains("the configuration uncut of fake has no tolerance"));
  CHECK_THROWS_WITH(checked(drawing, with("snapped", -1)), Catch::Contains("negative"));
  CHECK_THROWS_WITH(checked(drawing, with("gridded", 0)),
                    Catch::Contains("the engine fake cannot have this radius: it says"));
}

TEST_CASE("a snap distance below what doubles tell apart is no radius to compare with") {
  Parameters parameters = how("snapped");
  parameters["radius"] = 0x1p-40;
  CHECK_FALSE(checked("1000000 0 1000004 0", parameters).answer.radius);
  CHECK(checked("1 0 5 0", parameters).answer.radius);
}

TEST_CASE("of a snap distance others are tried, and those that are right are told") {
  const Check wrong = advised(checked("0 0 4 0  4 0 4 3  4.1 0 5 0", how("snapped")));
  CHECK_FALSE(wrong.agree());
  REQUIRE(wrong.right_radii);
  REQUIRE_FALSE(wrong.right_radii->empty());
  CHECK(wrong.right_radii->largest < 0.25);
  CHECK_FALSE(checked("0.1 0 4 0", how("gridded")).answer.with_radius);
}

TEST_CASE("however a program fails, it is one finding in its words") {
  CHECK(failure(how("throws")) == "engine-error: fake says Sorry: no");
  CHECK(failure(how("dies")) == "engine-crash: fake crashed: SIGABRT");
  CHECK(failure(how("exits")) ==
        "engine-crash: fake ended with code 7 instead of answering: had enough");
  CHECK(failure(how("is killed")) == "engine-memory: fake needs more memory than 4 GB: SIGKILL");
  CHECK(failure(how("tells of memory")) ==
        "engine-memory: fake needs more memory than 4 GB: OutOfMemoryError: Java heap space");
  CHECK(failure({{"configuration", std::string("hangs")}, {"seconds", 0.5}}) ==
        "engine-timeout: fake gave no answer within 0.5 s");
  CHECK(failure({{"configuration", std::string("eats memory")}, {"memory", 0.5}}) ==
        "engine-memory: fake needs more memory than 0.5 GB: MemoryError");
}

TEST_CASE("what is not of the protocol is refused with what was said") {
  const auto refused = [](const std::string& configuration, const std::string& words) {
    CHECK_THROWS_WITH(failure(how(configuration)), Catch::Contains(words));
  };
  refused("garbage", "fake does not keep to the protocol of engines");
  refused("garbage", "Segmentation fault? no, garbage");
  refused("another case", "case 17 was asked");
  refused("no model", "a member is missing");
  refused("a list", "expected an object");
  refused("no vertices", "no member V");
  refused("no such vertex", "no such vertex");
  refused("not here", "the engine fake is not here: no such engine");
}

TEST_CASE("a program that says much on standard error is heard") {
  CHECK(checked("0 0 4 0", how("floods")).agree());
}

TEST_CASE("a drawing larger than a pipe is sent and answered") {
  SegmentSet input;
  for (int i = 0; i < 20'000; ++i) {
    const double x = i + 0.1;
    input.add(PointD{x, 0}, PointD{x, 1}, SourceId{});
  }
  CHECK(check(input, arrange(input), answer_of(programs::engine(kFake), input)).agree());
}

TEST_CASE("nothing that a program started is left") {
  const Folder folder;
  const std::string file = folder / "pid";
  REQUIRE(::setenv("PLUMBLINE_TEST_CHILD", file.c_str(), 1) == 0);
  CHECK_THAT(failure(how("leaves a child")), Catch::Contains("ended with code 7"));
  ::pid_t child = 0;
  std::ifstream(file) >> child;
  REQUIRE(child > 0);
  // A killed process is there until whoever inherits it has waited for it.
  const auto state = [&] {
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    std::string number, name, letter;
    stat >> number >> name >> letter;
    return letter;
  };
  for (int i = 0; i < 100 && !state().empty() && state() != "Z"; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  CHECK((state().empty() || state() == "Z"));
}

TEST_CASE("isolated points are remarked on, having no place in the protocol") {
  SegmentSet input = segments("0 0 4 0");
  input.add_point({2, 2}, SourceId{});
  const Answer answer = answer_of(programs::engine(kFake), input);
  REQUIRE(answer.remarks.size() == 1);
  CHECK(answer.remarks[0].what == "1 isolated point is not sent: the protocol has lines alone");
  CHECK_FALSE(check(input, arrange(input), answer).agree());
}

TEST_CASE("limits are positive, and configurations those that there are") {
  CHECK_THROWS_WITH(failure({{"seconds", 0.0}}), Catch::Contains("seconds is above 0"));
  CHECK_THROWS_WITH(failure({{"memory", -1.0}}), Catch::Contains("memory is above 0"));
  CHECK_THROWS_WITH(failure(how("magic")), Catch::Contains("uncut or snapped"));
}

TEST_CASE("a program that lists nothing usable is refused, or is not here") {
  const Folder folder;
  const auto refused = [&](const std::string& text, const std::string& words) {
    const auto program = folder.program("adapter", text);
    CHECK_THROWS_WITH(programs::listing(program), Catch::Contains(words));
  };
  refused("#!/bin/sh\necho hello\n", "--list: ");
  refused("#!/bin/sh\necho hello\n", "hello");
  refused("#!/bin/sh\necho '{\"engine\": \"x\"}'\n", "a member is missing");
  refused("#!/bin/sh\necho no library >&2; exit 3\n", "is not here: no library");
  refused("#!/bin/sh\necho bad luck >&2; exit 1\n", "--list failed: bad luck");
  refused("no program", "cannot start");
  CHECK_THROWS_WITH(programs::listing(folder / "nothing"), Catch::Contains("cannot start"));
}

TEST_CASE("an engine that takes rings is listed, and not for line work") {
  const Folder folder;
  const auto program = folder.program("adapter", R"(#!/bin/sh
echo '{"engine": "ringed", "title": "R", "version": "1", "algorithm": "R", "licence": "none",
"input": "rings", "configurations": [{"name": "only", "title": "T", "source": "S",
"tolerance": {"kind": "relative", "value": 1e-9, "way": "W"}}]}'
)");
  const programs::Listing listing = programs::listing(program);
  CHECK(listing.takes_rings);
  CHECK(listing.configurations.at(0).tolerance_kind == programs::ToleranceKind::Relative);
  CHECK_THROWS_WITH(programs::engine(program), Catch::Contains("ringed takes rings"));
}

TEST_CASE("programs are found by their names, the first folder of several with one") {
  const Folder folder;
  const auto first = folder.program("a/plumbline-engine-one", "#!/bin/sh\n");
  folder.program("b/plumbline-engine-one", "#!/bin/sh\n");
  folder.program("b/plumbline-engine-another", "#!/bin/sh\n");
  folder.program("b/plumbline-engine-", "#!/bin/sh\n");
  folder.program("b/other", "#!/bin/sh\n");
  std::ofstream(folder / "b/plumbline-engine-no-program") << "text";
  const std::vector<std::filesystem::path> folders{folder / "a", folder / "none", folder / "b"};
  const auto found = programs::found_in(folders);
  REQUIRE(found.size() == 2);
  CHECK(found[0].name == "another");
  CHECK(found[1].name == "one");
  CHECK(found[1].path == first);
}

TEST_CASE("engines are built in, programs by name or by path, and an unknown one is told all") {
  const Folder folder;
  std::filesystem::create_directories(folder / "a");
  std::filesystem::create_symlink(kFake, folder / "a/plumbline-engine-found");
  std::filesystem::create_symlink(kFake, folder / "a/plumbline-engine-lar");
  const std::vector<std::filesystem::path> folders{folder / "a"};
  CHECK(engine_named("found", engines(), folders).name == "found");
  CHECK(engine_named("found", engines(), folders).version == "1.5");
  CHECK(engine_named("lar", engines(), folders).title == "float LAR");
  CHECK(engine_named(kFake.string(), engines(), folders).name == "fake");
  CHECK_THROWS_WITH(engine_named("luck", engines(), folders),
                    Catch::Contains("there are lar, inters, plasm, files; programs found"));
  CHECK_THROWS_WITH(engine_named("luck", engines(), folders), Catch::Contains("found"));
  CHECK_THROWS_WITH(engine_named("./no/such", engines(), folders), Catch::Contains("./no/such"));
}
