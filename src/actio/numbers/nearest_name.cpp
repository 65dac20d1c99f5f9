#include "actio/numbers/nearest_name.hpp"

namespace actio {

namespace detail {

std::size_t letters_apart(std::string_view a, std::string_view b) {
  std::vector<std::size_t> two(b.size() + 1), one(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) one[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({one[j] + 1, now[j - 1] + 1, one[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        now[j] = std::min(now[j], two[j - 2] + 1);
    }
    std::swap(two, one), std::swap(one, now);
  }
  return one[b.size()];
}

}  // namespace detail

std::string nearest_name(std::string_view word, std::vector<std::string> const& known) {
  constexpr std::size_t longest = 64;  // no name is longer, and the work stays small
  if (word.empty() || word.size() > longest) return "";
  std::string best;
  std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (auto const& name : known) {
    bool const begins = word.size() >= 3 && name.starts_with(word);
    std::size_t const away = begins ? 1 : detail::letters_apart(word, name);
    if (away < least && away < std::max(word.size(), name.size())) least = away, best = name;
  }
  return best;
}

}  // namespace actio
