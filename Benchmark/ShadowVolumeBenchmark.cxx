// Time and memory of shadow volumes in Core, by number of triangles:
//
//     build/bin/vtkshadows_volume_benchmark [LARGEST, in millions of triangles; default 20]
//
// - torus: closed, 1 piece, light outside: only what faces the light casts;
// - torus, all faces cast: as for a light within its bounds;
// - open torus: every third triangle left out, so that many edges are borders;
// - soup: single triangles, no two of which share an edge.
//
// build: welding, edges and pieces, once a shape. light: facing, silhouette and emission, once a
// light that moved. Medians; the exponent is that of the least-squares line in logarithms.
#include "ShadowVolume.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace
{

using namespace vtkshadows;
using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Soup
{
  std::vector<glm::vec3> points;
  std::vector<glm::uvec3> triangles;
};

// A bumpy torus of about `triangles` triangles.
Soup MakeTorus(std::size_t triangles)
{
  const auto sides = static_cast<std::uint32_t>(std::sqrt(triangles / 4.0));
  const std::uint32_t rings = 2 * sides;
  Soup soup;
  for (std::uint32_t i = 0; i < rings; ++i)
  {
    for (std::uint32_t j = 0; j < sides; ++j)
    {
      const double u = 2.0 * glm::pi<double>() * i / rings;
      const double v = 2.0 * glm::pi<double>() * j / sides;
      const double r = 0.4 + 0.02 * std::sin(11.0 * u) * std::sin(7.0 * v);
      const double across = 1.0 + r * std::cos(v);
      soup.points.emplace_back(across * std::cos(u), across * std::sin(u), r * std::sin(v));
      const std::uint32_t i1 = (i + 1) % rings, j1 = (j + 1) % sides;
      soup.triangles.emplace_back(i * sides + j, i1 * sides + j, i1 * sides + j1);
      soup.triangles.emplace_back(i * sides + j, i1 * sides + j1, i * sides + j1);
    }
  }
  return soup;
}

Soup MakeOpenTorus(std::size_t triangles)
{
  Soup soup = MakeTorus(triangles * 3 / 2);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
  {
    if (i % 3 != 0)
    {
      soup.triangles[kept++] = soup.triangles[i];
    }
  }
  soup.triangles.resize(kept);
  return soup;
}

Soup MakeSoup(std::size_t triangles)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-1.0f, 1.0f), side(-0.02f, 0.02f);
  Soup soup;
  for (std::size_t i = 0; i < triangles; ++i)
  {
    const glm::vec3 centre(place(random), place(random), place(random));
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (int corner = 0; corner < 3; ++corner)
    {
      soup.points.push_back(centre + glm::vec3(side(random), side(random), side(random)));
    }
    soup.triangles.emplace_back(first, first + 1, first + 2);
  }
  return soup;
}

struct Figures
{
  std::size_t triangles;
  double buildMs;
  double lightMs;
};

Figures Measure(const char* name, const Soup& soup, bool lightInside)
{
  const int rounds = soup.triangles.size() > 5000000 ? 3 : 9;
  std::vector<double> builds, lights;
  ShadowMesh<float> mesh;
  for (int round = 0; round < rounds; ++round)
  {
    auto points = soup.points;
    auto triangles = soup.triangles;
    const auto start = Clock::now();
    mesh = BuildShadowMesh(std::move(points), std::move(triangles));
    SetSoupApart(mesh, std::numeric_limits<std::uint32_t>::max());
    builds.push_back(MillisecondsSince(start));
  }
  std::vector<CastSign> signs;
  VolumeLists lists;
  std::vector<std::uint32_t> numbers; // stands for the driver's memory
  for (int round = 0; round < 2 * rounds; ++round)
  {
    const double turn = 0.3 + 0.01 * round;
    const glm::dvec4 light = lightInside
      ? glm::dvec4(0.1 * std::cos(turn), 0.1 * std::sin(turn), 0.1, 1.0)
      : glm::dvec4(5.0 * std::cos(turn), 5.0 * std::sin(turn), 7.0, 1.0);
    const auto start = Clock::now();
    FaceTriangles(mesh, light, CastingFaces::Closed, signs);
    const VolumeEmitter<float> emitter(mesh, signs, false);
    numbers.resize(std::max(numbers.size(), emitter.Lists().Count()));
    emitter.Write(numbers.data());
    lists = emitter.Lists();
    lights.push_back(MillisecondsSince(start));
  }
  const double triangles = static_cast<double>(mesh.NumberOfTriangles());
  // What the pass keeps of it: the mesh, and with the driver its points once more and the lists.
  const double bytes = static_cast<double>(
    mesh.MemoryInBytes() + mesh.points.size() * sizeof(glm::vec3) + lists.Count() * 4);
  const std::size_t sides = (lists.singles.count + 2 * lists.doubles.count) / 6 +
    3 * (lists.threeSided.count + lists.turnedThreeSided.count) +
    2 * (lists.twoSided.count + lists.turnedTwoSided.count);
  std::printf("| %s | %.2f | %.1f | %.1f | %.1f | %zu | %.0f + %.0f |\n", name, triangles / 1e6,
    Median(builds), Median(lights), 1e-3 * triangles / Median(lights), sides,
    mesh.MemoryInBytes() / triangles, (bytes - mesh.MemoryInBytes()) / triangles);
  std::fflush(stdout);
  return { mesh.NumberOfTriangles(), Median(builds), Median(lights) };
}

double Exponent(const std::vector<Figures>& all, double Figures::*time)
{
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (const Figures& f : all)
  {
    const double x = std::log(double(f.triangles)), y = std::log(f.*time);
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}

int main(int argc, char* argv[])
{
  const double largest = 1e6 * (argc > 1 ? std::atof(argv[1]) : 20.0);
  if (!(largest > 0.0))
  {
    std::fprintf(stderr, "LARGEST %s: give millions of triangles, above 0\n", argv[1]);
    return 1;
  }
  struct Case
  {
    const char* name;
    Soup (*make)(std::size_t);
    bool lightInside;
  };
  const Case cases[] = { { "torus", MakeTorus, false },
    { "torus, all faces cast", MakeTorus, true }, { "open torus", MakeOpenTorus, false },
    { "soup", MakeSoup, false } };
  std::printf("| mesh | million triangles | build ms | light ms | million triangles/s (light) "
              "| sides | bytes a triangle: mesh + drawing |\n|---|---|---|---|---|---|---|\n");
  for (const Case& c : cases)
  {
    std::vector<Figures> all;
    std::vector<double> sizes;
    for (double size = 1e6; size < 0.9 * largest; size *= 2.7)
    {
      sizes.push_back(size);
    }
    sizes.push_back(largest);
    for (const double size : sizes)
    {
      all.push_back(Measure(c.name, c.make(static_cast<std::size_t>(size)), c.lightInside));
    }
    if (all.size() > 1)
    {
      std::printf("| %s: exponent | | %.2f | %.2f | | | |\n", c.name,
        Exponent(all, &Figures::buildMs), Exponent(all, &Figures::lightMs));
    }
  }
  return 0;
}
