#pragma once

#include <string>

#include "plumbline/minimise.hpp"

namespace plumbline {

/// The minimised drawing for a terminal, on a screen: what is wrong, the segments in numbers, what
/// is exact, what the engine says, versions, what stayed as it was.
std::string to_text(const Minimised& minimised);

/// The segments as rows of a .lines file, which `check` finds the same of: as shortest decimals
/// where `holds_in_decimals`, else with the exact numbers that the doubles are.
std::string to_lines(const Minimised& minimised);

/// The names of the files that an issue text speaks of; "" for one that there is not.
struct IssueFiles {
  std::string lines;    ///< the drawing
  std::string picture;  ///< of `to_svg`
};
/// An issue for the maintainers of the engine, as Markdown: versions, the input as WKT and as
/// .lines, what is expected and why, with exact coordinates, what comes out, how to reproduce it.
std::string to_issue(const Minimised& minimised, const IssueFiles& files);

/// A picture: the exact arrangement and the answer beside it, what is wrong marked; below, where
/// it lies too close to be seen, the place of the tightest finding, magnified. Vertices are dots.
std::string to_svg(const Minimised& minimised);

}  // namespace plumbline
