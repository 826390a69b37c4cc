// What is worked out from the shape of a piece, kept until that changes or the piece is gone.
#ifndef vtkShadowByPiece_h
#define vtkShadowByPiece_h

#include "vtkShadowSceneData.h"

#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

template <typename Value>
class vtkShadowByPiece
{
public:
  // A new frame, of these props: what was kept of others is forgotten.
  void BeginFrame(const std::vector<vtkShadowScene::Prop>& props)
  {
    if (this->Known.empty())
    {
      return;
    }
    std::set<Key> present;
    for (const vtkShadowScene::Prop& prop : props)
    {
      for (const vtkShadowScene::Piece& piece : prop.Pieces)
      {
        present.insert({ piece.Prop, piece.Mapper });
      }
    }
    for (auto it = this->Known.begin(); it != this->Known.end();)
    {
      it = present.count(it->first) != 0 ? std::next(it) : this->Known.erase(it);
    }
  }

  // What is kept of the piece; make() is, if nothing is of this shape.
  template <typename Make>
  Value& Of(const vtkShadowScene::Piece& piece, const Make& make)
  {
    Entry& entry = this->Known[{ piece.Prop, piece.Mapper }];
    if (entry.Shape != piece.Shape)
    {
      entry.Shape = piece.Shape;
      entry.Kept = make();
    }
    return entry.Kept;
  }

  template <typename Use>
  void ForEach(const Use& use) const
  {
    for (const auto& known : this->Known)
    {
      use(known.second.Kept);
    }
  }

private:
  using Key = std::pair<vtkProp3D*, vtkMapper*>;
  struct Entry
  {
    std::vector<std::uint64_t> Shape;
    Value Kept;
  };
  std::map<Key, Entry> Known;
};

#endif
