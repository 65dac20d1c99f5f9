// A file in HDF5 that grows, and that any reader can open at any instant: while it is written, and after its
// writer was killed or its disk was full.
//
// HDF5's mode of a single writer writes metadata in an order in which they are consistent at any instant. But
// it leaves a mark in the superblock that an ordinary reader refuses, and it tells the end of the file there
// only after it has told of what is beyond it. The driver of this header stands between the library and the
// disk and sees to three things:
//
// * The superblock on the disk never has the mark: the file looks closed.
// * Before anything tells of a place, room for it is reserved on the disk, and the superblock has an end of
//   the file beyond it. So a full disk is noticed before the first byte that tells of what has no room.
// * That end is some way beyond what is used, and the file, with a hole, as long. A reader that opened it a
//   while ago finds what was added since. The true end is in sixteen bytes after it, and the hole is gone as
//   soon as the file is closed.
//
// Room for numbers is taken in sixteens of bytes, so that a chunk can be given a length of four bytes more or
// less, and with it other properties, where it is.
//
// There are no locks on the file: the writer has the folder for itself, and others may read.
#pragma once

#include <cstdint>
#include <string>

#include "program/output/hdf5_library.hpp"

namespace actio::scene::hdf5 {

/// Sets a list of properties of access to files that grow through this driver.
/// @throws FileError  where the library refuses it
void set_growing_file(Session const& h5, hid_t access);
/// While it lives, files opened through the driver take heads of data sets and nothing else. So a data set
/// can be cut back at one blow, all that is not told of any more staying where it is: what the library would
/// do besides, step by step, would be half done in between.
class HeadsOnly {
 public:
  HeadsOnly();  ///< from here on
  ~HeadsOnly();
  HeadsOnly(HeadsOnly const&) = delete;
  HeadsOnly& operator=(HeadsOnly const&) = delete;
};

/// While it lives, the next room for numbers is taken at this place, where there is a chunk of about that
/// length already.
class InPlace {
 public:
  explicit InPlace(std::uint64_t place);  ///< from here on
  ~InPlace();
  InPlace(InPlace const&) = delete;
  InPlace& operator=(InPlace const&) = delete;
};
/// Where numbers were last read or written through the driver.
std::uint64_t last_place();

/// What the system said when the driver last failed, which is then forgotten; empty where it did not.
std::string driver_failure();

}  // namespace actio::scene::hdf5
