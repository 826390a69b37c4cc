// How fast an error changes while the picture does, learned from measures in a row. Plain C++, no
// VTK, no OpenGL.
#ifndef vtkshadows_ErrorRate_h
#define vtkshadows_ErrorRate_h

namespace vtkshadows
{

// Of one setting for one light. An error e that was measured may have become e (1 + Get() drift)
// after a drift (radians, and shares of distances and sizes; vtkShadowMeasuredErrors). Nothing is
// known at first, and what is seen counts at once if it is faster, and by halves if it is slower.
class ErrorRate
{
public:
  static constexpr double Unknown = 2.0;
  static constexpr double Least = 0.25;
  static constexpr double Most = 4.0;
  // Drifts that tell nothing: noise counts more than they do, or it is another picture.
  static constexpr double SmallestDrift = 0.02;
  static constexpr double LargestDrift = 1.0;

  // `change`: by which share of the smaller of two errors they differ that were measured a drift
  // apart (ShareOfChange).
  void Learn(double change, double drift);
  double Get() const { return this->Rate; }

private:
  double Rate = Unknown;
};

// Of errors 0 or more in any unit: infinite from none to some.
double ShareOfChange(double before, double after);

}

#endif
