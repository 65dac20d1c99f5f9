#include "program/output/hdf5_last_chunks.hpp"

#include <algorithm>
#include <optional>

#include "program/output/hdf5_checksums.hpp"
#include "program/output/hdf5_file.hpp"

namespace actio::scene::hdf5 {
namespace {

/// Where the chunk with this row begins.
std::vector<hsize_t> place(DataSet const& set, hsize_t row) {
  std::vector<hsize_t> out(set.extent.size());
  out[0] = row;
  return out;
}

}  // namespace

void LastChunks::add(std::span<double const> row) {
  auto at = row.begin();
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    auto const end = at + static_cast<std::ptrdiff_t>(file_.sets()[i].width);
    chunks_[i].rows.insert(chunks_[i].rows.end(), at, end), at = end;
  }
}

void LastChunks::write(Session const& h5, std::size_t rows, Last last) {
  std::size_t const at_once = file_.rows_of_chunk();
  hsize_t const begin = (rows - 1) / at_once * at_once;
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    DataSet& set = file_.sets()[i];
    Chunk& chunk = chunks_[i];
    if (set.extent[0] != rows) {
      set.extent[0] = rows;
      file_.check(h5, h5->H5Dset_extent(set.id, set.extent.data()), "cannot be written");
    }
    // What is there from before it was cut back stays, for a reader that is about to read it.
    buffer_.assign(growing(set), 0);
    if (chunk.behind) get(h5, set, chunk, begin);
    // A chunk that was full has the rows that this one will have.
    if (last == Last::full || chunk.length != full(set)) {
      auto const numbers = chunk.bytes();
      std::copy(numbers.begin(), numbers.end(), buffer_.begin());
      put(h5, set, chunk, begin, last);
    }
    if (rows % at_once == 0) chunk.rows.clear(), chunk.length = 0;
  }
}

void LastChunks::unseal(Session const& h5) {
  std::size_t const at_once = file_.rows_of_chunk();
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    DataSet const& set = file_.sets()[i];
    Chunk& chunk = chunks_[i];
    if (set.extent[0] % at_once == 0) continue;
    hsize_t const begin = set.extent[0] - set.extent[0] % at_once;
    buffer_.assign(growing(set), 0);
    get(h5, set, chunk, begin);
    if (chunk.length == full(set)) put(h5, set, chunk, begin, Last::growing);
    chunk.length = 0;
  }
  tell(h5);
}
void LastChunks::expect_chunks() {
  for (auto& chunk : chunks_) chunk.behind = true;
}

std::vector<std::uint32_t> LastChunks::checksums() const {
  std::vector<std::uint32_t> sums;
  for (auto const& chunk : chunks_) sums.push_back(fletcher32(chunk.bytes()));
  return sums;
}

/// The chunk in the buffer goes to the file.
void LastChunks::put(Session const& h5, DataSet const& set, Chunk& chunk, hsize_t begin, Last last) {
  std::size_t const size = last == Last::full ? full(set) : growing(set);
  auto const numbers = std::span(buffer_).first(full(set) - 4);
  if (last == Last::full) encode(buffer_.data() + numbers.size(), fletcher32(numbers));
  auto const at = place(set, begin);
  std::uint32_t const without_checksum = last == Last::full ? 0 : 1;
  std::optional<InPlace> in_place;
  if (chunk.length != 0 && chunk.length != size) in_place.emplace(chunk.place);
  file_.check(h5, h5->H5Dwrite_chunk(set.id, H5P_DEFAULT, without_checksum, at.data(), size, buffer_.data()),
              "cannot be written");
  chunk.length = size, chunk.place = last_place();
  untold_ += size;
}
/// A chunk that is there comes into the buffer, and its length and place are found. Where it is not, the
/// others are not either.
void LastChunks::get(Session const& h5, DataSet const& set, Chunk& chunk, hsize_t begin) {
  auto const at = place(set, begin);
  // Of a chunk that is not there the library says so by an error, or by a length of zero.
  chunk.length = 0;
  chunk.behind = h5->H5Dget_chunk_storage_size(set.id, at.data(), &chunk.length) >= 0 && chunk.length != 0;
  if (!chunk.behind) return;
  if (chunk.length != full(set) && chunk.length != growing(set))
    file_.refuse(file_.path() + ": is not the table of this scene");
  std::uint32_t without_checksum = 0;
  file_.check(h5, h5->H5Dread_chunk(set.id, H5P_DEFAULT, at.data(), &without_checksum, buffer_.data()),
              "cannot be read");
  chunk.place = last_place();
}

}  // namespace actio::scene::hdf5
