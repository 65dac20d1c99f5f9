#include "hdf5_table.hpp"

#include <hdf5.h>

#include <algorithm>
#include <stdexcept>

namespace command {
namespace {

hid_t good(hid_t result, std::string const& what) {
  if (result < 0) throw std::runtime_error("HDF5: cannot read " + what);
  return result;
}

/// One text, or the texts of a list with commas between them.
herr_t read_attribute(hid_t object, char const* name, H5A_info_t const*, void* out) {
  hid_t const attribute = H5Aopen(object, name, H5P_DEFAULT), type = H5Aget_type(attribute),
              space = H5Aget_space(attribute);
  std::vector<char*> texts(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  bool const read = H5Tis_variable_str(type) > 0 && H5Tget_cset(type) == H5T_CSET_UTF8 &&
                    H5Aread(attribute, type, texts.data()) >= 0;
  std::string joined;
  if (read) {
    for (char const* text : texts) joined += (joined.empty() ? "" : ",") + std::string(text);
    H5Dvlen_reclaim(type, space, H5P_DEFAULT, texts.data());
    (*static_cast<std::map<std::string, std::string>*>(out))[name] = joined;
  }
  H5Sclose(space), H5Tclose(type), H5Aclose(attribute);
  return read ? 0 : -1;
}

std::map<std::string, std::string> attributes(hid_t object) {
  std::map<std::string, std::string> out;
  good(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, read_attribute, &out), "an attribute");
  return out;
}

struct DataSet {
  std::string name;
  std::vector<unsigned long long> extent;
  std::vector<double> numbers;
  std::map<std::string, std::string> attributes;
};

DataSet read_data_set(hid_t file, std::string const& name) {
  hid_t const set = good(H5Dopen2(file, name.c_str(), H5P_DEFAULT), name), space = H5Dget_space(set);
  DataSet out{name,
              std::vector<unsigned long long>(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space))),
              {},
              attributes(set)};
  std::vector<hsize_t> extent(out.extent.size());
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  out.extent.assign(extent.begin(), extent.end());
  out.numbers.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  good(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.numbers.data()),
       "the numbers of " + name);
  H5Sclose(space), H5Dclose(set);
  return out;
}

std::vector<std::string> names_in(hid_t file) {
  std::vector<std::string> out;
  auto const see = [](hid_t, char const* name, H5L_info_t const*, void* names) -> herr_t {
    return static_cast<std::vector<std::string>*>(names)->push_back(name), 0;
  };
  good(H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, nullptr, see, &out), "the names");
  return out;
}

/// A file that is closed with all that was opened in it, also where reading fails: the library would take
/// what is still open for the file as it is then.
struct OpenFile {
  hid_t id;
  explicit OpenFile(std::string const& path) {
    hid_t const access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
    id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
    H5Pclose(access);
    good(id, path);
  }
  ~OpenFile() { H5Fclose(id); }
};

}  // namespace

Hdf5Table read_hdf5(std::string const& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  Hdf5Table table;
  std::vector<DataSet> sets;
  {
    OpenFile const file(path);
    table.attributes[""] = attributes(file.id);
    for (auto const& name : names_in(file.id)) sets.push_back(read_data_set(file.id, name));
  }

  std::size_t const rows = sets.at(0).extent.at(0);
  for (auto const& set : sets) {
    if (set.extent[0] != rows) throw std::runtime_error("HDF5: " + set.name + " has another number of rows");
    table.extents[set.name] = set.extent, table.attributes[set.name] = set.attributes;
  }
  table.rows.resize(rows);
  for (auto const& set : sets) {
    std::size_t const width = set.extent[0] == 0 ? 0 : set.numbers.size() / set.extent[0];
    std::string const& columns = set.attributes.at("columns");
    for (std::size_t from = 0; from < columns.size();) {
      std::size_t const to = std::min(columns.find(',', from), columns.size());
      table.columns.push_back(columns.substr(from, to - from)), from = to + 1;
    }
    for (std::size_t i = 0; i < rows; ++i)
      table.rows[i].insert(table.rows[i].end(), set.numbers.begin() + static_cast<long>(i * width),
                           set.numbers.begin() + static_cast<long>((i + 1) * width));
  }
  return table;
}

std::vector<double> read_hdf5_numbers(std::string const& path, std::string const& name,
                                      std::vector<unsigned long long>* extent) {
  OpenFile const file(path);
  DataSet const set = read_data_set(file.id, name);
  if (extent) *extent = set.extent;
  return set.numbers;
}

}  // namespace command
