#include "program/document/input_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

namespace actio::scene {
namespace {

/// As it is now; nothing where it cannot be read.
std::optional<InputFile> looked_at(std::string const& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return {};
  std::string const text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) return {};
  return InputFile{path, text.size(), fingerprint_of(text)};
}

void refuse_unlike(InputFile const& then, std::optional<InputFile> const& now) {
  if (now && now->bytes == then.bytes && now->fingerprint == then.fingerprint) return;
  throw InputChanged(
      {then.path},
      !now ? "cannot be read any more, and the scene was read with it; put it back, or run the scene anew"
           : fmt::format("has changed since the scene was read with it ({} bytes then, {} now), and "
                         "numbers from both are not joined; put it back as it was, or run the scene anew",
                         then.bytes, now->bytes));
}

}  // namespace

std::uint64_t fingerprint_of(std::string_view bytes) {
  std::uint64_t h = 14695981039346656037u ^ bytes.size();
  for (std::size_t at = 0; at < bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
    h = (h ^ word) * 1099511628211u;
    h ^= h >> 32;
  }
  return h;
}

void refuse_changed(InputFiles const& before) {
  for (auto const& then : before) refuse_unlike(then, looked_at(then.path));
}
void refuse_changed(InputFiles const& before, InputFiles const& now) {
  for (auto const& then : before)
    for (auto const& found : now)
      if (found.path == then.path) refuse_unlike(then, found);
}

void remember(CheckpointStream& stream, std::string& text) {
  std::vector<char> letters;
  if (!stream.reading()) letters.assign(text.begin(), text.end());
  stream(letters);
  text.assign(letters.begin(), letters.end());
}
void remember(CheckpointStream& stream, InputFiles& files) {
  std::size_t size = files.size();
  stream(size);
  if (stream.reading() && size > stream.bytes().size()) throw Error("checkpoint: a list of files is damaged");
  files.resize(size);
  for (auto& file : files) remember(stream, file.path), stream(file.bytes, file.fingerprint);
}

}  // namespace actio::scene
