#include "read/entities.hpp"

#include "plumbline/error.hpp"

namespace plumbline {
namespace {

/// Largest number of characters and references that the entities of one document expand to.
constexpr std::size_t kMaxExpansion = std::size_t{1} << 24U;
constexpr int kMaxDepth = 16;
/// Longest entity name that is looked for.
constexpr std::size_t kMaxName = 256;

constexpr std::string_view kXmlBlanks = " \t\r\n";

void skip_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kXmlBlanks), text.size()));
}

void skip_behind(std::string_view& text, std::string_view end) {
  const std::size_t position = text.find(end);
  text.remove_prefix(position == text.npos ? text.size() : position + end.size());
}

/// The literal in quotes at the beginning of `text`, which is moved behind it.
std::string_view take_literal(std::string_view& text) {
  const std::size_t close = text.find(text.front(), 1);
  const std::string_view literal = text.substr(1, close == text.npos ? close : close - 1);
  text.remove_prefix(close == text.npos ? text.size() : close + 1);
  return literal;
}

bool at_quote(std::string_view text) {
  return !text.empty() && (text.front() == '"' || text.front() == '\'');
}

/// Moves `text` behind the end of a declaration; a '>' in quotes is not it.
void skip_declaration(std::string_view& text) {
  while (!text.empty() && text.front() != '>') {
    at_quote(text) ? void(take_literal(text)) : text.remove_prefix(1);
  }
}

}  // namespace

Entities::Entities(std::string_view doctype) {
  while (!doctype.empty() && doctype.front() != '[') {
    at_quote(doctype) ? void(take_literal(doctype)) : doctype.remove_prefix(1);
  }
  constexpr std::string_view kDeclaration = "<!ENTITY";
  while (!doctype.empty()) {
    if (doctype.starts_with("<!--")) {
      skip_behind(doctype, "-->");
    } else if (doctype.starts_with("<?")) {
      skip_behind(doctype, "?>");
    } else if (doctype.starts_with(kDeclaration)) {
      doctype.remove_prefix(kDeclaration.size());
      skip_blanks(doctype);
      const std::string_view name =
          doctype.substr(0, doctype.find_first_of(" \t\r\n>"));  // "%": a parameter entity
      doctype.remove_prefix(name.size());
      skip_blanks(doctype);
      // The first declaration of a name is the one that counts.
      const std::string key(name);
      const bool is_known = name == "%" || values_.count(key) + external_.count(key) != 0;
      if (!is_known && at_quote(doctype)) {
        values_.emplace(key, take_literal(doctype));
      } else if (!is_known) {
        external_.insert(key);
      }
      skip_declaration(doctype);
    } else if (doctype.starts_with("<!")) {
      skip_declaration(doctype);
    } else {
      doctype.remove_prefix(1);
    }
  }
}

const std::pair<const std::string, std::string>* Entities::reference(std::string_view text) const {
  const std::size_t end = text.substr(0, kMaxName).find(';');
  if (text.empty() || text.front() != '&' || end == text.npos) return nullptr;
  const auto found = values_.find(std::string(text.substr(1, end - 1)));
  return found == values_.end() ? nullptr : &*found;
}

bool Entities::refers_to_markup(std::string_view text) const {
  for (std::size_t at = text.find('&'); at != text.npos; at = text.find('&', at + 1)) {
    const auto* entity = reference(text.substr(at));
    if (entity != nullptr && entity->second.find_first_of("<&") != std::string::npos) return true;
  }
  return false;
}

void Entities::check_external(std::string_view text) const {
  for (std::size_t at = text.find('&'); at != text.npos; at = text.find('&', at + 1)) {
    const std::string_view rest = text.substr(at);
    const std::size_t end = rest.substr(0, kMaxName).find(';');
    if (end == rest.npos || external_.count(std::string(rest.substr(1, end - 1))) == 0) continue;
    throw Error(ErrorCode::BadInput, "external entities are not read", {},
                std::string(rest.substr(0, end + 1)));
  }
}

std::string Entities::expand(std::string_view text) {
  std::string result;
  expand_onto(result, text, 0);
  return result;
}

void Entities::expand_onto(std::string& result, std::string_view text, int depth) {
  if (depth > kMaxDepth) {
    throw Error(ErrorCode::BadInput, "entities nested too deep", {}, std::string(text));
  }
  check_external(text);
  while (!text.empty()) {
    const std::size_t ordinary = std::min(text.find('&', text.front() == '&' ? 1 : 0), text.size());
    const auto* entity = reference(text);
    spent_ += entity == nullptr ? ordinary : 1;
    if (spent_ > kMaxExpansion) {
      throw Error(ErrorCode::Limit,
                  "entities expand to more than " + std::to_string(kMaxExpansion) + " characters");
    }
    if (entity == nullptr) {
      result.append(text.substr(0, ordinary));
      text.remove_prefix(ordinary);
    } else {
      expand_onto(result, entity->second, depth + 1);
      skip_behind(text, ";");
    }
  }
}

}  // namespace plumbline
