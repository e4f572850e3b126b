#include "scene/plans/proj_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace shatterpave::scene {

namespace {

[[noreturn]] void refuse_library() {
  const char* why = ::dlerror();
  throw std::runtime_error(fmt::format("cannot open PROJ, which knows reference systems: {}", why == nullptr ? "" : why));
}

template <typename Function>
void find(void* library, const char* name, Function& function) {
  void* const symbol = ::dlsym(library, name);
  if (symbol == nullptr) refuse_library();
  function = reinterpret_cast<Function>(symbol);
}

ProjLibrary opened_library() {
  void* const library = ::dlopen(SHATTERPAVE_PROJ_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) refuse_library();
  ProjLibrary proj;
  find(library, "proj_context_create", proj.context_create);
  find(library, "proj_context_destroy", proj.context_destroy);
  find(library, "proj_log_level", proj.log_level);
  find(library, "proj_context_set_search_paths", proj.context_set_search_paths);
  find(library, "proj_context_set_database_path", proj.context_set_database_path);
  find(library, "proj_context_set_enable_network", proj.context_set_enable_network);
  find(library, "proj_get_authorities_from_database", proj.get_authorities_from_database);
  find(library, "proj_string_list_destroy", proj.string_list_destroy);
  find(library, "proj_create", proj.create);
  find(library, "proj_create_from_database", proj.create_from_database);
  find(library, "proj_create_from_name", proj.create_from_name);
  find(library, "proj_list_get_count", proj.list_get_count);
  find(library, "proj_list_get", proj.list_get);
  find(library, "proj_list_destroy", proj.list_destroy);
  find(library, "proj_destroy", proj.destroy);
  find(library, "proj_get_type", proj.get_type);
  find(library, "proj_get_name", proj.get_name);
  find(library, "proj_get_source_crs", proj.get_source_crs);
  find(library, "proj_crs_get_sub_crs", proj.crs_get_sub_crs);
  find(library, "proj_crs_get_geodetic_crs", proj.crs_get_geodetic_crs);
  find(library, "proj_crs_get_coordinate_system", proj.crs_get_coordinate_system);
  find(library, "proj_cs_get_type", proj.cs_get_type);
  find(library, "proj_cs_get_axis_count", proj.cs_get_axis_count);
  find(library, "proj_cs_get_axis_info", proj.cs_get_axis_info);
  find(library, "proj_crs_get_coordoperation", proj.crs_get_coordoperation);
  find(library, "proj_coordoperation_get_method_info", proj.coordoperation_get_method_info);
  find(library, "proj_get_ellipsoid", proj.get_ellipsoid);
  find(library, "proj_ellipsoid_get_parameters", proj.ellipsoid_get_parameters);
  find(library, "proj_create_crs_to_crs_from_pj", proj.create_crs_to_crs_from_pj);
  find(library, "proj_normalize_for_visualization", proj.normalize_for_visualization);
  find(library, "proj_trans", proj.trans);
  return proj;
}

}  // namespace

const ProjLibrary& proj_library() {
  static const ProjLibrary library = opened_library();
  return library;
}

}  // namespace shatterpave::scene
