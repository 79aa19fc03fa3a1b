#pragma once

// Certificates broken in ways that have a name, each refused for the right reason. Their signatures
// are those of what they say, so that it is not the signature that betrays them.

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "checker/verify.hpp"
#include "hand_certificates.hpp"

namespace corruptions {

struct Corruption {
  const char* name;
  const char* of;  ///< the certificate that is broken
  std::vector<std::pair<std::string, std::string>>
      edits;            ///< a text that occurs once, and the new one
  const char* refusal;  ///< what the report must have
};

inline std::string broken(const Corruption& corruption) {
  std::string text = hand_certificates::cases().at(corruption.of).certificate;
  for (const auto& [old_text, new_text] : corruption.edits) {
    const std::size_t at = text.find(old_text);
    REQUIRE(at != text.npos);
    REQUIRE(text.find(old_text, at + 1) == text.npos);
    text.replace(at, old_text.size(), new_text);
  }
  return text;
}

inline void check(const std::vector<Corruption>& corruptions, bool sign = true) {
  for (const Corruption& corruption : corruptions) {
    INFO(corruption.name);
    const std::string text = broken(corruption);
    const auto verdict =
        plumbline_checker::verify(hand_certificates::cases().at(corruption.of).input,
                                  sign ? plumbline::certificates::with_signature(text) : text);
    CHECK(verdict.outcome == plumbline_checker::Outcome::Refused);
    CHECK_THAT(plumbline_checker::report(verdict), Catch::Contains(corruption.refusal));
  }
}

inline constexpr const char* kSegment = "a segment from right to left";
inline constexpr const char* kCrossing = "a crossing";
inline constexpr const char* kOverlap = "an overlap and a duplicate";
inline constexpr const char* kJunction = "a T-junction";
inline constexpr const char* kPencil = "a pencil through a point";
inline constexpr const char* kTouching = "a triangle in a square that touches its corner";
inline constexpr const char* kAntenna = "an antenna and a point in a face";
inline constexpr const char* kNested =
    "a square in a square, points in both, a segment beside them";
inline constexpr const char* kParallel = "two parallel segments";
inline constexpr const char* kVertical = "vertical segments that overlap, crossed";
inline constexpr const char* kPoints = "points on a segment and beside it, a row without length";

}  // namespace corruptions
