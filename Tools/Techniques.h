// The names that --technique and its kin take in this build.
#ifndef vtkshadows_Techniques_h
#define vtkshadows_Techniques_h

#include <string>
#include <vector>

namespace vtkshadows
{

// "none" included.
std::vector<std::string> TechniqueNames();

// For messages: "depth-map, ray-cast, none".
std::string KnownTechniques();

// Throws Failure, naming `option`, unless there is a technique `name`.
void RequireTechnique(const std::string& option, const std::string& name);

}

#endif
