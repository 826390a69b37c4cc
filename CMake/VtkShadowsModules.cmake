# Scans, builds and wraps the VTK modules, and builds the ParaView plugin on top of them.
# One pair of libraries serves C++, Python and ParaView.

set(vtkshadows_export VtkShadowsCore)
set(vtkshadows_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/${vtkshadows_export}")
set(vtkshadows_python_dir "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages")
# For PYTHONPATH, while building and testing.
set(VTKSHADOWS_PYTHONPATH "${CMAKE_BINARY_DIR}/${vtkshadows_python_dir}")

# --- The modules -------------------------------------------------------------------------------
set(module_folders)
foreach (folder IN ITEMS Filters Passes)
  if (EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/vtk.module")
    list(APPEND module_folders "${CMAKE_CURRENT_SOURCE_DIR}/${folder}")
  endif ()
endforeach ()
vtk_module_find_modules(module_files ${module_folders})
vtk_module_scan(
  MODULE_FILES ${module_files}
  PROVIDES_MODULES vtkshadows_modules
  REQUIRES_MODULES vtkshadows_required_modules
  WANT_BY_DEFAULT ON
  HIDE_MODULES_FROM_CACHE ON)
vtk_module_build(
  MODULES ${vtkshadows_modules}
  PACKAGE ${vtkshadows_export}
  INSTALL_EXPORT ${vtkshadows_export}
  CMAKE_DESTINATION "${vtkshadows_cmake_dir}"
  ENABLE_WRAPPING ${VTKSHADOWS_WITH_PYTHON})

# find_package(VtkShadows) works from the build tree and from where it is installed.
set(config "${CMAKE_BINARY_DIR}/${vtkshadows_cmake_dir}/VtkShadowsConfig.cmake")
configure_file("${CMAKE_CURRENT_LIST_DIR}/VtkShadowsConfig.cmake.in" "${config}" @ONLY)
install(FILES "${config}" DESTINATION "${vtkshadows_cmake_dir}" COMPONENT development)

if (VTKSHADOWS_WITH_PYTHON)
  include(VtkShadowsPython)
endif ()

# --- The ParaView plugin -----------------------------------------------------------------------
if (VTKSHADOWS_WITH_PARAVIEW AND EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin")
  set(vtkshadows_plugin_subdir "paraview-plugins")
  paraview_plugin_scan(
    PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin"
    PROVIDES_PLUGINS vtkshadows_plugins
    REQUIRES_MODULES vtkshadows_plugin_modules
    ENABLE_BY_DEFAULT ON
    HIDE_PLUGINS_FROM_CACHE ON)
  paraview_plugin_build(
    PLUGINS ${vtkshadows_plugins}
    PLUGINS_FILE_NAME vtkshadows.xml
    AUTOLOAD ${vtkshadows_plugins}
    LIBRARY_SUBDIRECTORY ${vtkshadows_plugin_subdir})
  set(VTKSHADOWS_PLUGIN_XML
    "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${vtkshadows_plugin_subdir}/vtkshadows.xml")
endif ()
