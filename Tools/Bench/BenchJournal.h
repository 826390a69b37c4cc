// The journal of a bench: a line of JSON for each thing as it is measured, so that a run that was
// cut off can go on.
#ifndef vtkshadows_BenchJournal_h
#define vtkshadows_BenchJournal_h

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace vtkshadows
{

class BenchJournal
{
public:
  using Json = nlohmann::ordered_json;

  // In the folder, which is there. `planKey`: what decides about the figures (PlanKey). Throws
  // Failure if there is a journal and it shall not go on, or it is of another plan, or it cannot be
  // read or written. A last line that was cut off is dropped.
  BenchJournal(const std::filesystem::path& folder, const std::string& planKey, bool resume);

  // Throws Failure unless the machine is the one that the journal was begun on.
  void SetMachine(const Json& machine);
  void AddScene(const Json& facts);
  void AddRow(const Json& row);
  // What each technique made of an extreme; see ExtremeFigures.h.
  void AddExtreme(const std::string& name, const Json& figures);
  bool HasExtreme(const std::string& name) const { return this->extremes.count(name) > 0; }
  // Of all, technique by technique, in this order of names.
  Json Extremes(const std::vector<std::string>& order) const;

  // That a run is being worked on. Where the journal ended twice in one, it is not tried again:
  // AddRow a failure in place of it.
  void Begin(const std::string& key);
  bool EndedTwiceIn(const std::string& key) const;

  // Rows in the order of these keys; those that have none of them behind.
  void SortRows(const std::vector<std::string>& order);

  bool HasRow(const std::string& key) const { return this->keys.count(key) > 0; }
  const Json& Machine() const { return this->machine; }
  const std::vector<Json>& Scenes() const { return this->scenes; }
  const std::vector<Json>& Rows() const { return this->rows; }

private:
  void Read(const std::string& planKey);
  void Keep(const Json& entry);
  void Append(const Json& entry);

  std::filesystem::path path;
  Json machine;
  std::vector<Json> scenes;
  std::vector<Json> rows;
  std::set<std::string> keys;
  std::map<std::string, Json> extremes;
  bool isResumed = false;          // and nothing begun since
  std::string begun;               // and no row of it since
  std::map<std::string, int> ends; // how often the journal ended in a run
};

}

#endif
