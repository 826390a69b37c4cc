// The names that --technique and its kin, and --debug, take in this build.
#ifndef vtkshadows_Techniques_h
#define vtkshadows_Techniques_h

#include <string>
#include <vector>

namespace vtkshadows
{

// "none" included.
std::vector<std::string> TechniqueNames();

// For messages: "depth-map, stencil-volume, ray-cast, none".
std::string KnownTechniques();

// Throws Failure, naming `option`, unless there is a technique `name`.
void RequireTechnique(const std::string& option, const std::string& name);

// The same of the filters of a depth map, and of its formats, of which not every filter has all.
std::string KnownFilters();
void RequireFilter(const std::string& option, const std::string& name);
void RequireDepthBits(const std::string& option, int bits, const std::string& filter);

// The same of what object-ID maps tell apart, and of the depths beside the IDs.
std::string KnownObjectTypes();
void RequireObjectType(const std::string& option, const std::string& name);
void RequireObjectDepthBits(const std::string& option, int bits);

// The same of how translucent meshes cast.
std::string KnownTranslucentCasters();
void RequireTranslucentCasters(const std::string& option, const std::string& name);

// The same of the views that explain, and the techniques that a view explains.
std::string KnownDebugViews();
std::vector<std::string> TechniquesExplainedBy(const std::string& view);
void RequireDebugView(const std::string& option, const std::string& name);

}

#endif
