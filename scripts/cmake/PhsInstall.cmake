# Install rules: the program, the plugin, the libraries without MuJoCo with their headers, the data,
# manual pages and completion, and packages for find_package(phs) and pkg-config.
# Two components: `program` (what runs) and `development` (what others build with); the third,
# `python`, has its rules in python/CMakeLists.txt.
# tests/install installs and uses them; packaging/build_deb makes Debian packages of them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(phs_data_dir ${CMAKE_INSTALL_DATADIR}/phs)
set(phs_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/phs)
set(phs_include_dir ${CMAKE_INSTALL_INCLUDEDIR}/phs)
set(phs_pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
set(phs_packaging ${PROJECT_SOURCE_DIR}/packaging)

target_include_directories(phs_options INTERFACE $<INSTALL_INTERFACE:${phs_include_dir}>)
target_include_directories(phs_mujoco INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${phs_include_dir}>)
target_link_libraries(phs_mujoco INTERFACE phs_engine)

# What runs. The name without a number is for LD_PRELOAD.
install(TARGETS phs RUNTIME COMPONENT program)
if(TARGET phs-view)
  install(TARGETS phs-view RUNTIME COMPONENT program)
endif()
install(TARGETS phs_mujoco EXPORT phsTargets
        LIBRARY COMPONENT program NAMELINK_COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/NOTICE
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/models ${PROJECT_SOURCE_DIR}/bogie_xml
        DESTINATION ${phs_data_dir} COMPONENT program)
# Manual pages say what the program itself says (--help).
find_package(Python3 COMPONENTS Interpreter REQUIRED)
install(CODE "execute_process(
  COMMAND \"${Python3_EXECUTABLE}\" \"${phs_packaging}/write_manuals\" \"$<TARGET_FILE:phs>\"
          \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\"
  COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
install(FILES ${phs_packaging}/completion/phs.bash COMPONENT program RENAME phs
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${phs_packaging}/completion/_phs COMPONENT program
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${phs_packaging}/completion/phs.fish COMPONENT program
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# What others build with.
set(phs_archives base hydraulics effects phs_model rigs rail)
foreach(library ${phs_archives} mujoco)
  set_target_properties(phs_${library} PROPERTIES EXPORT_NAME ${library})
endforeach()
list(TRANSFORM phs_archives PREPEND phs_ OUTPUT_VARIABLE phs_archive_targets)
install(TARGETS ${phs_archive_targets} phs_options phs_engine phs_libcsv phs_hdf5
        EXPORT phsTargets ARCHIVE COMPONENT development)
foreach(folder ${phs_archives})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/${folder} DESTINATION ${phs_include_dir}
          COMPONENT development FILES_MATCHING PATTERN "*.h")
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/plugin/phs_mujoco.h DESTINATION ${phs_include_dir}/plugin
        COMPONENT development)

install(EXPORT phsTargets NAMESPACE phs:: DESTINATION ${phs_package_dir} COMPONENT development)
set(data_dir ${phs_data_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/phsConfig.cmake.in
  ${PROJECT_BINARY_DIR}/phsConfig.cmake INSTALL_DESTINATION ${phs_package_dir}
  PATH_VARS data_dir)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/phsConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/phsConfig.cmake ${PROJECT_BINARY_DIR}/phsConfigVersion.cmake
        DESTINATION ${phs_package_dir} COMPONENT development)

# pkg-config: the prefix is told from where the file stands, so the tree may be moved.
file(RELATIVE_PATH phs_to_prefix /${phs_pkgconfig_dir} /)
set(phs_static_libs "")
foreach(library rail rigs phs_model effects hydraulics base)  # users before what they use
  string(APPEND phs_static_libs " -lphs_${library}")
endforeach()
foreach(package phs phs-physics)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${package}.pc.in ${PROJECT_BINARY_DIR}/${package}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${package}.pc DESTINATION ${phs_pkgconfig_dir}
          COMPONENT development)
endforeach()
