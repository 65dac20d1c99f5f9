// What is remembered of a body on its way, as bytes.
#pragma once

#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace actio::testing {

/// Saves numbers one after the other, and gives them back in that order.
class Bytes {
 public:
  template <class... T>
  void operator()(T&... values) { (one(values), ...); }
  /// From now on what was saved is given back.
  Bytes& rewind() { return reading_ = true, at_ = 0, *this; }
  /// Whether all of it was.
  bool at_end() const { return at_ == bytes_.size(); }

 private:
  template <class T>
  void one(T& value) { raw(&value, sizeof value); }
  void one(std::span<double> values) { raw(values.data(), values.size_bytes()); }
  void raw(void* at, std::size_t size) {
    if (!reading_) return void(bytes_.append(static_cast<char const*>(at), size));
    if (at_ + size > bytes_.size()) throw std::runtime_error("bytes: they end too early");
    std::memcpy(at, bytes_.data() + at_, size), at_ += size;
  }
  std::string bytes_;
  std::size_t at_ = 0;
  bool reading_ = false;
};

/// Gives back what was saved, but one of the whole numbers at its head changed.
struct Damaged {
  Bytes& bytes;
  int place, value, seen = 0;
  template <class... T>
  void operator()(T&... values) {
    bytes(values...);
    (one(values), ...);
  }
  template <class T>
  void one(T& number) {
    if constexpr (std::is_same_v<T, int>)
      if (seen++ == place) number = value;
  }
};

}  // namespace actio::testing
