# Included ahead of find_package(ParaView) and find_package(VTK), which look for Python themselves.
#
# VTK's Python modules work in no Python but the one that they were built for. Where the system's Python
# has them, as on Debian, it is that one, even if another comes first in PATH or a virtual environment
# is active. For another VTK say -DPython3_EXECUTABLE=...

set(system_python "/usr/bin/python3")
if (NOT DEFINED Python3_EXECUTABLE AND NOT DEFINED Python3_ROOT_DIR AND EXISTS "${system_python}")
  execute_process(
    COMMAND "${system_python}" -c "import vtkmodules.vtkCommonCore"
    RESULT_VARIABLE import_failed OUTPUT_QUIET ERROR_QUIET)
  if (NOT import_failed)
    set(Python3_EXECUTABLE "${system_python}")
  endif ()
endif ()
