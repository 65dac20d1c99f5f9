#include "program/output/hdf5_attributes.hpp"

#include "program/output/hdf5_file.hpp"

namespace actio::scene::hdf5 {
namespace {

void attach_texts(Session const& h5, std::string const& path, hid_t object, char const* name,
                  std::vector<std::string> const& texts, bool list) {
  char const* const what = "cannot be written";
  Handle const type(h5->H5Tcopy(h5->H5T_C_S1_g_value), h5->H5Tclose);
  h5->H5Tset_size(type, H5T_VARIABLE);
  h5->H5Tset_cset(type, H5T_CSET_UTF8);
  hsize_t const size = texts.size();
  Handle const space(list ? h5->H5Screate_simple(1, &size, nullptr) : h5->H5Screate(H5S_SCALAR),
                     h5->H5Sclose);
  Handle const attribute(
      h5.checked(h5->H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), path, what),
      h5->H5Aclose);
  std::vector<char const*> pointers;
  for (auto const& text : texts) pointers.push_back(text.c_str());
  h5.checked(h5->H5Awrite(attribute, type, pointers.data()), path, what);
}

}  // namespace

Handle access_to_growing_file(Session const& h5) {
  Handle access(h5->H5Pcreate(h5->H5P_CLS_FILE_ACCESS_ID_g_value), h5->H5Pclose);
  h5->H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
  set_growing_file(h5, access);
  return access;
}

void attach(Session const& h5, std::string const& path, hid_t object, char const* name,
            std::string const& text) {
  if (!text.empty()) attach_texts(h5, path, object, name, {text}, false);
}
void attach(Session const& h5, std::string const& path, hid_t object, char const* name,
            std::vector<std::string> const& texts) {
  attach_texts(h5, path, object, name, texts, true);
}

}  // namespace actio::scene::hdf5
