#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace plumbline_checker {

/// What was checked, by numbers.
struct Counts {
  std::size_t segments = 0;        ///< of the input, without those of length zero
  std::size_t points = 0;          ///< of the input
  std::size_t without_length = 0;  ///< rows of the input that are segments of length zero
  std::size_t vertices = 0, edges = 0, cycles = 0, faces = 0, components = 0;
  std::size_t isolated_vertices = 0;
  std::size_t pieces = 0;  ///< pairs of an edge and a segment that covers it
};

enum class Outcome {
  Proved,    ///< the certificate is that of the input
  Refused,   ///< it is not
  BadInput,  ///< the input cannot be read, so that nothing was checked
};

struct Verdict {
  Outcome outcome = Outcome::Proved;
  Counts counts;         ///< if proved
  std::string reason;    ///< if not proved: what is wrong first, in a sentence without full stop
  std::size_t line = 0;  ///< of the certificate if refused, of the input if that is bad; 0: none
  std::string place;     ///< the exact point "(1/2, 1/3)" where it is wrong, or ""
};

/// Whether `certificate` is the certificate of `input`, both as texts: docs/certificate.md says
/// what that means and what is proved. **Exact**. Any two texts are checked or refused, however
/// hostile. Requires: texts below 4 GiB each (else refused). Cost: O(n log n) comparisons,
/// near-linear. Throws: std::bad_alloc only; GMP
/// itself ends the program where memory runs out, unless told otherwise.
Verdict verify(std::string_view input, std::string_view certificate);

/// A verdict in plain English: what was proved, or what is wrong where. Ends in a line break.
std::string report(const Verdict& verdict);

}  // namespace plumbline_checker
