#include "book/png.hpp"

#include <zlib.h>

#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace book {
namespace {

void append_number(std::string& out, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(number >> shift & 0xff);
}
void append_piece(std::string& out, std::string const& kind, std::string const& content) {
  std::string const summed = kind + content;
  append_number(out, static_cast<std::uint32_t>(content.size()));
  out += summed;
  append_number(out, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<Bytef const*>(summed.data()),
                                                      static_cast<uInt>(summed.size()))));
}

/// The predictor of Paeth: of three neighbours the one nearest to left + above - corner.
int paeth(int left, int above, int corner) {
  int const a = std::abs(above - corner), b = std::abs(left - corner),
            c = std::abs(left + above - 2 * corner);
  return a <= b && a <= c ? left : b <= c ? above : corner;
}
/// A row as its differences from one of five predictions.
std::string filtered(int filter, std::span<unsigned char const> row, std::span<unsigned char const> above) {
  std::string out(1, static_cast<char>(filter));
  for (std::size_t j = 0; j < row.size(); ++j) {
    int const left = j > 0 ? row[j - 1] : 0, up = above.empty() ? 0 : above[j],
              corner = j > 0 && !above.empty() ? above[j - 1] : 0;
    int const predicted[] = {0, left, up, (left + up) / 2, paeth(left, up, corner)};
    out += static_cast<char>(row[j] - predicted[filter]);
  }
  return out;
}
long size_of(std::string const& differences) {
  long sum = 0;
  for (char const c : differences) sum += std::abs(static_cast<int>(static_cast<signed char>(c)));
  return sum;
}
/// The rows, each by the filter that leaves least, as zlib packs them.
std::string packed(int width, int height, std::span<unsigned char const> cells) {
  std::string rows;
  auto const row = [&](int i) {
    return cells.subspan(static_cast<std::size_t>(i) * static_cast<std::size_t>(width),
                         static_cast<std::size_t>(width));
  };
  for (int i = 0; i < height; ++i) {
    std::string best;
    for (int filter = 0; filter < 5; ++filter) {
      auto candidate = filtered(filter, row(i), i > 0 ? row(i - 1) : std::span<unsigned char const>());
      if (best.empty() || size_of(candidate) < size_of(best)) best = std::move(candidate);
    }
    rows += best;
  }
  uLongf size = compressBound(rows.size());
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<Bytef const*>(rows.data()),
                rows.size(), 9) != Z_OK)
    throw std::runtime_error("a picture could not be packed");
  out.resize(size);
  return out;
}

std::string picture_of(int width, int height, std::span<unsigned char const> cells, char kind,
                       std::string const& pieces) {
  std::string head, out = "\x89PNG\r\n\x1a\n";
  append_number(head, static_cast<std::uint32_t>(width));
  append_number(head, static_cast<std::uint32_t>(height));
  head += '\x08';  // a byte for each cell
  head += kind;
  head += std::string(3, '\0');
  append_piece(out, "IHDR", head);
  out += pieces;
  append_piece(out, "IDAT", packed(width, height, cells));
  append_piece(out, "IEND", "");
  return out;
}

}  // namespace

std::string png(int width, int height, std::span<unsigned char const> cells,
                std::vector<Colour> const& palette) {
  std::string colours, opaque(palette.size(), '\xff'), pieces;
  for (auto const& colour : palette)
    for (unsigned char const part : colour) colours += static_cast<char>(part);
  bool const room = palette.size() < 256;
  if (room) colours += std::string(3, '\xff'), opaque += '\0';
  append_piece(pieces, "PLTE", colours);
  if (room) append_piece(pieces, "tRNS", opaque);
  return picture_of(width, height, cells, '\3', pieces);
}

std::string grey_png(int width, int height, std::span<unsigned char const> cells) {
  return picture_of(width, height, cells, '\0', "");
}

std::string base64(std::string const& bytes) {
  static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::size_t const there = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t three = 0;
    for (std::size_t i = 0; i < 3; ++i)
      three = three << 8 | (i < there ? static_cast<unsigned char>(bytes[at + i]) : 0);
    for (std::size_t i = 0; i < 4; ++i) out += i <= there ? letters[three >> (18 - 6 * i) & 63] : '=';
  }
  return out;
}

}  // namespace book
