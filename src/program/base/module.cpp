#include "program/base/module.hpp"

#include <dlfcn.h>

#include <string>

#include "program/base/error.hpp"

namespace actio::scene {

void* function_of_module(char const* module, char const* name) {
  // It is looked for where the program was linked to look for its libraries.
  void* const opened = ::dlopen((std::string("lib") + module + ".so").c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const at = opened ? ::dlsym(opened, name) : nullptr;
  if (at) return at;
  char const* const why = ::dlerror();
  throw FileError(std::string(module) + " cannot be loaded: " + (why ? why : "it has no such function"));
}

}  // namespace actio::scene
