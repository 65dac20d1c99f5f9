#include "actio/formula/decimal_constant.hpp"

namespace actio {

TapeBuilder::Entry decimal_constant(TapeBuilder& b, std::string_view digits, long k, double nearest) {
  constexpr std::size_t at_once = 18;  // digits that fit into 64 bits
  while (digits.size() > 1 && digits.back() == '0') digits.remove_suffix(1), ++k;
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  if (digits == "0") return b.number(0);
  auto const power_of_ten = [&](long n) {
    TapeBuilder::Entry power = b.number(1), square = b.number(10);
    for (; n > 0; n /= 2) {
      if (n % 2) power = b.multiply(power, square);
      if (n > 1) square = b.multiply(square, square);
    }
    return power;
  };
  TapeBuilder::Entry all = b.number(0);
  for (std::size_t i = 0; i < digits.size(); i += at_once) {
    auto const part = digits.substr(i, at_once);
    std::int64_t value = 0;
    std::from_chars(part.data(), part.data() + part.size(), value);
    all =
        b.add(b.multiply(all, power_of_ten(static_cast<long>(part.size()))), b.number(ExactRatio{value, 1}));
  }
  auto const scale = power_of_ten(std::labs(k));
  auto const result = k < 0 ? b.divide(all, scale) : b.multiply(all, scale);
  b.set_value(result, nearest);
  return result;
}

TapeBuilder::Entry decimal_constant(TapeBuilder& b, std::string_view text, double nearest) {
  if (nearest == 0) return b.number(0);
  auto const e = std::min(text.find_first_of("eE"), text.size());
  long power = 0;
  if (e < text.size()) {
    std::size_t const from = e + (text[e + 1] == '+' ? 2 : 1);
    std::from_chars(text.data() + from, text.data() + text.size(), power);
  }
  std::string digits(text.substr(0, e));
  if (auto const point = digits.find('.'); point != std::string::npos) {
    digits.erase(point, 1);
    power -= static_cast<long>(digits.size() - point);
  }
  return decimal_constant(b, digits, power, nearest);
}

TapeBuilder::Entry decimal_constant(TapeBuilder& b, double x) {
  if (!std::isfinite(x)) throw NotFinite("a constant of a formula");
  char text[40];
  char* const end = std::to_chars(text, text + sizeof text, std::abs(x), std::chars_format::scientific).ptr;
  auto const size =
      decimal_constant(b, std::string_view(text, static_cast<std::size_t>(end - text)), std::abs(x));
  if (x >= 0) return size;
  auto const result = b.negate(size);
  b.set_value(result, x);
  return result;
}

}  // namespace actio
