// What a bench found, for programs: CSV, JSON, and the exponents of its sweeps.
#ifndef vtkshadows_BenchReport_h
#define vtkshadows_BenchReport_h

#include "BenchJournal.h"

#include <string>
#include <vector>

namespace vtkshadows
{

// cost = factor * value^exponent, by least squares of the logarithms.
struct PowerLaw
{
  double exponent = 0.0;
  double exponentError = 0.0; // standard error; below 0: of two points, which have none
  double factor = 0.0;
  int points = 0;
};

// Values and costs above 0, as many of one as of the other; at least two different values, else
// points is 0.
PowerLaw FitPowerLaw(const std::vector<double>& values, const std::vector<double>& costs);

// {machine, plan, limits, scenes, rows, fits, extremes}. Limits are those of an error that passes
// for none (Core/TechniqueChoice.h). A fit is of one axis and setting, of the moving frame's cost;
// an extreme of a case and a technique.
BenchJournal::Json ReportOf(const BenchJournal& journal, const std::string& planKey);

// A line for each row and light, a head line first; what there is not is empty.
std::string CsvOf(const BenchJournal& journal);

}

#endif
