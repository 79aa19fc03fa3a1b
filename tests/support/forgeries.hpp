#pragma once

#include <catch2/catch.hpp>
#include <functional>
#include <string>

#include "repairs.hpp"

namespace plumbline {

/// What is changed of an honest repair. Where the log is forged, output and faces follow from it,
/// so that they do not give it away.
struct Forgery {
  std::string name;
  Made made;
  std::function<void(Repair&)> forge;
  std::string reason;
};

inline void check_refused(const Forgery& forgery) {
  INFO(forgery.name);
  CHECK(verify(forgery.made.input, forgery.made.repair).empty());
  Repair repair = forgery.made.repair;
  forgery.forge(repair);
  std::string reasons;
  for (const Breach& breach : verify(forgery.made.input, repair)) reasons += breach.message + '\n';
  INFO(reasons);
  CHECK(reasons.find(forgery.reason) != std::string::npos);
}

}  // namespace plumbline
