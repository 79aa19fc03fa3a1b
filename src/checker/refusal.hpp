#pragma once

#include <cstddef>
#include <string>

namespace plumbline_checker {

/// Thrown where a certificate is not right.
struct Refusal {
  std::string reason;
  std::size_t line;   ///< of the certificate, from 1
  std::string place;  ///< the exact point, or ""
};

/// Thrown where the input cannot be read.
struct BadInput {
  std::string reason;
  std::size_t line;  ///< of the input, from 1; 0: none
};

}  // namespace plumbline_checker
