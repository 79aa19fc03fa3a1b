#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace plumbline {

/// The general entities that the internal subset of a DOCTYPE declares. External ones (SYSTEM,
/// PUBLIC) are never read; a reference to one is an error.
class Entities {
 public:
  /// From the text between "<!DOCTYPE" and its ">".
  explicit Entities(std::string_view doctype);

  bool empty() const { return values_.empty() && external_.empty(); }
  /// Whether the text refers to an entity whose value holds markup.
  bool refers_to_markup(std::string_view text) const;
  /// Throws: Error BadInput where the text refers to an external entity.
  void check_external(std::string_view text) const;
  /// The text with all declared entities replaced; other references stay as they are. Throws: Error
  /// BadInput for entities nested too deep (an entity within itself) and external ones, Limit for a
  /// document whose entities grow beyond kMaxExpansion.
  std::string expand(std::string_view text);

 private:
  void expand_onto(std::string& result, std::string_view text, int depth);
  /// The entity referred to at the beginning of `text`, or null.
  const std::pair<const std::string, std::string>* reference(std::string_view text) const;

  std::unordered_map<std::string, std::string> values_;
  std::unordered_set<std::string> external_;
  std::size_t spent_ = 0;  ///< characters made and references followed, over the document
};

}  // namespace plumbline
