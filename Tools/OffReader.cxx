#include "OffReader.h"

#include "Failure.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

namespace vtkshadows
{
namespace
{

// How often progress is told, in lines.
constexpr long LinesPerProgress = 1 << 16;

constexpr const char* Blanks = " \t\r\f\v";

// The file's lines that say something, one at a time, and the numbers on them.
class OffLines
{
public:
  OffLines(const std::string& path, std::function<void(double)> progress);

  // To the next line that is not blank; false at the end of the file.
  bool Next();

  // The next word of this line, which is not yet taken; empty at the line's end.
  std::string PeekWord() const;
  void SkipWord();

  // The next number of this line; false if there is none.
  bool Number(double& number);
  bool Integer(long long& number);

  [[noreturn]] void Fail(const std::string& problem) const;

private:
  std::string path;
  std::string text;
  std::function<void(double)> progress;
  std::size_t lineStart = 0; // of the line after this one
  long lineNumber = 0;
  std::string line;
  const char* cursor = nullptr;
};

OffLines::OffLines(const std::string& filePath, std::function<void(double)> onProgress)
  : path(filePath)
  , progress(std::move(onProgress))
{
  std::ifstream file(filePath, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  this->text = content.str();
}

bool OffLines::Next()
{
  while (this->lineStart < this->text.size())
  {
    const std::size_t end = std::min(this->text.find('\n', this->lineStart), this->text.size());
    this->line.assign(this->text, this->lineStart, end - this->lineStart);
    this->line.erase(std::min(this->line.find('#'), this->line.size()));
    this->lineStart = end + 1;
    if (++this->lineNumber % LinesPerProgress == 0)
    {
      this->progress(static_cast<double>(end) / static_cast<double>(this->text.size()));
    }
    if (this->line.find_first_not_of(Blanks) != std::string::npos)
    {
      this->cursor = this->line.c_str();
      return true;
    }
  }
  return false;
}

std::string OffLines::PeekWord() const
{
  std::istringstream rest(this->cursor);
  std::string word;
  rest >> word;
  return word;
}

void OffLines::SkipWord()
{
  this->cursor += std::strspn(this->cursor, Blanks);
  this->cursor += std::strcspn(this->cursor, Blanks);
}

bool OffLines::Number(double& number)
{
  char* end = nullptr;
  number = std::strtod(this->cursor, &end);
  const bool found = end != this->cursor;
  this->cursor = end;
  return found;
}

bool OffLines::Integer(long long& number)
{
  char* end = nullptr;
  number = std::strtoll(this->cursor, &end, 10);
  const bool found = end != this->cursor;
  this->cursor = end;
  return found;
}

void OffLines::Fail(const std::string& problem) const
{
  throw Failure("input", this->path,
    "is not an OFF mesh: line " + std::to_string(this->lineNumber) + ": " + problem,
    "check that the file is whole, and that it is OFF");
}

struct OffCounts
{
  long long vertices = 0;
  long long faces = 0;
};

// The keyword, if there is one, and the counts behind or below it.
OffCounts ReadHeader(OffLines& lines)
{
  OffCounts counts;
  if (!lines.Next())
  {
    lines.Fail("the file is empty");
  }

  const std::string keyword = lines.PeekWord();
  const bool hasKeyword = keyword.size() >= 3 && keyword.compare(keyword.size() - 3, 3, "OFF") == 0;
  if (hasKeyword)
  {
    const std::string prefix = keyword.substr(0, keyword.size() - 3);
    if (prefix.find_first_not_of("STCN") != std::string::npos)
    {
      lines.Fail(keyword + " has not three coordinates a vertex");
    }
    lines.SkipWord();
    if (lines.PeekWord() == "BINARY")
    {
      lines.Fail("BINARY is not read, only text");
    }
    if (lines.PeekWord().empty() && !lines.Next())
    {
      lines.Fail("the counts of vertices and faces are missing");
    }
  }

  if (!lines.Integer(counts.vertices) || !lines.Integer(counts.faces) || counts.vertices < 0 ||
    counts.faces < 0)
  {
    lines.Fail(hasKeyword ? "the counts of vertices and faces are missing"
                          : "neither OFF nor counts of vertices and faces");
  }
  return counts;
}

vtkSmartPointer<vtkPoints> ReadVertices(OffLines& lines, const OffCounts& counts)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (long long i = 0; i < counts.vertices; ++i)
  {
    if (!lines.Next())
    {
      lines.Fail("the file ends after " + std::to_string(i) + " of " +
        std::to_string(counts.vertices) + " vertices");
    }
    double position[3];
    if (!lines.Number(position[0]) || !lines.Number(position[1]) || !lines.Number(position[2]))
    {
      lines.Fail("vertex " + std::to_string(i) + " has not three coordinates");
    }
    points->InsertNextPoint(position);
  }
  return points;
}

void ReadFace(OffLines& lines, long long face, const OffCounts& counts, std::vector<vtkIdType>& ids)
{
  long long size = 0;
  if (!lines.Integer(size) || size < 0)
  {
    lines.Fail("face " + std::to_string(face) + " has no count of vertices");
  }
  ids.clear();
  for (long long i = 0; i < size; ++i)
  {
    long long id = 0;
    if (!lines.Integer(id))
    {
      lines.Fail("face " + std::to_string(face) + " has " + std::to_string(i) + " of its " +
        std::to_string(size) + " vertices");
    }
    if (id < 0 || id >= counts.vertices)
    {
      lines.Fail("face " + std::to_string(face) + " names vertex " + std::to_string(id) + " of " +
        std::to_string(counts.vertices));
    }
    ids.push_back(static_cast<vtkIdType>(id));
  }
}

vtkSmartPointer<vtkCellArray> ReadFaces(OffLines& lines, const OffCounts& counts)
{
  auto faces = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> ids;
  for (long long i = 0; i < counts.faces; ++i)
  {
    if (!lines.Next())
    {
      lines.Fail("the file ends after " + std::to_string(i) + " of " +
        std::to_string(counts.faces) + " faces");
    }
    ReadFace(lines, i, counts, ids);
    if (ids.size() >= 3)
    {
      faces->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }
  return faces;
}

}

vtkSmartPointer<vtkPolyData> ReadOff(
  const std::string& path, const std::function<void(double)>& progress)
{
  OffLines lines(path, progress);
  const OffCounts counts = ReadHeader(lines);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(ReadVertices(lines, counts));
  mesh->SetPolys(ReadFaces(lines, counts));
  return mesh;
}

}
