// A file that is there whole or not at all.
//
//     WholeFile file("run/snapshots/000000.vtu");
//     file.write(one), file.write(another);
//     file.name(true);
#pragma once

#include <string>
#include <string_view>

namespace actio::scene {

/// A file that is written piece by piece beside its place, and has its name when all of it is there: what is
/// large need not be put together in memory.
class WholeFile {
 public:
  /// @throws FileError  where it cannot be made; so do all that follow
  explicit WholeFile(std::string const& path);
  /// Without a name it is gone again.
  ~WholeFile();
  WholeFile(WholeFile const&) = delete;
  WholeFile& operator=(WholeFile const&) = delete;

  /// Behind what was written.
  WholeFile& write(std::string_view content);
  /// Over what was written, from a byte on.
  void write_at(std::size_t byte, std::string_view content);
  /// How many bytes were written.
  std::size_t size() const { return size_; }
  /// Gives it its name, in place of a file that has it; nothing is written any more.
  /// @param durable  whether to wait until the file and its name are on the disk
  void name(bool durable);

 private:
  [[noreturn]] void fail(int error) const;

  std::string path_, part_;
  int file_;
  bool named_ = false;
  std::size_t size_ = 0;
};

/// Whether an open file has its name still; it has not where it was removed, or another is in its place.
bool has_its_name(int file, std::string const& path);
/// What is said of a table that has not.
std::string lost_its_name(std::string const& path);
/// Refuses a file that a run is to go on behind the end of, where there is none.
/// @throws FileError  with what to do
void require_there(std::string const& path);

}  // namespace actio::scene
