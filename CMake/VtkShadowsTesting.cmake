# vtkshadows_add_test(NAME <name> COMMAND <command>... [LABELS <label>...] [TIMEOUT <seconds>]
#                     [ENVIRONMENT <NAME=value>...] [NO_DISPLAY])
#
# add_test, with a display of its own where this VTK cannot render without one. A test that opens no
# window says NO_DISPLAY. TIMEOUT is 300 seconds unless told otherwise.
#
# Before 9.4, VTK on Linux chooses its window when it is compiled (GLX, in Debian); from 9.4 on it falls
# back to EGL or OSMesa when there is no X display.

find_program(VTKSHADOWS_XVFB_RUN xvfb-run
  DOC "Gives tests an X display of their own; needed by VTK before 9.4")
mark_as_advanced(VTKSHADOWS_XVFB_RUN)

set(VTKSHADOWS_TEST_DISPLAY)
if (UNIX AND NOT APPLE AND VTK_VERSION VERSION_LESS 9.4)
  if (VTKSHADOWS_XVFB_RUN)
    set(VTKSHADOWS_TEST_DISPLAY "${VTKSHADOWS_XVFB_RUN}" -a -s "-screen 0 1280x1024x24 -nolisten tcp")
  else ()
    message(WARNING "xvfb-run was not found: tests that open a window need an X display. "
      "Install xvfb and xauth.")
  endif ()
endif ()

function (vtkshadows_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg
    "NO_DISPLAY" "NAME;TIMEOUT" "COMMAND;LABELS;ENVIRONMENT")
  if (NOT arg_NAME OR NOT arg_COMMAND OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "vtkshadows_add_test(${ARGV}): needs NAME and COMMAND; "
      "knows LABELS, TIMEOUT, ENVIRONMENT and NO_DISPLAY.")
  endif ()
  if (NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif ()

  # add_test finds the file of an executable target only where the target comes first.
  list(POP_FRONT arg_COMMAND program)
  if (TARGET "${program}")
    set(program "$<TARGET_FILE:${program}>")
  endif ()
  set(display)
  if (NOT arg_NO_DISPLAY)
    set(display ${VTKSHADOWS_TEST_DISPLAY})
  endif ()

  add_test(NAME ${arg_NAME} COMMAND ${display} "${program}" ${arg_COMMAND})
  set_tests_properties(${arg_NAME} PROPERTIES
    LABELS "${arg_LABELS}"
    TIMEOUT ${arg_TIMEOUT}
    ENVIRONMENT "${arg_ENVIRONMENT}")
endfunction ()
