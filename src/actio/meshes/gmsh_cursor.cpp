#include "actio/meshes/gmsh_cursor.hpp"

namespace actio::media {

std::string_view GmshCursor::word(char const* what) {
  skip_blanks();
  last_ = at_;
  if (left() == 0) fail(std::string("the file ends where ") + what + " should be");
  while (at_ < text_.size() && !blank(text_[at_]) && (at_ == last_ || text_[at_] != '"')) ++at_;
  return text_.substr(last_, at_ - last_);
}

std::string_view GmshCursor::line() {
  last_ = at_;
  auto const end = text_.find('\n', at_);
  auto const rest = text_.substr(at_, end == text_.npos ? text_.npos : end - at_);
  at_ = end == text_.npos ? text_.size() : end + 1;
  return rest;
}

std::string GmshCursor::quoted() {
  skip_blanks();
  last_ = at_;
  if (left() == 0 || text_[at_] != '"') fail("a name in quotation marks is needed");
  auto const end = text_.find_first_of("\"\n", at_ + 1);
  if (end == text_.npos || text_[end] != '"') fail("a name is not closed by a quotation mark");
  at_ = end + 1;
  return std::string(text_.substr(last_ + 1, end - last_ - 1));
}

bool GmshCursor::pass(std::string const& sought) {
  auto const found = text_.find(sought, at_);
  if (found == text_.npos) return false;
  last_ = found, at_ = found + sought.size();
  return true;
}

std::size_t GmshCursor::checked(std::size_t count, std::size_t numbers, std::size_t bytes,
                                char const* what) const {
  std::size_t const each = binary ? bytes : 2 * numbers;
  if (count > (left() + 1) / each)
    fail(std::to_string(count) + " " + what + " are announced, and the file has room for " +
         std::to_string((left() + 1) / each));
  return count;
}

}  // namespace actio::media
