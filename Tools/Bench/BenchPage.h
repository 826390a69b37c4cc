// The report of a bench as one page of HTML that needs nothing else.
#ifndef vtkshadows_BenchPage_h
#define vtkshadows_BenchPage_h

#include "BenchJournal.h"

#include <filesystem>
#include <string>

namespace vtkshadows
{

// Whether this build has the library that draws the plots (Chart.js).
bool CanMakePage();

// `report` as ReportOf has it; `pictures`: the folder with its pictures, of which those that the
// page shows are put into it: each scene, and each technique's worst error. What is missing there
// is left out.
std::string PageOf(const BenchJournal::Json& report, const std::filesystem::path& pictures);

}

#endif
