# What `cmake --install` puts where: headers, library, command, CMake package, pkg-config file.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/iecfront)

install(TARGETS iecfront EXPORT iecfrontTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${iecfront_SOURCE_DIR}/include/iecfront
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.hpp" PATTERN "*.def")

# ---- CMake package -------------------------------------------------------------------------------

install(EXPORT iecfrontTargets NAMESPACE iecfront:: DESTINATION ${package_dir})
configure_package_config_file(
    ${CMAKE_CURRENT_LIST_DIR}/iecfrontConfig.cmake.in
    ${CMAKE_CURRENT_BINARY_DIR}/iecfrontConfig.cmake
    INSTALL_DESTINATION ${package_dir}
    NO_SET_AND_CHECK_MACRO)
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(
    ${CMAKE_CURRENT_BINARY_DIR}/iecfrontConfigVersion.cmake
    VERSION ${iecfront_VERSION}
    COMPATIBILITY SameMinorVersion)
install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/iecfrontConfig.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/iecfrontConfigVersion.cmake
    DESTINATION ${package_dir})

# ---- pkg-config ----------------------------------------------------------------------------------

# The file finds its prefix by its own place, so that an installed tree can be moved. A directory
# that was given as an absolute path stays where it is.
set(pc_prefix ${CMAKE_INSTALL_PREFIX})
if(NOT IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
    file(RELATIVE_PATH up /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
    string(REGEX REPLACE "/$" "" up ${up})
    set(pc_prefix "\${pcfiledir}/${up}")
endif()
foreach(dir IN ITEMS LIBDIR INCLUDEDIR)
    set(pc_${dir} ${CMAKE_INSTALL_${dir}})
    if(NOT IS_ABSOLUTE ${pc_${dir}})
        set(pc_${dir} "\${prefix}/${pc_${dir}}")
    endif()
endforeach()
set(pc_definitions)
if(library_type STREQUAL "SHARED_LIBRARY")
    set(pc_definitions " -DIECFRONT_SHARED")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/iecfront.pc.in
    ${CMAKE_CURRENT_BINARY_DIR}/iecfront.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/iecfront.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# ---- the command ---------------------------------------------------------------------------------

if(TARGET iecfront_command)
    if(library_type STREQUAL "SHARED_LIBRARY" AND UNIX AND NOT IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
        # So that the installed command finds the library beside it, wherever both are moved to.
        file(RELATIVE_PATH to_library /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${CMAKE_INSTALL_LIBDIR})
        set(origin "$ORIGIN")
        if(APPLE)
            set(origin "@loader_path")
        endif()
        set_target_properties(iecfront_command PROPERTIES INSTALL_RPATH "${origin}/${to_library}")
    endif()
    install(TARGETS iecfront_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
