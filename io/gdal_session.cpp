#include "io/gdal_session.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>

namespace stemwise {
namespace {

constexpr GIntBig most_cached_bytes = 256 << 20;  // of pixels; GDAL would take a twentieth of the machine's memory

void CPL_STDCALL gather(CPLErr level, CPLErrorNum, const char* text) {
  if (level < CE_Failure) return;  // GDAL's warnings are about formats, not about the person's data
  if (auto* messages = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData())) messages->add(text);
}

}  // namespace

void register_gdal() {
  static std::once_flag once;
  std::call_once(once, [] {
    GDALAllRegister();
    GDALSetCacheMax64(most_cached_bytes);
  });
}

GdalMessages::GdalMessages() {
  register_gdal();
  CPLPushErrorHandlerEx(gather, this);
}

GdalMessages::~GdalMessages() { CPLPopErrorHandler(); }

GdalOption::GdalOption(std::string key, const std::string& value) : key_(std::move(key)) {
  CPLSetThreadLocalConfigOption(key_.c_str(), value.c_str());
}

GdalOption::~GdalOption() { CPLSetThreadLocalConfigOption(key_.c_str(), nullptr); }

}  // namespace stemwise
