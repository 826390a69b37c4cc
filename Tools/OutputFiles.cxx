#include "OutputFiles.h"

#include "Failure.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#ifdef _WIN32
#include <process.h>
#define getpid _getpid
#else
#include <unistd.h>
#endif

namespace fs = std::filesystem;

namespace vtkshadows
{
namespace
{

// A name beside `path` that no other run uses.
fs::path TemporaryName(const fs::path& path)
{
  return path.parent_path() /
    (".vtkshadows-" + std::to_string(getpid()) + "-" + path.filename().string());
}

fs::path FolderOf(const fs::path& path)
{
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// Whether a file can be made in `folder`: tried, as permissions alone do not tell (read-only
// disks).
std::string WhyUnwritable(const fs::path& folder)
{
  const fs::path probe = TemporaryName(folder / "probe");
  errno = 0;
  const bool made = std::ofstream(probe).is_open();
  const int reason = errno;
  std::error_code ignored;
  fs::remove(probe, ignored);
  return made ? "" : std::strerror(reason);
}

void RequireWritableFolder(
  const std::string& option, const std::string& path, const fs::path& folder)
{
  const std::string reason = WhyUnwritable(folder);
  if (!reason.empty())
  {
    throw Failure(option, path,
      "cannot write in the folder " + folder.string() + " (" + reason + ")",
      "choose a folder that you may write in");
  }
}

// The folders that were made for the files; taken away again unless they are kept.
class MadeFolders
{
public:
  ~MadeFolders()
  {
    for (auto folder = this->made.rbegin(); folder != this->made.rend(); ++folder)
    {
      std::error_code ignored;
      fs::remove(*folder, ignored);
    }
  }
  void Make(const fs::path& folder)
  {
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error))
    {
      return;
    }
    this->Make(folder.parent_path());
    fs::create_directory(folder, error);
    if (error)
    {
      throw Failure("output", folder.string(), "cannot make the folder (" + error.message() + ")",
        "choose another place");
    }
    this->made.push_back(folder);
  }
  void Keep() { this->made.clear(); }

private:
  std::vector<fs::path> made;
};

}

OutputFiles::OutputFiles(std::vector<std::string> inputFiles)
  : inputs(std::move(inputFiles))
{
}

void OutputFiles::RequireFile(
  const std::string& option, const std::string& path, const std::string& extension) const
{
  std::error_code error;
  if (fs::is_directory(path, error))
  {
    throw Failure(option, path, "is a folder", "name a file in it, as picture" + extension);
  }
  if (!extension.empty() && fs::path(path).extension() != extension)
  {
    throw Failure(
      option, path, "is no " + extension + " file", "give it a name that ends in " + extension);
  }
  if (!fs::is_directory(FolderOf(path), error))
  {
    throw Failure(option, path, "its folder does not exist", "make the folder first");
  }
  if (fs::exists(path, error) && !fs::is_regular_file(path, error))
  {
    throw Failure(option, path, "is there and is no file", "choose another name");
  }
  for (const std::string& input : this->inputs)
  {
    if (fs::equivalent(input, path, error))
    {
      throw Failure(option, path, "is an input and would be overwritten", "choose another name");
    }
  }
  RequireWritableFolder(option, path, FolderOf(path));
}

void OutputFiles::RequireFolder(const std::string& option, const std::string& path) const
{
  std::error_code error;
  fs::path there = path;
  while (!there.empty() && !fs::exists(there, error))
  {
    there = there.parent_path();
  }
  if (there.empty())
  {
    there = ".";
  }
  if (!fs::is_directory(there, error))
  {
    throw Failure(option, path, there.string() + " is a file, not a folder", "name a folder");
  }
  RequireWritableFolder(option, path, there);
}

void OutputFiles::Add(const fs::path& path, std::string bytes)
{
  for (const File& file : this->files)
  {
    if (file.path.lexically_normal() == path.lexically_normal())
    {
      throw Failure(
        "output", path.string(), "two files would have this name", "rename one of them");
    }
  }
  // A link stays a link: the file that it names is replaced.
  std::error_code error;
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
  this->files.push_back({ target, TemporaryName(target), std::move(bytes) });
}

void OutputFiles::Commit()
{
  MadeFolders folders;
  const auto giveUp = [this](const File& file, const std::string& reason)
  {
    for (const File& each : this->files)
    {
      std::error_code ignored;
      fs::remove(each.temporary, ignored);
    }
    throw Failure("output", file.path.string(), "cannot be written (" + reason + ")",
      "choose another place, or make room there");
  };

  for (const File& file : this->files)
  {
    folders.Make(file.path.parent_path());
    errno = 0;
    std::ofstream stream(file.temporary, std::ios::binary);
    stream.write(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()));
    stream.close();
    if (!stream)
    {
      giveUp(file, std::strerror(errno));
    }
  }
  for (const File& file : this->files)
  {
    std::error_code error;
    fs::rename(file.temporary, file.path, error);
    if (error)
    {
      giveUp(file, error.message());
    }
  }
  folders.Keep();
  this->files.clear();
}

}
