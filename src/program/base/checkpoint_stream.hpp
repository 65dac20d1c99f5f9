// The stream of bytes of a checkpoint: plain numbers, saved and restored bit for bit by the same lines.
//
//     void remember(CheckpointStream& stream) { stream(place_, steps_taken_); }       // saves, or restores
//
// What is read back is not trusted: it has to be as long as it says, and every list as long as the one that
// it takes the place of.
#pragma once

#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "actio/numbers/errors.hpp"

namespace actio::scene {

/// Serialises to a checkpoint, or from one: bytes that are written in one order and read back in the same.
class CheckpointStream {
 public:
  /// To be written.
  CheckpointStream() = default;
  /// To be read back.
  explicit CheckpointStream(std::string bytes) : bytes_(std::move(bytes)), reading_(true) {}

  /// Whether it restores what was saved.
  bool reading() const { return reading_; }
  /// All that was saved.
  std::string const& bytes() const { return bytes_; }

  /// So many bytes will be saved besides: then they are not copied as they become more.
  void expect(std::size_t bytes) {
    if (!reading_) bytes_.reserve(bytes_.size() + bytes);
  }
  /// Saves each value, or restores it. A list that is not empty keeps its size.
  /// @throws Error  where the bytes end too early, or a list has another size
  template <class... T>
  void operator()(T&... values) { (one(values), ...); }
  /// That all was read back.
  /// @throws Error  where bytes are left
  void end() const {
    if (reading_ && at_ != bytes_.size())
      throw Error("checkpoint: " + std::to_string(bytes_.size() - at_) + " bytes more than were expected");
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
    if (reading_) {
      if (!values.empty() && size != values.size())
        throw Error("checkpoint: a list of " + std::to_string(values.size()) + " is expected, found one of " +
                    std::to_string(size));
      if (size > (bytes_.size() - at_) / sizeof(T))
        throw Error("checkpoint: it ends within a list of " + std::to_string(size));
      values.resize(size);
    }
    if (size) raw(values.data(), size * sizeof(T));
  }
  template <class T>
  void one(std::span<T> values) { raw(values.data(), values.size_bytes()); }
  void raw(void* at, std::size_t size) {
    if (!reading_) {
      bytes_.append(static_cast<char const*>(at), size);
      return;
    }
    if (size > bytes_.size() - at_) throw Error("checkpoint: it ends too early");
    std::memcpy(at, bytes_.data() + at_, size);
    at_ += size;
  }

  std::string bytes_;
  std::size_t at_ = 0;
  bool reading_ = false;
};

}  // namespace actio::scene
