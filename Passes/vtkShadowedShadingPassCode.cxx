// The shader text of vtkShadowedShadingPass.
#include "vtkShadowedShadingPass.h"

#include "vtkShadowCatcherFS.h"
#include "vtkShadowDitherFS.h"
#include "vtkShadowLightFalloffs.h"
#include "vtkShadowReceiverBufferFS.h"
#include "vtkShadowTechniquePass.h"
#include "vtkShadowWideFloors.h"
#include "vtkShadowedShadingPassFS.h"
#include "vtkShadowedShadingPassUniforms.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace
{

// Places in the fragment shader that this pass marks before VTK fills its own tags, and fills
// after.
const char* const DeclarationMark = "//SHADOW::Dec\n";
const char* const LightMark = "//SHADOW::Light\n";
const char* const CatcherMark = "//SHADOW::Catcher\n";
const char* const OutputMark = "//SHADOW::Output\n";
const char* const VertexDeclarationMark = "//SHADOW::VertexDec\n";
const char* const VertexMark = "//SHADOW::Vertex\n";

bool Mark(std::string& source, const char* mark, const std::string& tag)
{
  return vtkShaderProgram::Substitute(source, tag, mark + tag, false);
}

std::string ColorUniform(std::size_t light)
{
  return "lightColor" + std::to_string(light);
}

std::string Visibility(std::size_t light)
{
  return "shadowVisibility" + std::to_string(light);
}

std::string PositionVarying(std::size_t light)
{
  return "shadowPosition" + std::to_string(light);
}

// Light spaces that go through the rasteriser; the others are transformed to in the fragment
// shader. Every OpenGL takes 15 vectors, of which VTK needs some.
constexpr std::size_t MostVaryings = 8;

// Where a fragment's position and plane come from.
enum class Surface
{
  Vertices, // its mesh: the rasteriser carries positions, and screen derivatives give the plane
  Fragment, // its mesh, but a geometry shader lies between
  Impostor  // the fragment shader, which also knows the normal
};

Surface SurfaceOf(const std::string& vertexShader, const std::string& geometryShader,
  const std::string& fragmentShader)
{
  const std::string position = "vec4 vertexVC = vertexVCVSOutput;";
  const std::size_t declared = fragmentShader.find(position);
  const bool moves = fragmentShader.find("vertexVC.xyz =") != std::string::npos ||
    (declared != std::string::npos &&
      fragmentShader.find(" vertexVC =", declared + position.size()) != std::string::npos);
  if (moves && fragmentShader.find("vec3 normalVCVSOutput =") != std::string::npos)
  {
    return Surface::Impostor;
  }
  const bool isPlain = !moves && geometryShader.empty() && declared != std::string::npos &&
    vertexShader.find("vertexVCVSOutput =") != std::string::npos &&
    vertexShader.find(VertexMark) != std::string::npos;
  return isPlain ? Surface::Vertices : Surface::Fragment;
}

bool Declares(const std::string& source, const std::string& uniform)
{
  return source.find("uniform vec3 " + uniform + ";") != std::string::npos;
}

// A depth is held against where a surface is: in a picture VTK sets polygons off from coincident
// lines, and draws those with visible edges larger by half an edge. Receivers cover what they cover
// there.
void PlaceSurface(std::string& geometryShader, std::string& fragmentShader, bool casts)
{
  vtkShaderProgram::Substitute(fragmentShader, "+ cFactor*cscale + 1.0*cOffset", "+ 0.0");
  if (!casts)
  {
    return;
  }
  vtkShaderProgram::Substitute(
    geometryShader, "gl_Position.xy = gl_Position.xy + offsets[i]*gl_Position.w;", "");
  for (const std::string n : { "0", "1", "2" })
  {
    vtkShaderProgram::Substitute(
      fragmentShader, "if (edist[" + n + "] < -0.5 && edgeEqn[" + n + "].z > 0.0) discard;", "");
  }
}

// Ahead of main, in any shader.
void DeclareAhead(std::string& source, const std::string& code)
{
  const std::size_t main = source.rfind("void main");
  if (main != std::string::npos)
  {
    source.insert(main, code);
  }
}

// The end of main in a shader of the user's own, which has no tag there.
void AppendToMain(std::string& source, const std::string& code)
{
  const std::size_t end = source.rfind('}');
  if (end != std::string::npos)
  {
    source.insert(end, code);
  }
}

// Returns what the fragment shader declares.
std::string Place(std::string& vertexShader, const vtkShadowVertexCode& code)
{
  DeclareAhead(vertexShader, code.VertexDeclarations);
  AppendToMain(vertexShader, code.VertexStatements);
  return code.FragmentDeclarations;
}

}

//------------------------------------------------------------------------------
// Whether the shader of a mapper needs code for a light: it draws all props that share it by one.
bool vtkShadowedShadingPass::Tells(
  std::size_t light, vtkAbstractMapper* mapper, vtkProp* prop) const
{
  const vtkShadowTechniquePass* technique = this->Plan[light].Technique;
  if (!technique)
  {
    return false;
  }
  const auto users = this->Users.equal_range(mapper);
  return technique->HasVisibilityOf(prop) ||
    std::any_of(users.first, users.second,
      [technique](const auto& user) { return technique->HasVisibilityOf(user.second); });
}

//------------------------------------------------------------------------------
std::string vtkShadowedShadingPass::Declarations() const
{
  if (this->CurrentStage == POSITIONS)
  {
    return vtkShadowReceiverBufferFS;
  }
  std::ostringstream code;
  for (vtkShadowTechniquePass* technique : this->Techniques)
  {
    if (technique->GetVisibilityForm() == vtkShadowTechniquePass::MASK)
    {
      const std::string sampler = technique->GetSamplerName();
      code << "uniform sampler2DArray " << sampler << ";\nuniform float "
           << vtkShadowUniforms::Receives(sampler) << ";\n";
    }
    code << technique->GetLookupDeclarations();
  }
  if (this->HasMasks && this->MaskIsPixels)
  {
    code << "#define SHADOW_MASK_TEXEL ivec2(gl_FragCoord.xy)\n" << vtkShadowedShadingPassFS;
  }
  else if (this->HasMasks)
  {
    code
      << "uniform vec2 shadowMaskOrigin;\nuniform vec2 shadowMaskScale;\n"
         "#define SHADOW_MASK_TEXEL ivec2((gl_FragCoord.xy - shadowMaskOrigin) * shadowMaskScale)\n"
      << vtkShadowedShadingPassFS;
  }
  for (std::size_t i = 0; i < this->Plan.size(); ++i)
  {
    if (this->Plan[i].Technique && this->Plan[i].Strength < 1.0f)
    {
      code << "uniform float " << vtkShadowUniforms::Strength(i) << ";\n";
    }
    if (this->Plan[i].Technique && this->Plan[i].MaximumDistance > 0.0f)
    {
      code << "uniform vec2 " << vtkShadowUniforms::Distance(i) << ";\n";
    }
  }
  return code.str() + this->Falloffs->Declarations();
}

//------------------------------------------------------------------------------
// A light's space goes through the rasteriser rather than being transformed to for each fragment: a
// software rasteriser reads the 16 uniforms of a matrix for every few pixels.
void vtkShadowedShadingPass::PlacePositions(std::string& vertexShader, std::string& fragmentShader,
  bool isPlain, vtkAbstractMapper* mapper, vtkProp* prop) const
{
  std::vector<std::size_t> lookups;
  if (this->CurrentStage != POSITIONS)
  {
    std::copy_if(this->Lookups.begin(), this->Lookups.end(), std::back_inserter(lookups),
      [&](std::size_t light) { return this->Tells(light, mapper, prop); });
  }

  const bool isWideFloor = this->WideFloors->Has(mapper, prop);
  const char* place = isWideFloor ? vtkShadowWideFloors::PlaceCode() : "vertexVC";
  std::ostringstream vertexDeclarations, vertexCode, fragmentDeclarations;
  for (std::size_t n = 0; n < lookups.size(); ++n)
  {
    const std::string varying = PositionVarying(lookups[n]),
                      matrix = vtkShadowUniforms::Matrix(lookups[n]);
    if (isPlain && !isWideFloor && n < MostVaryings)
    {
      vertexDeclarations << "uniform mat4 " << matrix << ";\nout vec4 " << varying << ";\n";
      vertexCode << "  " << varying << " = " << matrix << " * vertexVCVSOutput;\n";
      fragmentDeclarations << "in vec4 " << varying << ";\n";
    }
    else
    {
      fragmentDeclarations << "uniform mat4 " << matrix << ";\n#define " << varying << " ("
                           << matrix << " * " << place << ")\n";
    }
  }
  if (isWideFloor)
  {
    fragmentDeclarations << vtkShadowWideFloors::Declarations();
  }
  vtkShaderProgram::Substitute(vertexShader, VertexDeclarationMark, vertexDeclarations.str());
  vtkShaderProgram::Substitute(vertexShader, VertexMark, vertexCode.str());
  vtkShaderProgram::Substitute(
    fragmentShader, DeclarationMark, fragmentDeclarations.str() + this->Declarations());
}

//------------------------------------------------------------------------------
// What a light's colour is multiplied by: its visibility, as far as shadow is wanted.
std::string vtkShadowedShadingPass::FactorCode(std::size_t light) const
{
  const LightPlan& plan = this->Plan[light];
  std::string strength =
    plan.Strength < 1.0f ? vtkShadowUniforms::Strength(light) : std::string("1.0");
  if (plan.MaximumDistance > 0.0f)
  {
    const std::string distance = vtkShadowUniforms::Distance(light);
    strength +=
      " * clamp((" + distance + ".x - length(vertexVC.xyz)) * " + distance + ".y, 0.0, 1.0)";
  }
  return plan.Weakens() ? "mix(1.0, " + Visibility(light) + ", " + strength + ")"
                        : Visibility(light);
}

//------------------------------------------------------------------------------
// What lookups are told by way of the vertices, and which object a fragment is of, for those that
// ask; returns what the fragment shader declares.
std::string vtkShadowedShadingPass::PlaceVertexCode(std::string& vertexShader, bool byVertex) const
{
  std::string declarations;
  for (const vtkShadowTechniquePass* technique : this->Techniques)
  {
    if (this->CurrentStage != POSITIONS)
    {
      declarations += Place(vertexShader, technique->GetLookupCode(byVertex)) +
        Place(vertexShader, technique->GetObjectCode(byVertex));
    }
  }
  return declarations;
}

//------------------------------------------------------------------------------
std::string vtkShadowedShadingPass::LightCode(const std::string& fragmentShader, bool isImpostor,
  bool isCatcher, vtkAbstractMapper* mapper, vtkProp* prop) const
{
  std::ostringstream code;
  if (isCatcher)
  {
    code << "  vec2 shadowSurface = shadowCatcherSurface(ambientColor, diffuseColor, "
            "specularColor);\n";
  }
  if (isImpostor)
  {
    code
      << "  vec3 shadowAlong1 = normalize(cross(normalVCVSOutput, abs(normalVCVSOutput.x) < 0.6 ? "
         "vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));\n"
         "  vec3 shadowAlong2 = cross(normalVCVSOutput, shadowAlong1);\n";
  }
  for (std::size_t i = 0; i < this->Plan.size(); ++i)
  {
    const LightPlan& light = this->Plan[i];
    const std::string color = ColorUniform(i);
    const bool isTold = this->Tells(i, mapper, prop);
    const bool fallsOff = this->Falloffs->Has(i);
    if (!Declares(fragmentShader, color) || (!isTold && !isCatcher && !fallsOff))
    {
      continue;
    }
    const std::string arriving = fallsOff ? color + " * " + this->Falloffs->FactorCode(i) : color;
    if (!isTold)
    {
      code << "  vec3 " << color << " = "
           << (isCatcher ? "shadowCatcherLight(" + arriving + ", 1.0)" : arriving) << ";\n";
      continue;
    }
    const bool isMask = light.Technique->GetVisibilityForm() == vtkShadowTechniquePass::MASK;
    code << "  float " << Visibility(i) << " = ";
    if (isMask)
    {
      const std::string sampler = light.Technique->GetSamplerName();
      code << "shadowMaskVisibility(" << sampler << ", " << light.Slot << ", "
           << vtkShadowUniforms::Receives(sampler) << ");\n";
    }
    else
    {
      code << light.Technique->GetLookupFunction(light.Slot, prop) << "("
           << light.Technique->GetLookupIndex(light.Slot) << ", " << PositionVarying(i);
      if (isImpostor)
      {
        code << ", " << vtkShadowUniforms::Matrix(i) << " * vec4(shadowAlong1, 0.0), "
             << vtkShadowUniforms::Matrix(i) << " * vec4(shadowAlong2, 0.0)";
      }
      code << ");\n";
    }
    const std::string factor = this->FactorCode(i);
    code << "  vec3 " << color << " = "
         << (isCatcher ? "shadowCatcherLight(" + arriving + ", " + factor + ")"
                       : arriving + " * " + factor)
         << ";\n";
  }
  return code.str();
}

//------------------------------------------------------------------------------
std::string vtkShadowedShadingPass::OutputCode(const std::string& fragmentShader, bool isImpostor,
  vtkAbstractMapper* mapper, vtkProp* prop) const
{
  if (this->CurrentStage == POSITIONS)
  {
    const std::string place =
      this->WideFloors->Has(mapper, prop) ? vtkShadowWideFloors::PlaceCode() : "vertexVC";
    return isImpostor ? "  gl_FragData[0] = shadowReceiver(vertexVC.xyz, normalVCVSOutput);\n"
                      : "  gl_FragData[0] = shadowReceiver(" + place + ".xyz);\n";
  }
  if (this->CurrentStage == VISIBILITY)
  {
    const std::size_t shown = static_cast<std::size_t>(this->ShownLight);
    const bool hasLight = shown < this->Plan.size() && this->Tells(shown, mapper, prop) &&
      Declares(fragmentShader, ColorUniform(shown));
    return "  gl_FragData[0] = vec4(" + (hasLight ? Visibility(shown) : "1.0") + ");\n";
  }
  return {};
}

//------------------------------------------------------------------------------
bool vtkShadowedShadingPass::PreReplaceShaderValues(std::string& vertexShader, std::string&,
  std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  if (this->DrawsDepthAlone())
  {
    // Depth alone, by a program of its own: without lighting there are no normals to interpolate,
    // and without a transparent colour nothing to discard but what a texture with holes discards.
    // Impostors keep their own discards.
    vtkShaderProgram::Substitute(
      fragmentShader, "//VTK::System::Dec", "//VTK::System::Dec\n// shadow casters\n", false);
    std::string output = "  gl_FragData[0] = vec4(1.0, gl_FragCoord.z, 1.0, 1.0);\n";
    if ((this->CurrentStage == CASTERS || this->CurrentStage == TEXELS) &&
      this->Dithered.count(prop) != 0)
    {
      vtkShaderProgram::Substitute(
        fragmentShader, "//VTK::Light::Dec", std::string(vtkShadowDitherFS), false);
      output = "  if (!shadowHolds(opacity)) { discard; }\n" + output;
    }
    if (this->CurrentStage == TRANSMITTANCE)
    {
      output = "  gl_FragData[0] = vec4(clamp(1.0 - opacity, 0.0, 1.0));\n";
    }
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::Light::Impl", output, false);
    return true;
  }
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::System::Dec",
    "//VTK::System::Dec\n#extension GL_ARB_texture_gather : enable\n", false);
  if (Mark(vertexShader, VertexDeclarationMark, "//VTK::PositionVC::Dec"))
  {
    const std::string tag = "//VTK::PositionVC::Impl";
    vtkShaderProgram::Substitute(vertexShader, tag, tag + "\n" + VertexMark, false);
  }
  const bool found = Mark(fragmentShader, DeclarationMark, "//VTK::Light::Dec") &&
    Mark(fragmentShader, LightMark, "//VTK::Light::Impl") &&
    Mark(fragmentShader, OutputMark, "//VTK::DepthPeeling::Impl");
  if (found && this->IsCatcher(prop))
  {
    const std::string tag = "//VTK::Light::Impl";
    // Its property's opacity of 0 would discard it.
    vtkShaderProgram::Substitute(
      fragmentShader, tag, "  opacity = 1.0;\n" + tag + "\n" + CatcherMark, false);
  }
  if (!found)
  {
    if (!this->Complained)
    {
      vtkErrorMacro("The fragment shader of "
        << prop->GetClassName() << " (" << prop
        << ") lacks the tags //VTK::Light::Dec, //VTK::Light::Impl and //VTK::DepthPeeling::Impl: "
           "it is "
           "drawn lit. Keep these tags in a fragment shader of your own to have it shadowed.");
      this->Complained = true;
    }
    for (const char* mark : { DeclarationMark, LightMark, OutputMark })
    {
      vtkShaderProgram::Substitute(fragmentShader, mark, "");
    }
    if (this->CurrentStage != SHADE)
    {
      AppendToMain(fragmentShader, this->NoReceiver());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowedShadingPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  if (this->DrawsDepthAlone())
  {
    if (this->CurrentStage != COVERAGE)
    {
      PlaceSurface(geometryShader, fragmentShader, this->DrawsCasters());
    }
    if (this->CurrentStage == TEXELS)
    {
      this->PlaceTexels(vertexShader, geometryShader, fragmentShader);
    }
    if (!this->DrawsCasters() && this->WideFloors->Has(mapper, prop))
    {
      this->PlaceDepth(fragmentShader);
    }
    return true;
  }
  // VTK declares a position and colours of lights only where a primitive is lit.
  const bool isLit = Declares(fragmentShader, ColorUniform(0)) &&
    fragmentShader.find("vec4 vertexVC = ") != std::string::npos;
  if (!isLit)
  {
    vtkShaderProgram::Substitute(fragmentShader, LightMark, "");
    vtkShaderProgram::Substitute(fragmentShader, CatcherMark, "  gl_FragData[0] = vec4(0.0);\n");
    vtkShaderProgram::Substitute(fragmentShader, OutputMark, this->NoReceiver());
    return true;
  }
  const Surface surface = SurfaceOf(vertexShader, geometryShader, fragmentShader);
  const bool isImpostor = surface == Surface::Impostor;
  const bool catches = this->CurrentStage == SHADE && this->IsCatcher(prop);
  vtkShaderProgram::Substitute(fragmentShader, LightMark,
    this->CurrentStage == POSITIONS
      ? std::string()
      : this->LightCode(fragmentShader, isImpostor, catches, mapper, prop));
  if (catches)
  {
    // Physically based shading ends in a gamma of 2.2.
    auto* actor = vtkActor::SafeDownCast(prop);
    const bool isCoded = actor && actor->GetProperty()->GetInterpolation() == VTK_PBR;
    const std::string light = isCoded ? "pow(gl_FragData[0].rgb, vec3(2.2))" : "gl_FragData[0].rgb";
    vtkShaderProgram::Substitute(fragmentShader, CatcherMark,
      "  gl_FragData[0] = shadowCatch(" + light + ", shadowSurface, vertexVC);\n");
    vtkShaderProgram::Substitute(
      fragmentShader, DeclarationMark, vtkShadowCatcherFS + std::string(DeclarationMark));
  }
  vtkShaderProgram::Substitute(
    fragmentShader, OutputMark, this->OutputCode(fragmentShader, isImpostor, mapper, prop));
  const std::string told = this->PlaceVertexCode(vertexShader, geometryShader.empty());
  vtkShaderProgram::Substitute(fragmentShader, DeclarationMark, told + DeclarationMark);
  this->PlacePositions(vertexShader, fragmentShader, surface == Surface::Vertices, mapper, prop);
  return true;
}

//------------------------------------------------------------------------------
// The colour that VTK makes is kept for its discards alone.
void vtkShadowedShadingPass::PlaceTexels(
  std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader) const
{
  const bool byVertex = geometryShader.empty();
  const vtkShadowTechniquePass::CasterCode caster = this->Writer->GetCasterCode();
  const std::string object = Place(vertexShader, this->Writer->GetObjectCode(byVertex));
  const bool movesDepth = fragmentShader.find("gl_FragDepth =") != std::string::npos;
  vtkShaderProgram::Substitute(fragmentShader, "gl_FragData[0]", "shadowColour");
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::Output::Dec",
    "out " + caster.OutputType + " shadowTexel;\nvec4 shadowColour = vec4(1.0);\n");
  DeclareAhead(fragmentShader, object + caster.Declarations);
  AppendToMain(fragmentShader,
    std::string("  float depth = ") + (movesDepth ? "gl_FragDepth" : "gl_FragCoord.z") +
      ";\n  shadowTexel = " + caster.Expression + ";\n");
}

//------------------------------------------------------------------------------
// The depth of a wide floor is that of its plane. What hides it is decided by VTK's own depth where
// a pixel must be of what the frame shows.
void vtkShadowedShadingPass::PlaceDepth(std::string& fragmentShader) const
{
  const std::string depth = vtkShadowWideFloors::DepthCode();
  DeclareAhead(fragmentShader, vtkShadowWideFloors::Declarations());
  AppendToMain(fragmentShader,
    this->CurrentStage == COVERAGE ? "  gl_FragData[0].g = " + depth + ";\n"
                                   : "  gl_FragDepth = " + depth + ";\n");
}

//------------------------------------------------------------------------------
// What a pixel without a receiver says in this stage.
std::string vtkShadowedShadingPass::NoReceiver() const
{
  return this->CurrentStage == POSITIONS ? "  gl_FragData[0] = vec4(0.0);\n"
    : this->CurrentStage == VISIBILITY   ? "  gl_FragData[0] = vec4(1.0);\n"
                                         : std::string();
}
