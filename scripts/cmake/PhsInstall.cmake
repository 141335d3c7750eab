# Install rules: the program, the plugin, the libraries without MuJoCo with their headers, the data,
# and a package for find_package(phs). tests/install installs and uses them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(phs_data_dir ${CMAKE_INSTALL_DATADIR}/phs)
set(phs_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/phs)
set(phs_include_dir ${CMAKE_INSTALL_INCLUDEDIR}/phs)

target_include_directories(phs_options INTERFACE $<INSTALL_INTERFACE:${phs_include_dir}>)
target_include_directories(phs_mujoco INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${phs_include_dir}>)
target_link_libraries(phs_mujoco INTERFACE phs_engine)

install(TARGETS phs RUNTIME)
foreach(library base hydraulics effects phs_model rigs rail mujoco)
  set_target_properties(phs_${library} PROPERTIES EXPORT_NAME ${library})
endforeach()
install(TARGETS phs_base phs_hydraulics phs_effects phs_phs_model phs_rigs phs_rail phs_mujoco phs_options phs_engine
                phs_libcsv phs_hdf5
        EXPORT phsTargets)
foreach(folder base hydraulics effects phs_model rigs rail)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/${folder} DESTINATION ${phs_include_dir}
          FILES_MATCHING PATTERN "*.h")
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/plugin/phs_mujoco.h DESTINATION ${phs_include_dir}/plugin)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/NOTICE
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models ${PROJECT_SOURCE_DIR}/bogie_xml
        DESTINATION ${phs_data_dir})

install(EXPORT phsTargets NAMESPACE phs:: DESTINATION ${phs_package_dir})
set(data_dir ${phs_data_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/phsConfig.cmake.in
  ${PROJECT_BINARY_DIR}/phsConfig.cmake INSTALL_DESTINATION ${phs_package_dir}
  PATH_VARS data_dir)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/phsConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/phsConfig.cmake ${PROJECT_BINARY_DIR}/phsConfigVersion.cmake
        DESTINATION ${phs_package_dir})
