# What cmake --install puts where, in two parts: the programs, and core for other programs.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(resources ${PROJECT_SOURCE_DIR}/resources)

set(programs handmap-cli)
if(HANDMAP_GUI)
  list(APPEND programs handmap)
  set(metainfo org.handmap.Handmap.metainfo.xml)
  configure_file(${resources}/desktop/${metainfo}.in ${metainfo} @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${metainfo}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT program)
  install(FILES ${resources}/desktop/handmap.desktop
    DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT program)
  install(FILES ${resources}/desktop/handmap.xml
    DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT program)
  install(FILES ${resources}/desktop/handmap.svg
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT program)
endif()
install(TARGETS ${programs} COMPONENT program)
configure_file(${resources}/man/handmap-cli.1.in handmap-cli.1.page @ONLY)
configure_file(${resources}/man/handmap.1.in handmap.1 @ONLY)
# The options of each command stand in one place, the program.
install(CODE "execute_process(COMMAND ${resources}/man/options.sh \"$<TARGET_FILE:handmap-cli>\"
  INPUT_FILE ${PROJECT_BINARY_DIR}/handmap-cli.1.page OUTPUT_FILE ${PROJECT_BINARY_DIR}/handmap-cli.1
  COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
foreach(page ${programs})
  install(FILES ${PROJECT_BINARY_DIR}/${page}.1
    DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
endforeach()
install(FILES ${resources}/completions/handmap-cli.bash RENAME handmap-cli
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${resources}/completions/_handmap-cli
  DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT program)
install(FILES ${resources}/completions/handmap-cli.fish
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/handmap)
get_target_property(rooms handmap_core INTERFACE_LINK_LIBRARIES)
set_target_properties(handmap_core PROPERTIES EXPORT_NAME core)
install(TARGETS handmap_core handmap_options ${rooms} EXPORT handmap-targets
  ARCHIVE COMPONENT development)
install(EXPORT handmap-targets NAMESPACE handmap:: DESTINATION ${config_dir} COMPONENT development)
install(DIRECTORY core DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/handmap COMPONENT development
  FILES_MATCHING PATTERN *.h)
configure_package_config_file(resources/cmake/handmap-config.cmake.in handmap-config.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(handmap-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/handmap-config.cmake
  ${PROJECT_BINARY_DIR}/handmap-config-version.cmake
  DESTINATION ${config_dir} COMPONENT development)

# cpack: a .deb for each part.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME handmap)
set(CPACK_PACKAGE_VENDOR "The Handmap authors")
set(CPACK_PACKAGE_CONTACT "The Handmap authors <handmap@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "correct a map drawn from memory by what a robot sees")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME handmap)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fonts-dejavu-core, qt6-translations-l10n")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME handmap-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libeigen3-dev, libopencv-dev, libtbb-dev, libfmt-dev, nlohmann-json3-dev, libpolyclipping-dev, librandom123-dev, libyaml-cpp-dev, libpugixml-dev, zlib1g-dev")
include(CPack)
