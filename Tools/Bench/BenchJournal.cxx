#include "BenchJournal.h"

#include "Failure.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace vtkshadows
{

BenchJournal::BenchJournal(
  const std::filesystem::path& folder, const std::string& planKey, bool resume)
  : path(folder / "journal.jsonl")
{
  if (!std::filesystem::exists(this->path))
  {
    this->Append({ { "plan", planKey } });
    return;
  }
  if (!resume)
  {
    throw Failure("-o", folder.string(), "holds the journal of a bench",
      "add --resume to go on with it, or choose another folder");
  }
  this->Read(planKey);
  this->isResumed = true;
}

void BenchJournal::Read(const std::string& planKey)
{
  std::stringstream text;
  text << std::ifstream(this->path, std::ios::binary).rdbuf();
  std::string whole;
  std::size_t number = 0;
  bool cutOff = false;
  for (std::string line; std::getline(text, line);)
  {
    ++number;
    const bool ended = !text.eof();
    const Json entry = Json::parse(line, nullptr, false);
    if (!ended || entry.is_discarded())
    {
      if (ended)
      {
        throw Failure("journal", this->path.string(),
          "its line " + std::to_string(number) + " is no JSON", "choose another folder");
      }
      cutOff = true;
      break;
    }
    whole += line + "\n";
    this->Keep(entry);
    if (number == 1 && entry.value("plan", "") != planKey)
    {
      throw Failure("--resume", this->path.string(),
        "was measured otherwise (" + entry.value("plan", "no plan") + "; now " + planKey + ")",
        "give the same options, or choose another folder");
    }
  }
  if (cutOff)
  {
    std::ofstream(this->path, std::ios::binary) << whole;
  }
  if (whole.empty())
  {
    this->Append({ { "plan", planKey } });
  }
}

void BenchJournal::Keep(const Json& entry)
{
  if (entry.contains("machine"))
  {
    this->machine = entry["machine"];
  }
  if (entry.contains("scene"))
  {
    const Json& facts = entry["scene"];
    const auto same = [&facts](const Json& each) { return each["name"] == facts["name"]; };
    this->scenes.erase(
      std::remove_if(this->scenes.begin(), this->scenes.end(), same), this->scenes.end());
    this->scenes.push_back(facts);
  }
  if (entry.contains("extreme"))
  {
    this->extremes[entry["extreme"]] = entry["figures"];
  }
  if (entry.contains("begin"))
  {
    this->begun = entry["begin"];
  }
  if (entry.contains("resumed") && !this->begun.empty())
  {
    ++this->ends[this->begun];
    this->begun.clear();
  }
  if (entry.contains("row"))
  {
    const std::string key = entry["row"].value("key", "");
    this->begun = this->begun == key ? "" : this->begun;
    if (this->keys.insert(key).second)
    {
      this->rows.push_back(entry["row"]);
    }
  }
}

void BenchJournal::Append(const Json& entry)
{
  errno = 0;
  std::ofstream file(this->path, std::ios::binary | std::ios::app);
  file << entry.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
  file.close();
  if (!file)
  {
    throw Failure("output", this->path.string(),
      std::string("cannot be written (") + std::strerror(errno) + ")",
      "choose another place, or make room there");
  }
  this->Keep(entry);
}

void BenchJournal::AddExtreme(const std::string& name, const Json& figures)
{
  this->Append({ { "extreme", name }, { "figures", figures } });
}

BenchJournal::Json BenchJournal::Extremes(const std::vector<std::string>& order) const
{
  Json all = Json::array();
  for (const std::string& name : order)
  {
    const auto found = this->extremes.find(name);
    if (found != this->extremes.end())
    {
      all.insert(all.end(), found->second.begin(), found->second.end());
    }
  }
  return all;
}

void BenchJournal::Begin(const std::string& key)
{
  if (this->isResumed)
  {
    this->Append({ { "resumed", true } });
    this->isResumed = false;
  }
  if (this->begun != key)
  {
    this->Append({ { "begin", key } });
  }
}

bool BenchJournal::EndedTwiceIn(const std::string& key) const
{
  const auto found = this->ends.find(key);
  const int before = found == this->ends.end() ? 0 : found->second;
  return before + (this->isResumed && this->begun == key ? 1 : 0) >= 2;
}

void BenchJournal::SortRows(const std::vector<std::string>& order)
{
  std::map<std::string, std::size_t> places;
  for (const std::string& key : order)
  {
    places.emplace(key, places.size());
  }
  const auto place = [&places](const Json& row)
  {
    const auto found = places.find(row.value("key", ""));
    return found == places.end() ? places.size() : found->second;
  };
  std::stable_sort(this->rows.begin(), this->rows.end(),
    [&place](const Json& a, const Json& b) { return place(a) < place(b); });
}

void BenchJournal::SetMachine(const Json& newMachine)
{
  if (this->machine.is_null())
  {
    this->Append({ { "machine", newMachine } });
  }
  else if (this->machine != newMachine)
  {
    throw Failure("--resume", this->path.string(),
      "was measured on another machine (" + this->machine.dump() + ")", "choose another folder");
  }
}

void BenchJournal::AddScene(const Json& facts)
{
  for (const Json& known : this->scenes)
  {
    if (known == facts)
    {
      return;
    }
  }
  this->Append({ { "scene", facts } });
}

void BenchJournal::AddRow(const Json& row)
{
  this->Append({ { "row", row } });
}

}
