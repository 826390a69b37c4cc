// Xvfb is started directly rather than by running this command again under xvfb-run: meshes are
// loaded once, exit status and streams stay ours, and Xvfb itself finds a free display number.
#include "Display.h"

#include "Failure.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkVersionMacros.h>

#include <cstdlib>
#include <string>

#if defined(__unix__) && !defined(__APPLE__)
#include <csignal>
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace vtkshadows
{
namespace
{

constexpr int StartMilliseconds = 20000;

pid_t xvfbProcess = 0;

void StopXvfb()
{
  if (xvfbProcess > 0)
  {
    kill(xvfbProcess, SIGTERM);
    waitpid(xvfbProcess, nullptr, 0);
    xvfbProcess = 0;
  }
}

bool WindowNeedsDisplay()
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  return false;
#else
  vtkNew<vtkRenderWindow> window;
  return std::string(window->GetClassName()) == "vtkXOpenGLRenderWindow";
#endif
}

// Whether DISPLAY names a server that answers: VTK aborts at one that does not. libX11 comes with
// VTK, so it is asked without linking to it. The connection stays open: a server whose last client
// goes starts anew, and would then drop the connection that VTK makes next.
bool DisplayAnswers()
{
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    return false;
  }
  const auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(RTLD_DEFAULT, "XOpenDisplay"));
  return !open || open(name) != nullptr;
}

// What the child process becomes. It writes its display number into `answer` once it is ready.
[[noreturn]] void BecomeXvfb(int answer)
{
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  const std::string descriptor = std::to_string(answer);
  execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1280x1024x24",
    "-nolisten", "tcp", "-noreset", static_cast<char*>(nullptr));
  _exit(127);
}

// The display number, one line; empty if none came in time.
std::string ReadDisplayNumber(int answer)
{
  std::string number;
  pollfd waiting{ answer, POLLIN, 0 };
  char c = '\0';
  while (poll(&waiting, 1, StartMilliseconds) > 0 && read(answer, &c, 1) == 1)
  {
    if (c == '\n')
    {
      return number;
    }
    number += c;
  }
  return {};
}

}

bool ProvideDisplay()
{
  if (!WindowNeedsDisplay() || DisplayAnswers())
  {
    return false;
  }

  int answer[2];
  if (pipe(answer) != 0)
  {
    throw Failure("display", "", "no pipe can be made", "close other programs");
  }
  xvfbProcess = fork();
  if (xvfbProcess == 0)
  {
    close(answer[0]);
    BecomeXvfb(answer[1]);
  }
  close(answer[1]);
  std::atexit(StopXvfb);
  const std::string number = ReadDisplayNumber(answer[0]);
  close(answer[0]);
  if (number.empty())
  {
    const char* name = std::getenv("DISPLAY");
    throw Failure("display", name && *name ? name : "(none)",
      "this VTK renders only on an X display, and Xvfb could not be started",
      "install it (Debian: apt install xvfb), or set DISPLAY to a display that answers");
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);
  return true;
}

}

#else

namespace vtkshadows
{

bool ProvideDisplay()
{
  return false;
}

}

#endif
