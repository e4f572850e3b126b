// PROJ, opened when it is first needed: with the 40 libraries that it needs itself it would take longer to load than a scene
// takes to check, and most scenes name no reference system.
#pragma once

#include <proj.h>

namespace shatterpave::scene {

// The functions of PROJ that are used, with its own names.
struct ProjLibrary {
  decltype(&::proj_context_create) context_create = nullptr;
  decltype(&::proj_context_destroy) context_destroy = nullptr;
  decltype(&::proj_log_level) log_level = nullptr;
  decltype(&::proj_context_set_search_paths) context_set_search_paths = nullptr;
  decltype(&::proj_context_set_database_path) context_set_database_path = nullptr;
  decltype(&::proj_context_set_enable_network) context_set_enable_network = nullptr;
  decltype(&::proj_get_authorities_from_database) get_authorities_from_database = nullptr;
  decltype(&::proj_string_list_destroy) string_list_destroy = nullptr;
  decltype(&::proj_create) create = nullptr;
  decltype(&::proj_create_from_database) create_from_database = nullptr;
  decltype(&::proj_create_from_name) create_from_name = nullptr;
  decltype(&::proj_list_get_count) list_get_count = nullptr;
  decltype(&::proj_list_get) list_get = nullptr;
  decltype(&::proj_list_destroy) list_destroy = nullptr;
  decltype(&::proj_destroy) destroy = nullptr;
  decltype(&::proj_get_type) get_type = nullptr;
  decltype(&::proj_get_name) get_name = nullptr;
  decltype(&::proj_get_source_crs) get_source_crs = nullptr;
  decltype(&::proj_crs_get_sub_crs) crs_get_sub_crs = nullptr;
  decltype(&::proj_crs_get_geodetic_crs) crs_get_geodetic_crs = nullptr;
  decltype(&::proj_crs_get_coordinate_system) crs_get_coordinate_system = nullptr;
  decltype(&::proj_cs_get_type) cs_get_type = nullptr;
  decltype(&::proj_cs_get_axis_count) cs_get_axis_count = nullptr;
  decltype(&::proj_cs_get_axis_info) cs_get_axis_info = nullptr;
  decltype(&::proj_crs_get_coordoperation) crs_get_coordoperation = nullptr;
  decltype(&::proj_coordoperation_get_method_info) coordoperation_get_method_info = nullptr;
  decltype(&::proj_get_ellipsoid) get_ellipsoid = nullptr;
  decltype(&::proj_ellipsoid_get_parameters) ellipsoid_get_parameters = nullptr;
  decltype(&::proj_create_crs_to_crs_from_pj) create_crs_to_crs_from_pj = nullptr;
  decltype(&::proj_normalize_for_visualization) normalize_for_visualization = nullptr;
  decltype(&::proj_trans) trans = nullptr;
};

// The library, which stays open. Throws std::runtime_error where it is not there.
const ProjLibrary& proj_library();

}  // namespace shatterpave::scene
