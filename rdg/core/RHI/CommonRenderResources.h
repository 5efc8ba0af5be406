// Vertex layouts and buffers of rectangles of the screen. Source: engine CommonRenderResources.h.
#pragma once

#include "PipelineStateCache.h"
#include "RenderResource.h"

struct FFilterVertex
{
	FVector4f Position;
	FVector2f UV;
};

namespace Drydock
{

/** Something of the RHI that is made when it is first asked for; converts to the engine's pointer. */
template<typename ResourceType, ResourceType* (*Get)()>
struct TLazyResource
{
	operator ResourceType*() const { return Get(); }
	ResourceType* operator->() const { return Get(); }
	ResourceType* GetReference() const { return Get(); }
	bool IsValid() const { return true; }
};

// Made on first use, never freed.
DRYDOCK_API FRHIVertexDeclaration* GetFilterVertexDeclaration();
DRYDOCK_API FRHIVertexDeclaration* GetTileVertexDeclaration();
DRYDOCK_API FRHIVertexDeclaration* GetEmptyVertexDeclaration();
DRYDOCK_API FRHIBuffer* GetScreenRectangleVertexBuffer();
DRYDOCK_API FRHIBuffer* GetScreenRectangleIndexBuffer();
DRYDOCK_API FRHIBuffer* GetScreenSpaceVertexBuffer();
DRYDOCK_API FRHIBuffer* GetTwoTrianglesIndexBuffer();

} // namespace Drydock

/** ATTRIBUTE0: position, four floats; ATTRIBUTE1: UV, two floats; as FFilterVertex. */
class FFilterVertexDeclaration : public FRenderResource
{
public:
	Drydock::TLazyResource<FRHIVertexDeclaration, &Drydock::GetFilterVertexDeclaration> VertexDeclarationRHI;
};

/** ATTRIBUTE0: position, two floats. */
class FTileVertexDeclaration : public FRenderResource
{
public:
	Drydock::TLazyResource<FRHIVertexDeclaration, &Drydock::GetTileVertexDeclaration> VertexDeclarationRHI;
};

/** The declaration for vertex shaders that need SV_VertexID only. */
class FEmptyVertexDeclaration : public FRenderResource
{
public:
	Drydock::TLazyResource<FRHIVertexDeclaration, &Drydock::GetEmptyVertexDeclaration> VertexDeclarationRHI;
};

/** FFilterVertex: the corners (1, 1), (0, 1), (1, 0), (0, 0), then (-1, 1) and (1, -1), each with itself as UV. */
class FScreenRectangleVertexBuffer : public FRenderResource
{
public:
	Drydock::TLazyResource<FRHIBuffer, &Drydock::GetScreenRectangleVertexBuffer> VertexBufferRHI;
};

/** Indices for FScreenRectangleVertexBuffer, 16 bit: two triangles that are the rectangle, then one that covers it. */
class FScreenRectangleIndexBuffer : public FRenderResource
{
public:
	Drydock::TLazyResource<FRHIBuffer, &Drydock::GetScreenRectangleIndexBuffer> IndexBufferRHI;
};

/** FVector2f: the corners of clip space (-1, -1), (-1, 1), (1, -1), (1, 1). */
class FScreenSpaceVertexBuffer : public FRenderResource
{
public:
	Drydock::TLazyResource<FRHIBuffer, &Drydock::GetScreenSpaceVertexBuffer> VertexBufferRHI;
};

/** Indices of four corners of which the first and the last are opposite, 16 bit: 0 1 3 and 0 3 2. */
class FTwoTrianglesIndexBuffer : public FRenderResource
{
public:
	Drydock::TLazyResource<FRHIBuffer, &Drydock::GetTwoTrianglesIndexBuffer> IndexBufferRHI;
};

inline TGlobalResource<FFilterVertexDeclaration> GFilterVertexDeclaration;
inline TGlobalResource<FTileVertexDeclaration> GTileVertexDeclaration;
inline TGlobalResource<FEmptyVertexDeclaration> GEmptyVertexDeclaration;
inline TGlobalResource<FScreenRectangleVertexBuffer> GScreenRectangleVertexBuffer;
inline TGlobalResource<FScreenRectangleIndexBuffer> GScreenRectangleIndexBuffer;
inline TGlobalResource<FScreenSpaceVertexBuffer> GScreenSpaceVertexBuffer;
inline TGlobalResource<FTwoTrianglesIndexBuffer> GTwoTrianglesIndexBuffer;
