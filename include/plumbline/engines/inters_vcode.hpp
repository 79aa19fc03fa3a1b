#pragma once

#include <string>

#include "plumbline/engines/inters.hpp"

namespace plumbline::inters {

/// Fixed decimals (vcode, fixedPrec): values rounded half away from zero to a number of decimals
/// and to 12 significant digits, as the text of the original does. **Rounded**. Requires: values
/// that are finite, also times ten to the number of decimals. Section 2.1 of Paoluzzi, "Accelerated
/// intersection of geometric objects", November 2015, uses it first.
class Vcode {
 public:
  /// Throws: Error BadInput for decimals outside 0 to kMaxDecimals.
  explicit Vcode(int decimals);

  /// The value read back from its text; never -0.
  double quantised(double value) const;
  PointD quantised(const PointD& p) const { return {quantised(p.x), quantised(p.y)}; }
  SegmentD quantised(const SegmentD& s) const { return {quantised(s.a), quantised(s.b)}; }
  /// "0.25", "3.0", "1e-05".
  std::string text(double value) const;
  /// "[0.25, 3.0]".
  std::string text(const PointD& p) const;

 private:
  double power_;  ///< ten to the number of decimals
};

}  // namespace plumbline::inters
