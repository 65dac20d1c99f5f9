#include "actio/any_group/named_algebra.hpp"

namespace actio::systems {

namespace detail {

std::string nearest_group(std::string_view word) {
  auto const small = [](std::string_view from) {
    std::string out;
    for (unsigned char const c : from)
      if (std::isalpha(c)) out += static_cast<char>(std::tolower(c));
    return out;
  };
  std::vector<std::string> stems;
  for (auto const& family : group_families()) stems.push_back(small(family.stem));
  std::string const near = nearest_name(small(word), stems);
  if (near.empty()) return "";
  auto const& family =
      group_families()[static_cast<std::size_t>(std::find(stems.begin(), stems.end(), near) - stems.begin())];
  std::string digits;
  for (unsigned char const c : word)
    if (std::isdigit(c) && (c != '0' || !digits.empty())) digits += static_cast<char>(c);
  int const number = digits.empty() || digits.size() > 2 ? 0 : std::stoi(digits);
  bool const is_one = number >= family.least && number <= family.most && number % family.divisor == 0;
  return is_one ? family.name_with(digits) : family.pattern();
}

GroupOfMatrices GroupName::read(std::string_view text) {
  if (text.size() > 1000)
    throw OutsideDomain("name of a group", "a shorter name is needed; letters",
                        static_cast<double>(text.size()), 1000);
  GroupName name(text);
  GroupOfMatrices group = name.product();
  if (!name.at_end()) name.refuse("'x', '|x' or the end of the name");
  return group;
}

bool GroupName::take(std::string_view word) {
  skip_spaces();
  bool const here = text_.substr(at_).starts_with(word);
  if (here) at_ += word.size();
  return here;
}

void GroupName::refuse(std::string const& expected) {
  skip_spaces();
  std::string const rest(text_.substr(at_, 20));
  throw UnknownGroup("group \"" + std::string(text_) +
                     "\": " + (rest.empty() ? "the name ends" : "'" + rest + "' stands") + " where " +
                     expected + " is needed; names are " + group_patterns() +
                     ", products \"SO(3) x R^1\" and semidirect products \"SL(2) |x R^2\"");
}

GroupOfMatrices GroupName::product() {
  GroupOfMatrices group = semidirect();
  while (take("x")) {
    GroupOfMatrices const factor = semidirect();
    require_moderate_dimension(group.name + " x " + factor.name,
                               static_cast<double>(group.basis.size() + factor.basis.size()));
    group = product_matrices(group, factor);
  }
  return group;
}

GroupOfMatrices GroupName::semidirect() {
  GroupOfMatrices group = single();
  while (take("|x")) {
    std::string const space = "R^" + std::to_string(group.size());
    skip_spaces();
    std::size_t const from = at_;
    GroupOfMatrices const factor = single();
    if (factor.name != space) {
      at_ = from;
      refuse(space + ", the space that the matrices of " + group.name + " act on,");
    }
    require_moderate_dimension(group.name + " |x " + space,
                               static_cast<double>(group.basis.size()) + group.size());
    group = semidirect_matrices(group, space);
  }
  return group;
}

GroupOfMatrices GroupName::single() {
  if (take("(")) {
    GroupOfMatrices group = product();
    if (!take(")")) refuse("a closing bracket");
    return group;
  }
  std::size_t const from = at_;
  std::string const stem(while_letters([](unsigned char c) { return std::isalpha(c) || c == '_'; }));
  for (auto const& family : group_families())
    if (family.stem == stem && (family.open == 0 || take(std::string_view(&family.open, 1))))
      return member(family);
  at_ = from;
  refuse_unknown();
}

GroupOfMatrices GroupName::member(GroupFamily const& family) {
  if (family.open == 0) return family.make(family.stem, 0);
  skip_spaces();
  std::string const digits(while_letters([](unsigned char c) { return std::isdigit(c); }));
  if (digits.empty()) refuse("the number of " + family.pattern());
  if (family.open == '(' && !take(")")) refuse("a closing bracket");
  return of_order(family, digits.size() > 9 ? 1e9 : std::stod(digits), family.name_with(digits));
}

GroupOfMatrices GroupName::of_order(GroupFamily const& family, double number, std::string const& name) {
  std::string const where = "group " + name;
  if (!(number >= family.least)) throw OutsideDomain(where, "the number is too small", number, family.least);
  int const most = largest_dimension_of_algebra;
  if (family.most < most && !(number <= family.most))
    throw OutsideDomain(where, "the number is too large", number, family.most);
  require_moderate_dimension(name, family.dimension(number));
  int const n = static_cast<int>(number);
  if (n % family.divisor != 0) throw OutsideDomain(where, "an even number is needed", n, n + 1);
  return family.make(family.name_with(std::to_string(n)), n);
}

void GroupName::refuse_unknown() {
  skip_spaces();
  std::size_t const from = at_;
  std::string const word(while_letters([](unsigned char c) { return c != ' ' && c != '|' && c != 'x'; }));
  at_ = from;
  std::string const near = nearest_group(word);
  if (near.empty()) refuse("the name of a group");
  throw UnknownGroup("group \"" + std::string(text_) + "\": there is no '" + word + "'; did you mean '" +
                     near + "'? Names are " + group_patterns());
}

std::vector<std::string> own_components(std::string const& group) {
  if (group == "SO(3)") return {"w1", "w2", "w3"};
  if (group == "SE(2)") return {"w", "v1", "v2"};
  if (group == "SE(3)") return {"w1", "w2", "w3", "v1", "v2", "v3"};
  return {};
}

}  // namespace detail

MatrixAlgebra named_algebra(std::string_view name) {
  detail::GroupOfMatrices group = detail::GroupName::read(name);
  MatrixAlgebra algebra = detail::algebra_of_basis(group.name, std::move(group.basis));
  if (auto own = detail::own_components(algebra.name); !own.empty()) algebra.components = std::move(own);
  algebra.distance_from_group = std::move(group.distance);
  return algebra;
}

}  // namespace actio::systems
