# Every third party in one place. What Debian ships without a CMake target gets one here.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Threads REQUIRED)
find_package(GTest REQUIRED)
find_package(GDAL 3.6 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(Ceres REQUIRED)

find_library(GEOGRAPHICLIB_LIBRARY NAMES GeographicLib REQUIRED)
add_library(stemwise_geographiclib INTERFACE)
target_link_libraries(stemwise_geographiclib INTERFACE ${GEOGRAPHICLIB_LIBRARY})

pkg_check_modules(pangocairo REQUIRED IMPORTED_TARGET pangocairo cairo cairo-pdf cairo-svg)

# Not find_package(PCL): it brings VTK's and Qt's flags with it.
find_path(PCL_INCLUDE pcl/point_cloud.h PATH_SUFFIXES pcl-1.13 pcl-1.14 pcl-1.15 REQUIRED)
add_library(stemwise_pcl_io INTERFACE)
target_include_directories(stemwise_pcl_io SYSTEM INTERFACE ${PCL_INCLUDE})
foreach(library common io io_ply)
  find_library(PCL_${library}_LIBRARY pcl_${library} REQUIRED)
  target_link_libraries(stemwise_pcl_io INTERFACE ${PCL_${library}_LIBRARY})
endforeach()
target_link_libraries(stemwise_pcl_io INTERFACE Eigen3::Eigen)

if(STEMWISE_DESKTOP)
  find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel CommonTransforms FiltersCore FiltersGeneral FiltersSources
    IOImage ImagingCore InteractionStyle RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2)
  find_package(OpenGL REQUIRED COMPONENTS OpenGL EGL)
  find_package(GLEW REQUIRED)
  find_package(glfw3 REQUIRED)
  find_package(CLI11 REQUIRED)
  pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
endif()
