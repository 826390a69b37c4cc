#include "BenchPage.h"

#ifdef VTKSHADOWS_HAS_CHARTS
#include "ChartLibrary.h"
#endif
#include "BenchPageScript.h"
#include "BenchPageText.h"

#include <fstream>
#include <map>
#include <sstream>
#include <utility>

namespace vtkshadows
{
namespace
{

using Json = BenchJournal::Json;

std::string ReadFile(const std::filesystem::path& path)
{
  std::stringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

// RFC 4648.
std::string Base64(const std::string& bytes)
{
  const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    unsigned int group = 0;
    for (std::size_t k = i; k < i + 3; ++k)
    {
      group = group << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u);
    }
    for (int k = 0; k < 4; ++k)
    {
      const bool isThere = i + k <= bytes.size();
      text += isThere ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

// What one setting got wrong with one light, to rank it by.
double Badness(const Json& row, const Json& error)
{
  return error.value(row["soft"] ? "mean_absolute_difference" : "mismatch_percent", 0.0);
}

// Each technique's worst error, hard and soft: row and error.
std::vector<std::pair<const Json*, const Json*>> WorstErrors(const Json& rows)
{
  std::map<std::pair<bool, std::string>, std::pair<const Json*, const Json*>> worst;
  for (const Json& row : rows)
  {
    if (row["technique"] == "none" || !row.contains("errors"))
    {
      continue;
    }
    for (const Json& error : row["errors"])
    {
      auto& so = worst[{ row["soft"], row["technique"] }];
      if (!so.first || Badness(row, error) > Badness(*so.first, *so.second))
      {
        so = { &row, &error };
      }
    }
  }
  std::vector<std::pair<const Json*, const Json*>> list;
  for (const auto& [key, found] : worst)
  {
    list.push_back(found);
  }
  return list;
}

void Replace(std::string& text, const std::string& what, const std::string& by)
{
  const std::size_t at = text.find(what);
  if (at != std::string::npos)
  {
    text.replace(at, what.size(), by);
  }
}

// For a script element, in which "</" would end it.
std::string InScript(std::string text)
{
  for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos; at += 3)
  {
    text.replace(at, 2, "<\\/");
  }
  return text;
}

}

bool CanMakePage()
{
#ifdef VTKSHADOWS_HAS_CHARTS
  return true;
#else
  return false;
#endif
}

std::string PageOf(const Json& report, const std::filesystem::path& pictures)
{
  Json data = report;
  Json images = Json::object();
  const auto add = [&images, &pictures](const std::string& name)
  {
    const std::string bytes = ReadFile(pictures / name);
    if (!bytes.empty())
    {
      images[name] = "data:image/png;base64," + Base64(bytes);
    }
  };
  for (const Json& scene : report["scenes"])
  {
    add("scene-" + scene["name"].get<std::string>() + ".png");
  }
  data["worst"] = Json::array();
  for (const auto& [row, error] : WorstErrors(report["rows"]))
  {
    const std::string picture = (*error)["picture"];
    add(picture);
    data["worst"].push_back({ { "scene", (*row)["scene"] }, { "setting", (*row)["setting"] },
      { "soft", (*row)["soft"] }, { "error", *error } });
  }
  data["pictures"] = images;

  std::string page = BenchPageText;
  std::string library;
#ifdef VTKSHADOWS_HAS_CHARTS
  library = ChartLibrary;
#endif
  // The data last: nothing is looked for in them.
  Replace(page, "@SCRIPT@", BenchPageScript);
  Replace(page, "@LIBRARY@", library);
  Replace(page, "@DATA@", InScript(data.dump(-1, ' ', false, Json::error_handler_t::replace)));
  return page;
}

}
