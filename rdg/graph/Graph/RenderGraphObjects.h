// The kinds of objects that a graph hands out pointers to. A pointer left from another graph may point to an object of
// this one, of another kind: a graph knows its objects by both. Ours.
#pragma once

#include "CoreTypes.h"
#include "Misc/EnumClassFlags.h"
#include "RenderGraphFwd.h"

namespace Drydock
{

enum class ERDGObject : uint8
{
	None = 0,
	Texture = 1 << 0,
	Buffer = 1 << 1,
	TextureSRV = 1 << 2,
	TextureUAV = 1 << 3,
	BufferSRV = 1 << 4,
	BufferUAV = 1 << 5,
	UniformBuffer = 1 << 6,
	Pass = 1 << 7,
};
ENUM_CLASS_FLAGS(ERDGObject)

// The kinds of objects that a pointer of that type may point to. The pointer is not dereferenced.
inline ERDGObject GetKinds(const FRDGTexture*)
{
	return ERDGObject::Texture;
}
inline ERDGObject GetKinds(const FRDGBuffer*)
{
	return ERDGObject::Buffer;
}
inline ERDGObject GetKinds(const FRDGViewableResource*)
{
	return ERDGObject::Texture | ERDGObject::Buffer;
}
inline ERDGObject GetKinds(const FRDGTextureSRV*)
{
	return ERDGObject::TextureSRV;
}
inline ERDGObject GetKinds(const FRDGTextureUAV*)
{
	return ERDGObject::TextureUAV;
}
inline ERDGObject GetKinds(const FRDGBufferSRV*)
{
	return ERDGObject::BufferSRV;
}
inline ERDGObject GetKinds(const FRDGBufferUAV*)
{
	return ERDGObject::BufferUAV;
}
inline ERDGObject GetKinds(const FRDGUniformBuffer*)
{
	return ERDGObject::UniformBuffer;
}
inline ERDGObject GetKinds(const FRDGPass*)
{
	return ERDGObject::Pass;
}

} // namespace Drydock
