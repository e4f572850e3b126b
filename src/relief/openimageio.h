// OpenImageIO's headers, for this room's sources alone.
#pragma once

// They hold a copy of {fmt}. Here it has a name of its own: else an object that includes them would hold symbols of {fmt}
// itself, and programs that use no rasters would be linked with it, and so with OpenImageIO, for their sake.
#define FMT_BEGIN_NAMESPACE \
  namespace fmt {           \
  inline namespace of_openimageio {
#define FMT_END_NAMESPACE \
  }                       \
  }

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
