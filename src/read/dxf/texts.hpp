#pragma once

#include <optional>

#include "plumbline/structure/model.hpp"
#include "read/dxf/entity.hpp"
#include "read/dxf/names.hpp"

namespace plumbline::dxf {

/// Whether entities of this type are texts, which name what they stand in.
bool is_text(std::string_view type);
/// What a TEXT, MTEXT, ATTRIB or ATTDEF says, on one line, and the point of it that the file has:
/// of a justified text its alignment point, or the middle of the line that it is fitted to; of an
/// MTEXT the point that it is attached by. None for an empty text, an ATTRIB that is invisible, and
/// an ATTDEF but for a constant one in a block. Requires: is_text of the type. Throws: Unusable for
/// one without a place.
std::optional<Model::Text> text_of(const Entity& entity, const Names& names, bool in_block);

/// A text without its formatting: `%%c`, `%%d`, `%%p` and `%%nnn` as characters; of an MTEXT also
/// without `{`, `}` and what follows a `\`, fractions as "1/2", paragraphs and tabs as blanks.
/// Blanks are single, none at the ends.
std::string plain_text(std::string_view text, bool is_mtext);

}  // namespace plumbline::dxf
