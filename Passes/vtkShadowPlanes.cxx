#include "vtkShadowPlanes.h"

#include "PlanarProjection.h"
#include "vtkShadowCasterMesh.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkProp3D.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>

namespace
{

// A piece with more triangles is not looked at. Of a polyhedron with few planes all faces receive
// but slivers; of what has more planes (a cone of facets, a furnished room) the large ones.
constexpr int MostTriangles = 4096;
constexpr std::size_t FewPlanes = 16, MostPlanes = 256;
constexpr double SmallestShare = 1.0 / 64.0, LargeShare = 1.0 / 8.0;

using vtkshadows::BoxCorners;

glm::dvec3 CentreOf(const BoxCorners& corners)
{
  return 0.5 * (corners[0] + corners[7]);
}

double SizeOf(const BoxCorners& corners)
{
  return std::max({ glm::length(corners[7] - corners[0]), glm::length(corners[6] - corners[1]),
    glm::length(corners[5] - corners[2]), glm::length(corners[3] - corners[4]) });
}

}

//------------------------------------------------------------------------------
std::vector<vtkShadowPlanes::FlatPart> vtkShadowPlanes::FindParts(
  const vtkShadowScene::Piece& piece)
{
  std::vector<FlatPart> flat;
  vtkDataObject* input = piece.Mapper->GetInputDataObject(0, 0);
  if (!input || input->GetNumberOfElements(vtkDataObject::CELL) > MostTriangles)
  {
    return flat;
  }

  const vtkShadowCasterMesh caster = vtkShadowCasterMesh::Build(piece);
  const vtkshadows::ShadowMesh<float>& mesh = caster.Mesh;
  if (mesh.NumberOfTriangles() > static_cast<std::size_t>(MostTriangles))
  {
    return flat;
  }
  // About its centre, where its coordinates are small.
  const glm::dvec3 centre(
    glm::inverse(piece.WorldFromModel) * glm::dvec4(CentreOf(piece.CornersWC), 1.0));
  std::vector<glm::dvec3> points;
  for (const glm::vec3& p : mesh.points)
  {
    points.push_back(glm::dvec3(caster.ModelFromCaster * glm::dvec4(glm::dvec3(p), 1.0)) - centre);
  }
  const bool isClosed = !mesh.pieces.empty() &&
    std::all_of(mesh.pieces.begin(), mesh.pieces.end(),
      [](const vtkshadows::MeshPiece& body) { return body.closed; });
  double size = 0.0, whole = 0.0;
  for (const glm::dvec3& p : points)
  {
    size = std::max(size, glm::length(p));
  }
  const double rounding = std::ldexp(size, -20);
  for (const vtkshadows::MeshPiece& body : mesh.pieces)
  {
    for (std::uint32_t i = body.first; i < body.last; ++i)
    {
      const glm::uvec3& t = mesh.triangles[i];
      const glm::dvec3 &a = points[t.x], &b = points[t.y], &c = points[t.z];
      const glm::dvec3 across = glm::cross(b - a, c - a) * (body.insideOut ? -1.0 : 1.0);
      const double area = glm::length(across);
      if (!(area > 0.0))
      {
        continue;
      }
      whole += area;
      FlatPart* found = nullptr;
      for (FlatPart& part : flat)
      {
        const glm::dvec3 normal(part.PlaneMC);
        const auto isOn = [&](const glm::dvec3& p)
        { return std::abs(glm::dot(normal, p) - part.PlaneMC.w) <= rounding; };
        const bool facesOut = !isClosed || glm::dot(normal, across) > 0.0;
        found = facesOut && isOn(a) && isOn(b) && isOn(c) ? &part : found;
      }
      if (!found)
      {
        const glm::dvec3 normal = across / area;
        flat.push_back({ glm::dvec4(normal, glm::dot(normal, a)), 0.0, isClosed });
        found = &flat.back();
      }
      found->Share += area;
      if (flat.size() > MostPlanes)
      {
        // A curved surface.
        return {};
      }
    }
  }
  for (FlatPart& part : flat)
  {
    part.Share /= whole;
    part.PlaneMC.w += glm::dot(glm::dvec3(part.PlaneMC), centre);
  }
  const double least = flat.size() <= FewPlanes ? SmallestShare : LargeShare;
  flat.erase(std::remove_if(flat.begin(), flat.end(),
               [least](const FlatPart& part) { return part.Share < least; }),
    flat.end());
  return flat;
}

//------------------------------------------------------------------------------
// Whether two planes are one, as far as what lies in `corners` tells.
bool vtkShadowPlanes::AreOne(
  const glm::dvec4& planeWC, const glm::dvec4& otherWC, const BoxCorners& corners) const
{
  const glm::dvec3 normal(planeWC), other(otherWC), centre = CentreOf(corners);
  const glm::dvec3 onPlane = centre - (glm::dot(normal, centre) - planeWC.w) * normal;
  return glm::length(glm::cross(other, normal)) * SizeOf(corners) <= this->Rounding &&
    std::abs(glm::dot(other, onPlane) - otherWC.w) <= this->Rounding;
}

// Two sides of one plane that closed bodies have there are different planes.
vtkShadowPlanes::Plane* vtkShadowPlanes::FindPlane(
  const glm::dvec4& planeWC, bool oneSided, const BoxCorners& corners)
{
  const auto found = std::find_if(this->Planes.begin(), this->Planes.end(),
    [&](const Plane& plane)
    {
      const bool areBothSides = oneSided && plane.OneSided &&
        glm::dot(glm::dvec3(planeWC), glm::dvec3(plane.PlaneWC)) < 0.0;
      return !areBothSides && this->AreOne(planeWC, plane.PlaneWC, corners);
    });
  return found == this->Planes.end() ? nullptr : &*found;
}

bool vtkShadowPlanes::LiesOn(const vtkShadowScene::Piece& piece, const glm::dvec4& planeWC) const
{
  return glm::dvec3(piece.PlaneWC) != glm::dvec3(0.0) &&
    this->AreOne(piece.PlaneWC, planeWC, piece.CornersWC);
}

//------------------------------------------------------------------------------
void vtkShadowPlanes::Add(
  Plane& plane, std::size_t prop, const vtkShadowScene::Piece& piece, double share)
{
  if (plane.Props.empty() || plane.Props.back() != prop)
  {
    plane.Props.push_back(prop);
  }
  const double size = SizeOf(piece.CornersWC);
  plane.Area += share * size * size;
  plane.Corners.push_back(piece.CornersWC);
  plane.Bounds.Add(piece.CornersWC);
}

//------------------------------------------------------------------------------
void vtkShadowPlanes::Find(const vtkShadowScene& scene, const std::vector<glm::dvec4>& named,
  bool automatic, const glm::dvec4& eyeWC)
{
  this->Planes.clear();
  const std::vector<vtkShadowScene::Prop>& props = scene.GetProps();
  this->Rounding = 0.0;
  for (const vtkShadowScene::Prop& prop : props)
  {
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      // Of what is drawn, and of planes in world coordinates, doubles.
      const double offset = glm::length(CentreOf(piece.CornersWC));
      this->Rounding =
        std::max({ this->Rounding, std::ldexp(piece.VertexReach, -20), std::ldexp(offset, -48) });
    }
  }
  for (const glm::dvec4& planeWC : named)
  {
    Plane plane;
    plane.PlaneWC = planeWC;
    this->Planes.push_back(plane);
  }

  this->Parts.BeginFrame(props);
  for (std::size_t i = 0; i < props.size(); ++i)
  {
    // Of translucent receivers a mask knows catchers alone.
    for (const vtkShadowScene::Piece& piece : props[i].Pieces)
    {
      if (!props[i].Receives || (props[i].Translucent && !props[i].Catches))
      {
        continue;
      }
      std::vector<FlatPart> flat; // in world coordinates
      if (props[i].Impostors)
      {
        continue; // they stand out of the plane of their points
      }
      vtkshadows::Box bounds;
      bounds.Add(piece.CornersWC);
      const bool isSeenFromWithin = eyeWC.w != 0.0 && bounds.Holds(glm::dvec3(eyeWC) / eyeWC.w);
      if (glm::dvec3(piece.PlaneWC) != glm::dvec3(0.0))
      {
        flat.push_back({ piece.PlaneWC, 1.0, false });
      }
      else
      {
        for (const FlatPart& part : this->Parts.Of(piece, [&piece]() { return FindParts(piece); }))
        {
          const glm::dvec4 row = glm::inverseTranspose(piece.WorldFromModel) *
            glm::dvec4(glm::dvec3(part.PlaneMC), -part.PlaneMC.w);
          const double length = glm::length(glm::dvec3(row));
          if (length > 0.0 && std::isfinite(length))
          {
            flat.push_back({ glm::dvec4(glm::dvec3(row), -row.w) / length, part.Share,
              part.Outward && !isSeenFromWithin });
          }
        }
      }
      for (const FlatPart& part : flat)
      {
        Plane* plane = this->FindPlane(part.PlaneMC, part.Outward, piece.CornersWC);
        if (!plane && automatic)
        {
          this->Planes.emplace_back();
          plane = &this->Planes.back();
          plane->PlaneWC = part.PlaneMC;
          plane->OneSided = part.Outward;
        }
        if (plane)
        {
          plane->OneSided = plane->OneSided && part.Outward;
          this->Add(*plane, i, piece, part.Share);
        }
      }
      for (std::size_t n = 0; n < named.size(); ++n)
      {
        // What reaches through a named plane may have a face on it, however small.
        double lowest = 0.0, highest = 0.0;
        vtkshadows::HeightsOver(this->Planes[n].PlaneWC, piece.CornersWC, lowest, highest);
        const bool isKnown = !this->Planes[n].Props.empty() && this->Planes[n].Props.back() == i;
        if (!isKnown && lowest <= this->Rounding && highest >= -this->Rounding)
        {
          this->Add(this->Planes[n], i, piece, 0.0);
        }
      }
    }
  }

  const auto ownBegin = this->Planes.begin() + static_cast<std::ptrdiff_t>(named.size());
  std::stable_sort(
    ownBegin, this->Planes.end(), [](const Plane& a, const Plane& b) { return a.Area > b.Area; });
  for (Plane& plane : this->Planes)
  {
    for (const std::size_t i : plane.Props)
    {
      plane.AllFlat = plane.AllFlat &&
        std::all_of(props[i].Pieces.begin(), props[i].Pieces.end(),
          [&](const vtkShadowScene::Piece& piece) { return this->LiesOn(piece, plane.PlaneWC); });
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowPlanes::SetShadowed(const vtkShadowScene& scene, const std::vector<bool>& planes)
{
  std::unordered_map<const void*, std::vector<std::size_t>> planesOf;
  this->Shadowed.clear();
  for (const vtkShadowScene::Prop& prop : scene.GetProps())
  {
    planesOf[prop.Source];
    for (const vtkShadowScene::Piece& piece : prop.Pieces)
    {
      planesOf[piece.Prop];
    }
  }
  for (std::size_t plane = 0; plane < this->Planes.size(); ++plane)
  {
    if (!planes[plane])
    {
      continue;
    }
    for (const std::size_t i : this->Planes[plane].Props)
    {
      const vtkShadowScene::Prop& prop = scene.GetProps()[i];
      this->Shadowed.push_back(i);
      // A copy that a mapper made of its actor for a block has the actor's keys.
      std::vector<const void*> names = { prop.Source, prop.Source->GetPropertyKeys() };
      for (const vtkShadowScene::Piece& piece : prop.Pieces)
      {
        names.push_back(piece.Prop);
      }
      std::sort(names.begin(), names.end());
      names.erase(std::unique(names.begin(), names.end()), names.end());
      for (const void* name : names)
      {
        planesOf[name].push_back(plane);
      }
    }
  }
  std::sort(this->Shadowed.begin(), this->Shadowed.end());
  this->Shadowed.erase(
    std::unique(this->Shadowed.begin(), this->Shadowed.end()), this->Shadowed.end());
  if (planesOf != this->PlanesOf)
  {
    this->PlanesOf.swap(planesOf);
    this->Stamp.Modified();
  }
}

//------------------------------------------------------------------------------
const std::vector<std::size_t>* vtkShadowPlanes::ShadowedPlanesOf(vtkProp* prop) const
{
  auto found = this->PlanesOf.find(prop);
  if (found == this->PlanesOf.end() && prop->GetPropertyKeys())
  {
    found = this->PlanesOf.find(prop->GetPropertyKeys());
  }
  return found == this->PlanesOf.end() || found->second.empty() ? nullptr : &found->second;
}
