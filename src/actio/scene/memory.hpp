// What a run remembers across a checkpoint: plain numbers, bit for bit.
//
//     void remember(Memory& memory) { memory(place_, steps_taken_); }       // saves, or restores
#pragma once

#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace actio::scene {

/// Bytes that are written in one order and read back in the same.
class Memory {
 public:
  /// To be written.
  Memory() = default;
  /// To be read back.
  explicit Memory(std::string bytes) : bytes_(std::move(bytes)), reading_(true) {}

  bool reading() const { return reading_; }
  std::string const& bytes() const { return bytes_; }

  /// Saves each value, or restores it.
  template <class... T>
  void operator()(T&... values) {
    (one(values), ...);
  }

 private:
  template <class T>
  void one(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    raw(&value, sizeof value);
  }
  template <class T>
  void one(std::vector<T>& values) {
    std::size_t size = values.size();
    one(size);
    if (size > bytes_.size()) throw std::runtime_error("memory: fewer bytes than it says");
    values.resize(size);
    if (size) raw(values.data(), size * sizeof(T));
  }
  template <class T>
  void one(std::span<T> values) {
    raw(values.data(), values.size_bytes());
  }
  void raw(void* at, std::size_t size) {
    if (!reading_) {
      bytes_.append(static_cast<char const*>(at), size);
      return;
    }
    if (at_ + size > bytes_.size()) throw std::runtime_error("memory: it ends too early");
    std::memcpy(at, bytes_.data() + at_, size);
    at_ += size;
  }

  std::string bytes_;
  std::size_t at_ = 0;
  bool reading_ = false;
};

}  // namespace actio::scene
