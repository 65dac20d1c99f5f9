// Snapshots: the whole state of a field at some times, in files of their own.
//
//     run/snapshots/000000.csv, 000001.csv, ...      what the system writes of each
//     run/snapshots/times.csv                        their numbers and times
//
// A system says what its snapshots can hold (`SnapshotKind`, in its `System`), and sets up a writer where a
// scene asks for them (`Simulation::snapshots`). When they are taken, and that a run that was cut short
// leaves the same ones, is a matter of the run. A snapshot is written whole, and counts when `times.csv` has
// its row; one that was cut short is written over. Other formats are made of these files.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace actio::scene {

/// What snapshots of a kind of system can hold.
struct SnapshotKind {
  /// Something that can be asked for.
  struct Column {
    std::string name;     ///< as scenes write it
    std::string meaning;  ///< in a few words
  };
  std::string always;                ///< what every one of them holds, in words
  std::vector<Column> columns;       ///< what can be asked for besides
  std::vector<Column> formats = {};  ///< in which they can be had besides tables: "netcdf"
  std::string in_hdf5 = {};          ///< what of them "hdf5" leaves; empty: nothing
};

/// What a scene wants of its snapshots.
struct SnapshotRequest {
  std::vector<std::string> columns;  ///< besides what every one of them holds
  std::vector<std::string> formats;  ///< of the scene
  /// Whether this format is wanted.
  bool in(std::string const& format) const;
};

struct PlayedMedium;

/// Numbers of a snapshot, or of what all have in common, along named axes: for who has them in memory.
struct SnapshotArray {
  std::string name;                  ///< as in the files
  std::string meaning;               ///< in a few words
  std::vector<std::string> axes;     ///< "node", "component"
  std::vector<std::size_t> shape;    ///< along them
  std::vector<double> numbers{};     ///< the last axis fastest
  std::vector<std::string> names{};  ///< along the last axis, where they have some
  std::string unit{};                ///< empty where it is not known
  bool counts = false;               ///< whether they are whole numbers
};

/// What writes the snapshots of one run: the state of its motion at the time of the call.
class SnapshotWriter {
 public:
  virtual ~SnapshotWriter() = default;
  /// The files of one snapshot, with the folder within that of the run: "snapshots/000000.csv".
  virtual std::vector<std::string> files(long number) const = 0;
  /// The files that another format leaves of the first so many of them; none where it leaves nothing.
  virtual std::vector<std::string> files_in(std::string const& format, long taken) const {
    return (void)format, (void)taken, std::vector<std::string>{};
  }
  /// Makes these, each whole, out of the files of the snapshots.
  /// @param folder   of the run
  /// @param times    of the snapshots
  /// @param durable  whether they are on the disk afterwards
  /// @throws FileError
  virtual void make(std::string const& format, std::string const& folder, std::span<double const> times,
                    bool durable) const {
    (void)format, (void)folder, (void)times, (void)durable;
  }
  /// About how many bytes one of them takes on the disk; zero where that is not known.
  virtual double bytes_of_one() const { return 0; }
  /// Writes one; files of that name are written over.
  /// @param durable  whether it is on the disk afterwards
  /// @throws FileError
  virtual void write(std::string const& folder, long number, double time, bool durable) = 0;
  /// The places to which the numbers of every snapshot belong.
  virtual std::vector<SnapshotArray> coordinates() const = 0;
  /// What a snapshot of the state now holds: the numbers that `write` would write.
  virtual std::vector<SnapshotArray> fields() const = 0;
  /// The same of a snapshot that was written.
  /// @throws FileError  where it cannot be read
  virtual std::vector<SnapshotArray> fields_in(std::string const& folder, long number) const = 0;
  /// What the pictures of a run show of a medium; null where there is none.
  /// @param times  of the snapshots that are in the folder
  /// @throws FileError  where one cannot be read
  virtual std::shared_ptr<PlayedMedium const> played(std::string const& folder,
                                                     std::span<double const> times) const {
    return (void)folder, (void)times, nullptr;
  }
};

/// `snapshots/000012` and an ending.
std::string snapshot_file(long number, std::string const& ending);

/// The most snapshots of a run: what six digits count.
constexpr long most_snapshots = 1000000;

}  // namespace actio::scene
