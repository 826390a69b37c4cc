# vtkshadows_add_test(NAME <name> COMMAND <command>... [LABELS <label>...] [TIMEOUT <seconds>]
#                     [ENVIRONMENT <NAME=value>...] [NO_DISPLAY] [CLEAN])
#
# add_test, with a display of its own where this VTK cannot render without one. A test that opens no
# window says NO_DISPLAY. TIMEOUT is 300 seconds unless told otherwise. CLEAN: a warning or an error that
# VTK prints fails the test.
#
# Before 9.4, VTK on Linux chooses its window when it is compiled (GLX, in Debian). From 9.4 on it can
# draw by EGL without a display, and is told to, since it warns where it finds that out by itself.

find_program(VTKSHADOWS_XVFB_RUN xvfb-run
  DOC "Gives tests an X display of their own; needed by VTK before 9.4")
mark_as_advanced(VTKSHADOWS_XVFB_RUN)

set(VTKSHADOWS_TESTS_NEED_DISPLAY OFF)
if (UNIX AND NOT APPLE AND VTK_VERSION VERSION_LESS 9.4)
  if (VTKSHADOWS_XVFB_RUN)
    set(VTKSHADOWS_TESTS_NEED_DISPLAY ON)
  else ()
    message(WARNING "xvfb-run was not found: tests that open a window need an X display. "
      "Install xvfb and xauth.")
  endif ()
endif ()

# The command that gives test `name` a display.
function (vtkshadows_test_display name result)
  # A server starts its search for a free display at 99, and one that ends can take a newcomer's socket
  # with it: tests side by side start theirs far apart.
  string(MD5 hash "${CMAKE_BINARY_DIR} ${name}")
  string(SUBSTRING "${hash}" 0 6 hash)
  math(EXPR display "100 + 0x${hash} % 50000")
  # Without -noreset a window that opens while the server resets, after the last one closed, aborts.
  set(${result}
    "${VTKSHADOWS_XVFB_RUN}" -a -n ${display} -s "-screen 0 1280x1024x24 -nolisten tcp -noreset"
    PARENT_SCOPE)
endfunction ()

function (vtkshadows_add_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg
    "NO_DISPLAY;CLEAN" "NAME;TIMEOUT" "COMMAND;LABELS;ENVIRONMENT")
  if (NOT arg_NAME OR NOT arg_COMMAND OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "vtkshadows_add_test(${ARGV}): needs NAME and COMMAND; "
      "knows LABELS, TIMEOUT, ENVIRONMENT, NO_DISPLAY and CLEAN.")
  endif ()
  if (NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif ()

  if (UNIX AND NOT APPLE AND VTK_VERSION VERSION_GREATER_EQUAL 9.4 AND NOT arg_NO_DISPLAY)
    list(APPEND arg_ENVIRONMENT "VTK_DEFAULT_OPENGL_WINDOW=vtkEGLRenderWindow")
  endif ()

  # add_test finds the file of an executable target only where the target comes first.
  list(POP_FRONT arg_COMMAND program)
  if (TARGET "${program}")
    set(program "$<TARGET_FILE:${program}>")
  endif ()
  set(display)
  if (VTKSHADOWS_TESTS_NEED_DISPLAY AND NOT arg_NO_DISPLAY)
    vtkshadows_test_display("${arg_NAME}" display)
  endif ()

  add_test(NAME ${arg_NAME} COMMAND ${display} "${program}" ${arg_COMMAND})
  set_tests_properties(${arg_NAME} PROPERTIES
    LABELS "${arg_LABELS}"
    TIMEOUT ${arg_TIMEOUT}
    ENVIRONMENT "${arg_ENVIRONMENT}")
  if (arg_CLEAN)
    set_tests_properties(${arg_NAME} PROPERTIES
      FAIL_REGULAR_EXPRESSION "(WARN|ERR)[|];(Warning|ERROR): In ")
  endif ()
endfunction ()
