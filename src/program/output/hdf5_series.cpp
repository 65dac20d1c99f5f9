// A data set for each quantity, in a file that any reader can open at any instant (hdf5_file.hpp), with a
// checksum on every chunk of numbers (hdf5_last_chunks.hpp).
#include "program/output/hdf5_last_chunks.hpp"
#include "program/output/series_reader.hpp"

namespace actio::scene {
namespace {

using hdf5::LastChunks, hdf5::SeriesFile, hdf5::Session;

class Hdf5Series : public Series {
 public:
  Hdf5Series(Session const& h5, std::string const& path, SeriesHead const& head, bool resume)
      : file_(resume ? SeriesFile::find(h5, path, head) : SeriesFile::make(h5, path, head)),
        last_(file_),
        groups_(head.groups) {}
  ~Hdf5Series() override {
    if (!file_.has_failed() && !file_.is_open()) return;  // it was to be gone on with, and was not
    Session const h5;
    try {
      if (!file_.has_failed()) seal(h5);
      file_.close(h5);
    } catch (FileError const&) {
    }
  }

  void add(std::span<double const> row) override {
    file_.rethrow();
    last_.add(row);
    if (++rows_ % file_.rows_of_chunk() != 0) return;
    Session const h5;
    last_.write(h5, rows_, LastChunks::Last::full);
    if (last_.untold() > enough) tell(h5);
  }
  void flush() override {
    file_.rethrow();
    Session const h5;
    file_.refuse_lost(h5);
    if (told_ == rows_) return;
    if (rows_ % file_.rows_of_chunk() != 0) last_.write(h5, rows_, LastChunks::Last::growing);
    tell(h5);
  }
  void sync() override {
    flush();
    Session const h5;
    file_.sync(h5);
  }
  void remember(CheckpointStream& stream) override {
    file_.rethrow();
    auto sums = last_.checksums();
    stream(rows_, sums);
    if (!stream.reading()) return;
    read_back(sums);
    Session const h5;
    file_.open(h5);
    last_.unseal(h5);
    file_.close(h5);
    file_.cut_back(h5, rows_);
    file_.open(h5);
    last_.expect_chunks();
    told_ = rows_;
  }

 private:
  static constexpr std::size_t enough = 1 << 17;  // bytes that are not told of

  /// Reads the rows that a checkpoint remembers, each chunk against its checksum; keeps those of the last
  /// chunk.
  void read_back(std::vector<std::uint32_t> const& sums) {
    for (auto const& set : file_.sets())
      if (set.extent[0] < rows_)
        file_.refuse(file_.path() + ": has " + std::to_string(set.extent[0]) +
                     " rows, where the checkpoint needs " + std::to_string(rows_) + "; it was cut since");
    auto const reader = read_hdf5_series(file_.path(), groups_);
    std::vector<double> row(file_.width());
    std::size_t const whole = rows_ - rows_ % file_.rows_of_chunk();
    for (std::size_t k = 0; k < rows_; ++k) {
      if (!reader->next(row)) file_.refuse(file_.path() + ": ends too early");
      if (k >= whole) last_.add(row);
    }
    auto const found = last_.checksums();
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i] != sums[i]) file_.refuse(hdf5::damage(file_.path(), file_.sets()[i].name(), whole, rows_));
  }
  void tell(Session const& h5) { last_.tell(h5), told_ = rows_; }
  /// The last chunk gets its checksum, for good.
  void seal(Session const& h5) {
    if (rows_ % file_.rows_of_chunk() != 0) {
      last_.write(h5, rows_, LastChunks::Last::growing), tell(h5);
      last_.write(h5, rows_, LastChunks::Last::full);
    }
    tell(h5);
  }

  SeriesFile file_;
  LastChunks last_;
  std::vector<ColumnGroup> groups_;
  std::size_t rows_ = 0, told_ = 0;  // all of them, and those that the file tells of
};

}  // namespace

std::unique_ptr<Series> hdf5_series(std::string const& path, SeriesHead const& head, bool resume) {
  Session const h5;
  return std::make_unique<Hdf5Series>(h5, path, head, resume);
}

}  // namespace actio::scene
