// Says on stderr what takes long: on a terminal one line that is overwritten, elsewhere a line now
// and then, and nothing at all for what is quick.
#ifndef vtkshadows_Progress_h
#define vtkshadows_Progress_h

#include <chrono>
#include <string>

namespace vtkshadows
{

class Progress
{
public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // A step begins, and the one before it is over.
  void Begin(const std::string& step);

  // How far the step is, 0 to 1.
  void Update(double fraction);

  // The last step is over; a terminal's line is blank again.
  void End();

  // A line that stays, on stderr: something the user did not ask for but should know.
  void Note(const std::string& text);

private:
  using Clock = std::chrono::steady_clock;

  void Show(const std::string& text);

  bool quiet;
  bool terminal;
  std::string step;
  Clock::time_point lastShown;
};

}

#endif
