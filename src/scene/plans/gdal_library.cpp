#include "scene/plans/gdal_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace shatterpave::scene {

namespace {

[[noreturn]] void refuse_library() {
  const char* why = ::dlerror();
  throw std::runtime_error(fmt::format("cannot open GDAL, which reads DXF: {}", why == nullptr ? "" : why));
}

template <typename Function>
void find(void* library, const char* name, Function& function) {
  void* const symbol = ::dlsym(library, name);
  if (symbol == nullptr) refuse_library();
  function = reinterpret_cast<Function>(symbol);
}

GdalLibrary opened_library() {
  void* const library = ::dlopen(SHATTERPAVE_GDAL_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) refuse_library();
  GdalLibrary gdal;
  find(library, "CPLSetConfigOption", gdal.set_config_option);
  find(library, "CPLSetThreadLocalConfigOption", gdal.set_thread_option);
  find(library, "CPLPushErrorHandler", gdal.push_error_handler);
  find(library, "CPLQuietErrorHandler", gdal.quiet_error_handler);
  find(library, "CPLPopErrorHandler", gdal.pop_error_handler);
  find(library, "CPLErrorReset", gdal.error_reset);
  find(library, "CPLGetLastErrorMsg", gdal.last_error_message);
  find(library, "VSIFileFromMemBuffer", gdal.file_from_buffer);
  find(library, "VSIFCloseL", gdal.close_file);
  find(library, "VSIUnlink", gdal.unlink_file);
  find(library, "GDALOpenEx", gdal.open);
  find(library, "GDALClose", gdal.close);
  find(library, "GDALDatasetGetLayerByName", gdal.layer_by_name);
  find(library, "OGR_L_GetNextFeature", gdal.next_feature);
  find(library, "OGR_F_Destroy", gdal.destroy_feature);
  find(library, "OGR_F_GetFieldIndex", gdal.field_index);
  find(library, "OGR_F_GetFieldAsString", gdal.field_text);
  find(library, "OGR_F_GetFieldAsInteger", gdal.field_number);
  find(library, "OGR_F_GetStyleString", gdal.style_text);
  find(library, "OGR_F_GetGeometryRef", gdal.geometry);
  find(library, "OGR_G_GetGeometryType", gdal.geometry_type);
  find(library, "OGR_GT_Flatten", gdal.without_heights);
  find(library, "OGR_G_GetGeometryCount", gdal.geometry_count);
  find(library, "OGR_G_GetGeometryRef", gdal.part);
  find(library, "OGR_G_GetPointCount", gdal.point_count);
  find(library, "OGR_G_GetX", gdal.x);
  find(library, "OGR_G_GetY", gdal.y);
  // Blocks where they are inserted, arcs as sides of a quarter of a degree, and nothing of what the machine's own settings may
  // say: neither other drivers nor plugins.
  void (*register_dxf)() = nullptr;
  find(library, "RegisterOGRDXF", register_dxf);
  gdal.set_config_option("GDAL_DRIVER_PATH", "disable");
  gdal.set_config_option("DXF_INLINE_BLOCKS", "TRUE");
  gdal.set_config_option("DXF_MERGE_BLOCK_GEOMETRIES", "FALSE");
  gdal.set_config_option("DXF_CLOSED_LINE_AS_POLYGON", "FALSE");
  gdal.set_config_option("DXF_TRANSLATE_ESCAPE_SEQUENCES", "TRUE");
  gdal.set_config_option("OGR_ARC_STEPSIZE", "0.25");
  register_dxf();
  return gdal;
}

}  // namespace

const GdalLibrary& gdal_library() {
  static const GdalLibrary library = opened_library();
  return library;
}

}  // namespace shatterpave::scene
