# Wraps the modules of VtkShadowsModules.cmake into the Python package `vtkshadows`.
# The build tree is usable as it is: PYTHONPATH=build/lib/python3/dist-packages.

find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
execute_process(
  COMMAND "${Python3_EXECUTABLE}" -c "import numpy, vtkmodules.vtkRenderingCore"
  RESULT_VARIABLE import_failed OUTPUT_QUIET ERROR_QUIET)
if (import_failed)
  message(WARNING "${Python3_EXECUTABLE} cannot import numpy and vtkmodules, which the Python package "
    "vtkshadows needs. Install them, or name the Python that this VTK was built for: "
    "-DPython3_EXECUTABLE=/usr/bin/python3")
endif ()

vtk_module_wrap_python(
  MODULES ${vtkshadows_modules}
  PYTHON_PACKAGE vtkshadows
  MODULE_DESTINATION "${vtkshadows_python_dir}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION "${vtkshadows_cmake_dir}"
  INSTALL_EXPORT ${vtkshadows_export}
  INSTALL_HEADERS OFF
  BUILD_STATIC OFF
  # Also the name of a header in include/: not Python, which would hide Python.h.
  TARGET VtkShadows::PassesPython)

# The package's own files lie beside the wrapped modules, in the build tree as where it is installed.
set(package_outputs)
foreach (file IN ITEMS
    __init__.py
    _checks.py
    _errors.py
    _find.py
    _floors.py
    _images.py
    _settings.py
    py.typed)
  set(source "${CMAKE_CURRENT_SOURCE_DIR}/Python/vtkshadows/${file}")
  set(output "${VTKSHADOWS_PYTHONPATH}/vtkshadows/${file}")
  add_custom_command(
    OUTPUT "${output}"
    DEPENDS "${source}"
    COMMAND "${CMAKE_COMMAND}" -E copy "${source}" "${output}")
  list(APPEND package_outputs "${output}")
  install(FILES "${source}" DESTINATION "${vtkshadows_python_dir}/vtkshadows" COMPONENT python)
endforeach ()
add_custom_target(vtkshadows_python_package ALL DEPENDS ${package_outputs})
