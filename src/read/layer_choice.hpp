#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "plumbline/error.hpp"
#include "plumbline/geometry/layers.hpp"

namespace plumbline {

/// Which layers of a drawing are read, by ReadOptions::layers and without_layers.
class LayerChoice {
 public:
  LayerChoice(const std::vector<std::string>& layers, const std::vector<std::string>& without);

  /// Whether there is no choice to be made: all is read.
  bool is_all() const { return wanted_.empty() && unwanted_.empty(); }
  /// Whether all is read that is not left out.
  bool wants_all() const { return wanted_.empty(); }
  /// Whether this is the name of a layer to be read, or to be left out.
  bool wants(std::string_view name) { return match(wanted_, name); }
  bool leaves_out(std::string_view name) { return match(unwanted_, name); }
  /// Whether what is on this layer is read.
  bool takes(std::string_view layer);
  /// Says that there is a layer of this name.
  void note(std::string_view name);
  /// Throws: Error BadInput for a pattern that no name has matched, with the first of the layers
  /// that there are.
  void check(const std::string& file) const;

 private:
  struct Pattern {
    std::string text;
    bool used = false;
  };
  static bool match(std::vector<Pattern>& patterns, std::string_view name);

  std::vector<Pattern> wanted_, unwanted_;
  std::set<std::string, std::less<>> known_;
  std::vector<std::string> named_;  ///< the first of them
};

}  // namespace plumbline
