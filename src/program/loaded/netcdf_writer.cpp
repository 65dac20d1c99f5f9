// Files in NetCDF-4.
#include <netcdf.h>

#include <stdexcept>

#include "program/output/array_file.hpp"

namespace actio::scene {
namespace {

void checked(int status) {
  if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

class NetcdfWriter : public ArrayWriter {
 public:
  NetcdfWriter(std::string const& path, std::vector<ArrayAttribute> const& attributes,
               std::vector<ArraySet> const& sets) {
    checked(nc_create(path.c_str(), NC_NETCDF4 | NC_CLOBBER, &file_));
    open_ = true;
    for (auto const& one : attributes) attach(file_, NC_GLOBAL, one);
    for (auto const& set : sets) define(set);
    checked(nc_enddef(file_));
  }
  ~NetcdfWriter() override {
    if (open_) nc_abort(file_);
  }
  NetcdfWriter(NetcdfWriter const&) = delete;
  NetcdfWriter& operator=(NetcdfWriter const&) = delete;

  void put(std::size_t set, std::size_t first, std::size_t count, double const* numbers) override {
    Variable const& to = variables_[set];
    std::vector<std::size_t> start(to.extent.size(), 0), size = to.extent;
    if (!size.empty()) start[0] = first, size[0] = count;
    checked(nc_put_vara_double(to.group, to.id, start.data(), size.data(), numbers));
  }
  void close() override { open_ = false, checked(nc_close(file_)); }

 private:
  struct Variable {
    int group, id;
    std::vector<std::size_t> extent;
  };

  static void attach(int group, int variable, ArrayAttribute const& attribute) {
    std::string const& text = attribute.texts.front();
    checked(nc_put_att_text(group, variable, attribute.name.c_str(), text.size(), text.c_str()));
  }
  /// That of a name "GROUP/NAME", made where there is none.
  int group_of(std::string const& name) const {
    auto const slash = name.find('/');
    if (slash == std::string::npos) return file_;
    int group = 0;
    std::string const its = name.substr(0, slash);
    if (nc_inq_ncid(file_, its.c_str(), &group) != NC_NOERR) checked(nc_def_grp(file_, its.c_str(), &group));
    return group;
  }
  /// That of its group or of the file, made where there is none.
  static int dimension(int group, ArraySet::Axis const& axis) {
    int id = 0;
    if (nc_inq_dimid(group, axis.name.c_str(), &id) != NC_NOERR)
      checked(nc_def_dim(group, axis.name.c_str(), axis.length > 0 ? axis.length : NC_UNLIMITED, &id));
    return id;
  }
  void define(ArraySet const& set) {
    Variable variable{group_of(set.name), 0, {}};
    std::vector<int> dimensions;
    for (auto const& axis : set.axes)
      dimensions.push_back(dimension(variable.group, axis)), variable.extent.push_back(axis.length);
    std::string const name = set.name.substr(set.name.find('/') + 1);
    checked(nc_def_var(variable.group, name.c_str(), set.counts ? NC_INT : NC_DOUBLE,
                       static_cast<int>(dimensions.size()), dimensions.data(), &variable.id));
    if (!set.chunk.empty())
      checked(nc_def_var_chunking(variable.group, variable.id, NC_CHUNKED, set.chunk.data()));
    for (auto const& one : set.attributes) attach(variable.group, variable.id, one);
    variables_.push_back(std::move(variable));
  }

  int file_ = -1;
  bool open_ = false;
  std::vector<Variable> variables_;
};

}  // namespace
}  // namespace actio::scene

/// \copydoc actio::scene::MakeArrayWriter
extern "C" actio::scene::ArrayWriter* actio_array_writer(
    std::string const& path, std::vector<actio::scene::ArrayAttribute> const& attributes,
    std::vector<actio::scene::ArraySet> const& sets) {
  return new actio::scene::NetcdfWriter(path, attributes, sets);
}
