#include "ExtremeCaseList.h"
#include "ExtremeMeshes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <limits>

namespace vtkshadows
{
namespace
{

// The part's points through the inverse of a matrix that the actor is given: it looks the same.
void GiveMatrix(ExtremePart& part, const glm::dmat4& matrix)
{
  part.mesh = Moved(part.mesh, glm::inverse(matrix));
  part.sceneFromModel = matrix;
}

glm::dmat4 Sheared(double by)
{
  glm::dmat4 m(1.0);
  m[2][0] = by;
  m[1][0] = 0.5 * by;
  return m;
}

}

//------------------------------------------------------------------------------
void AddMatrices(ExtremeCaseList& cases)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const glm::dmat4 one(1.0);
  cases.Add("matrix", "mirrored", true,
    [=](ExtremeScene& scene)
    {
      for (std::size_t i = Ball; i <= Ring; ++i)
      {
        GiveMatrix(scene.parts[i], glm::scale(one, glm::dvec3(-1.0, 1.0, 1.0)));
      }
    });
  for (const double by : { 1.0, 1e3 })
  {
    cases.Add("matrix", "sheared by " + Text(by), true,
      [=](ExtremeScene& scene)
      {
        for (std::size_t i = Ball; i <= Ring; ++i)
        {
          GiveMatrix(scene.parts[i], Sheared(by));
        }
      });
  }
  cases.Add("matrix", "of unlike scales, 1e-6 and 1e6", true,
    [=](ExtremeScene& scene)
    {
      for (std::size_t i = Ball; i <= Ring; ++i)
      {
        GiveMatrix(scene.parts[i], glm::scale(one, glm::dvec3(1e-6, 1e6, 1.0)));
      }
    });
  cases.Add("matrix", "that turns a floor wider by 1e+06", true,
    [=](ExtremeScene& scene)
    {
      scene.parts[Floor].mesh = MakeFloor(2.5e6);
      GiveMatrix(scene.parts[Floor],
        glm::rotate(one, glm::radians(40.0), glm::normalize(glm::dvec3(0.5, 1.0, -0.3))));
    });
  const struct
  {
    const char* name;
    glm::dvec3 scale;
  } singular[] = { { "singular, to a plane", { 1.0, 1.0, 0.0 } },
    { "singular, to a line", { 0.0, 0.0, 1.0 } }, { "singular, to a point", { 0.0, 0.0, 0.0 } } };
  for (const auto& matrix : singular)
  {
    cases.Add("matrix", matrix.name, false,
      [=](ExtremeScene& scene)
      {
        // Of the ball, about its centre.
        scene.parts[Ball].sceneFromModel =
          glm::translate(glm::scale(glm::translate(one, BallCentre), matrix.scale), -BallCentre);
      });
  }
  for (const double rest : { 0.0, 1e-9 })
  {
    cases.Add("matrix", rest > 0.0 ? "to a leaning plane, all but 1e-9" : "to a leaning plane",
      false,
      [=](ExtremeScene& scene)
      {
        // p - (n.p) n, about the ball's centre.
        const glm::dvec3 n(0.36, -0.48, 0.8);
        const glm::dmat4 flattens(glm::dmat3(1.0) - (1.0 - rest) * glm::outerProduct(n, n));
        scene.parts[Ball].sceneFromModel =
          glm::translate(glm::translate(one, BallCentre) * flattens, -BallCentre);
      });
  }
  cases.Add("matrix", "with NaN", false,
    [=](ExtremeScene& scene) { scene.parts[Ball].sceneFromModel[0][0] = nan; });
}

}
