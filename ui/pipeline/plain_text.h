// Texts of others, for people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ui {

/// The text of an exception as a sentence: of an assertion in CGAL or nlohmann's JSON, what it means for whoever reads
/// it; any other text unchanged.
[[nodiscard]] std::string plain(std::string_view text);

/// The text as a terminal or a browser may be shown it, in valid UTF-8: controls (but newlines and tabs) and bytes that
/// are no UTF-8 become "\x1b".
[[nodiscard]] std::string printable(std::string_view text);

/// A number with six digits; what is but rounding beside `scale` is 0.
[[nodiscard]] std::string number_text(double value, double scale);

/// How many characters a text in UTF-8 has.
[[nodiscard]] std::size_t character_count(std::string_view text);

}  // namespace ui
