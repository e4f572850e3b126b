// GDAL's reader of DXF, opened when it is first needed: with the hundred libraries that GDAL needs itself it would take longer
// to load than a scene takes to check, and most plans are no DXF.
#pragma once

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_api.h>

namespace shatterpave::scene {

// The functions of GDAL that are used, with its own names.
struct GdalLibrary {
  decltype(&::CPLSetConfigOption) set_config_option = nullptr;
  decltype(&::CPLSetThreadLocalConfigOption) set_thread_option = nullptr;
  decltype(&::CPLPushErrorHandler) push_error_handler = nullptr;
  decltype(&::CPLQuietErrorHandler) quiet_error_handler = nullptr;
  decltype(&::CPLPopErrorHandler) pop_error_handler = nullptr;
  decltype(&::CPLErrorReset) error_reset = nullptr;
  decltype(&::CPLGetLastErrorMsg) last_error_message = nullptr;
  decltype(&::VSIFileFromMemBuffer) file_from_buffer = nullptr;
  decltype(&::VSIFCloseL) close_file = nullptr;
  decltype(&::VSIUnlink) unlink_file = nullptr;
  decltype(&::GDALOpenEx) open = nullptr;
  decltype(&::GDALClose) close = nullptr;
  decltype(&::GDALDatasetGetLayerByName) layer_by_name = nullptr;
  decltype(&::OGR_L_GetNextFeature) next_feature = nullptr;
  decltype(&::OGR_F_Destroy) destroy_feature = nullptr;
  decltype(&::OGR_F_GetFieldIndex) field_index = nullptr;
  decltype(&::OGR_F_GetFieldAsString) field_text = nullptr;
  decltype(&::OGR_F_GetFieldAsInteger) field_number = nullptr;
  decltype(&::OGR_F_GetStyleString) style_text = nullptr;
  decltype(&::OGR_F_GetGeometryRef) geometry = nullptr;
  decltype(&::OGR_G_GetGeometryType) geometry_type = nullptr;
  decltype(&::OGR_GT_Flatten) without_heights = nullptr;
  decltype(&::OGR_G_GetGeometryCount) geometry_count = nullptr;
  decltype(&::OGR_G_GetGeometryRef) part = nullptr;
  decltype(&::OGR_G_GetPointCount) point_count = nullptr;
  decltype(&::OGR_G_GetX) x = nullptr;
  decltype(&::OGR_G_GetY) y = nullptr;
};

// The library, which stays open, with its reader of DXF alone. Throws std::runtime_error where it is not there.
const GdalLibrary& gdal_library();

}  // namespace shatterpave::scene
