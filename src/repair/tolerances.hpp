#pragma once

#include <string>
#include <vector>

#include "repair/steps.hpp"

namespace plumbline::repair_steps {

/// Of something that an operation would repair.
struct Size {
  double size = 0;
  bool is_accident = true;  ///< else a detail that it would destroy
};

/// Chooses tolerances that are not given from the sizes of what each operation would repair, at the
/// time when it is its turn; a sentence for each one says why. See docs/repair.md.
class Choice {
 public:
  Choice(const SegmentSet& input, std::vector<std::string>& reasons);

  Rational weld(Work& work, const Arranged& arranged);
  Rational grow(const Work& work, const Arranged& arranged);
  Rational trim(Work& work, const Arranged& arranged);
  Rational sliver(const Work& work, const Arranged& arranged);

 private:
  double extent_ = 0;  ///< the drawing's longer side
  double unit_ = 0;    ///< in which it was made; 0: not known
  double least_ = 0;   ///< whatever is no larger is an accident
  double line_ = 0;    ///< length of an ordinary line
  std::vector<std::string>& reasons_;

  struct Ladder;
  Rational choose(Ladder ladder);
  Ladder narrow_ladder(const char* name) const;
  Ladder wide_ladder(const char* name) const;
};

}  // namespace plumbline::repair_steps
