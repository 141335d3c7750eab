# Everything comes from Debian 12's own packages (scripts/install_packages names them).

find_package(Eigen3 REQUIRED)
find_package(Boost REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(Threads REQUIRED)
find_package(urdfdom REQUIRED)
find_package(tinyxml2 QUIET)
find_package(PkgConfig REQUIRED)
pkg_check_modules(MATIO REQUIRED IMPORTED_TARGET matio)
pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)
pkg_check_modules(SQLITE REQUIRED IMPORTED_TARGET sqlite3)
pkg_check_modules(TINYXML2 REQUIRED IMPORTED_TARGET tinyxml2)

find_library(PHS_CSV_LIBRARY csv REQUIRED)
find_path(PHS_CSV_INCLUDE csv.h REQUIRED)
add_library(phs_libcsv INTERFACE)
target_include_directories(phs_libcsv SYSTEM INTERFACE ${PHS_CSV_INCLUDE})
target_link_libraries(phs_libcsv INTERFACE ${PHS_CSV_LIBRARY})

add_library(phs_hdf5 INTERFACE)
target_include_directories(phs_hdf5 SYSTEM INTERFACE ${HDF5_C_INCLUDE_DIRS})
target_link_libraries(phs_hdf5 INTERFACE ${HDF5_C_LIBRARIES})

# Debian's mujoco::mujoco asks for OpenGL and for /usr/include/libqhull_r/, which need not exist;
# the engine itself is one library and its headers.
find_library(PHS_MUJOCO_LIBRARY mujoco REQUIRED)
find_path(PHS_MUJOCO_INCLUDE mujoco/mujoco.h REQUIRED)
add_library(phs_engine INTERFACE)
target_include_directories(phs_engine SYSTEM INTERFACE ${PHS_MUJOCO_INCLUDE})
target_link_libraries(phs_engine INTERFACE ${PHS_MUJOCO_LIBRARY})

# Pictures alone need these: without them everything but phs-view is built.
find_package(PNG QUIET)
find_package(glfw3 QUIET)
find_library(PHS_OSMESA_LIBRARY OSMesa)
find_path(PHS_OSMESA_INCLUDE GL/osmesa.h)

if(PHS_TESTS)
  find_package(GTest REQUIRED)
  include(GoogleTest)
  find_path(PHS_RAPIDCHECK_INCLUDE rapidcheck.h REQUIRED)
  find_library(PHS_RAPIDCHECK_LIBRARY rapidcheck REQUIRED)
  add_library(rapidcheck::rapidcheck INTERFACE IMPORTED)
  target_include_directories(rapidcheck::rapidcheck SYSTEM INTERFACE ${PHS_RAPIDCHECK_INCLUDE})
  target_link_libraries(rapidcheck::rapidcheck INTERFACE ${PHS_RAPIDCHECK_LIBRARY})
endif()
if(PHS_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
