// The two checksums of the HDF5 format that the series writes itself: that of a superblock, and that of a
// chunk of numbers.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

namespace actio::scene::hdf5 {

/// A number of the file, which is little-endian.
template <class Word>
Word decoded(unsigned char const* at) {
  Word out = 0;
  for (std::size_t i = 0; i < sizeof(Word); ++i)
    out |= static_cast<Word>(static_cast<Word>(at[i]) << (8 * i));
  return out;
}
/// Writes a number as the file has it.
template <class Word>
void encode(unsigned char* at, Word value) {
  for (std::size_t i = 0; i < sizeof(Word); ++i) at[i] = static_cast<unsigned char>(value >> (8 * i));
}

/// Jenkins' lookup3 with the initial value zero, of a length that is a multiple of four and not zero: the
/// checksum of metadata.
inline std::uint32_t metadata_checksum(std::span<unsigned char const> bytes) {
  std::array<std::uint32_t, 3> s;
  s.fill(0xdeadbeef + static_cast<std::uint32_t>(bytes.size()));
  // Each line: the words that change and that change them, and by how much is turned.
  auto const mix = [&s](int x, int y, int z, int turn) {
    s[x] -= s[y], s[x] ^= std::rotl(s[y], turn), s[y] += s[z];
  };
  auto const last = [&s](int x, int y, int turn) { s[x] ^= s[y], s[x] -= std::rotl(s[y], turn); };
  std::size_t at = 0;
  for (; bytes.size() - at > 12; at += 12) {
    for (int i = 0; i < 3; ++i) s[i] += decoded<std::uint32_t>(bytes.data() + at + 4 * i);
    mix(0, 2, 1, 4), mix(1, 0, 2, 6), mix(2, 1, 0, 8), mix(0, 2, 1, 16), mix(1, 0, 2, 19), mix(2, 1, 0, 4);
  }
  for (int i = 0; at < bytes.size(); at += 4, ++i) s[i] += decoded<std::uint32_t>(bytes.data() + at);
  last(2, 1, 14), last(0, 2, 11), last(1, 0, 25), last(2, 1, 16), last(0, 2, 4), last(1, 0, 14),
      last(2, 1, 24);
  return s[2];
}

/// Fletcher's sum of pairs of bytes, as the filter of HDF5 counts them: the checksum of a chunk.
/// @param bytes  an even number of them
inline std::uint32_t fletcher32(std::span<unsigned char const> bytes) {
  std::uint64_t first = 0, second = 0;
  // A sum that is not zero stays so: it is counted from 1 to 65535.
  auto const folded = [](std::uint64_t sum) { return sum == 0 ? 0 : (sum - 1) % 65535 + 1; };
  for (std::size_t at = 0; at < bytes.size();) {
    // So many at a time that nothing overflows.
    std::size_t const end = std::min(bytes.size(), at + (std::size_t{1} << 20));
    for (; at + 1 < end; at += 2)
      first += static_cast<std::uint64_t>(bytes[at]) << 8 | bytes[at + 1], second += first;
    first = folded(first), second = folded(second);
  }
  return static_cast<std::uint32_t>(second << 16 | first);
}

}  // namespace actio::scene::hdf5
