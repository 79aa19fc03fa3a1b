#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "plumbline/structure.hpp"
#include "read/dxf/drawn.hpp"

namespace plumbline::dxf {

/// What a part of a drawing refuses and replaces: faults one by one, the rest by kind.
class Tally {
 public:
  /// An item that is at fault.
  void refuse(const Source& source, const Unusable& problem);
  /// One of the items that are left out for the same reason; listed as one per type and reason, in
  /// the place of the first.
  void leave_out(const Source& source, const std::string& reason, bool harmless);
  /// The same for what is drawn.
  void remark(const Source& source, const std::string& what);
  /// Listed as one per type and `what`, in the place of the first, with the largest bound.
  void replace(const Source& source, const Substitution& replaced);

  void merge(Tally other);
  /// To `rejected`, `remarks` and `ledger`, each by their lines.
  void append_to(Structure& structure) const;

 private:
  struct Count {
    Source first;
    std::size_t count = 0;
    double bound = 0;
    bool harmless = true;
  };
  using Key = std::tuple<std::string, std::string, std::string>;  ///< type, reason or what, unit
  using Counts = std::map<Key, Count>;

  static void add(Counts& counts, const Key& key, const Count& more);

  std::vector<Rejected> refused_;
  Counts left_out_;
  Counts remarks_;
  Counts replaced_;
};

}  // namespace plumbline::dxf
