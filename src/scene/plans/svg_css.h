// The grammar of CSS as far as style sheets of SVG need it (CSS Syntax level 3, Selectors level 3).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/plans/svg_style.h"

namespace shatterpave::scene {

// Without comments; text in quotes is left alone.
std::string without_css_comments(std::string_view css);

// The place of the first of `ends` from `at` on, outside of quotes and brackets; the size of the text if there is none.
std::size_t css_end(std::string_view css, std::size_t at, std::string_view ends);

// What stands between the separators.
std::vector<std::string_view> css_parts(std::string_view css, char separator);

// Declarations of a block or of a `style` attribute: those that change what a plan is read as, and are valid.
std::vector<CssDeclaration> css_declarations(std::string_view body);

// One selector. Nothing for what is no selector, which CSS passes over; throws SvgError for one that is beyond this reader.
std::optional<std::vector<CssCompound>> css_selector(std::string_view text);

// The digits of its specificity (Selectors level 3, 9).
int specificity_of(const std::vector<CssCompound>& selector);

// Whether a sheet for these media applies to a screen; nothing where that depends on the screen.
std::optional<bool> css_media_apply(std::string_view media);

std::string_view trimmed(std::string_view text);
std::string lower_case(std::string_view text);

}  // namespace shatterpave::scene
