// Files that the command writes: checked before the work, written after it, all or none.
#ifndef vtkshadows_OutputFiles_h
#define vtkshadows_OutputFiles_h

#include <filesystem>
#include <string>
#include <vector>

namespace vtkshadows
{

class OutputFiles
{
public:
  // `inputs` are the files that no output may overwrite.
  explicit OutputFiles(std::vector<std::string> inputs);

  // Throw Failure, which names `option` and `path`, unless a file can be written there (one that
  // ends in `extension`, unless that is empty), or a folder be made or written into.
  void RequireFile(
    const std::string& option, const std::string& path, const std::string& extension) const;
  void RequireFolder(const std::string& option, const std::string& path) const;

  // Hold `bytes` for Commit. Of two for one path, the command was wrong: Failure.
  void Add(const std::filesystem::path& path, std::string bytes);

  // Write everything under temporary names, then rename; what cannot be written leaves nothing
  // behind. The last folder of each path is made if it is missing.
  void Commit();

private:
  struct File
  {
    std::filesystem::path path;
    std::filesystem::path temporary;
    std::string bytes;
  };

  std::vector<std::string> inputs;
  std::vector<File> files;
};

}

#endif
