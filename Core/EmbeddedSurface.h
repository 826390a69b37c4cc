// Whether a closed surface passes through itself.
//
// Of a closed surface that does not, whoever stands outside meets a face that is turned toward him
// first: the others lie behind. Of one that does, parts may be turned inside out, and be seen from
// behind.
#ifndef vtkshadows_EmbeddedSurface_h
#define vtkshadows_EmbeddedSurface_h

#include "ShadowMesh.h"

#include <atomic>

namespace vtkshadows
{

// True only if it is proven that each piece of the mesh is a closed surface of which every edge has
// two triangles, wound alike, and of which no two triangles meet but in the corners and sides that
// they share (what the Jordan-Brouwer theorem asks for). Pieces may pass through each other. False
// if it is not so, if rounding leaves it open, if a search would take much longer than for an
// ordinary surface, or once `cancelled` is set.
//
// Triangles are told apart by axes on which they do not overlap. Whatever the rounding of an axis,
// a gap on it is proof, and gaps count only above a bound of their own rounding.
//
// @par Reference: S. Gottschalk, M. C. Lin, D. Manocha: OBBTree, SIGGRAPH 1996 (separating axes).
bool IsEmbedded(const ShadowMesh<float>& mesh, const std::atomic<bool>& cancelled);

}

#endif
