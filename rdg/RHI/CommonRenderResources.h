// Vertex layouts and buffers that full-screen draws name. No vertex shader runs, so they are empty. Source: engine
// CommonRenderResources.h.
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

/** Makes its declaration when it is asked for. */
class FFullScreenVertexDeclaration : public FRenderResource
{
public:
	struct FLazyDeclaration
	{
		operator FRHIVertexDeclaration*() const
		{
			static FRHIVertexDeclaration* const Declaration = PipelineStateCache::GetOrCreateVertexDeclaration({});
			return Declaration;
		}
		FRHIVertexDeclaration* GetReference() const { return *this; }
	};

	FLazyDeclaration VertexDeclarationRHI;
};

} // namespace Drydock

using FFilterVertexDeclaration = Drydock::FFullScreenVertexDeclaration;
using FEmptyVertexDeclaration = Drydock::FFullScreenVertexDeclaration;
using FScreenRectangleVertexBuffer = FVertexBuffer;
using FScreenRectangleIndexBuffer = FIndexBuffer;

inline TGlobalResource<FFilterVertexDeclaration> GFilterVertexDeclaration;
inline TGlobalResource<FEmptyVertexDeclaration> GEmptyVertexDeclaration;
inline TGlobalResource<FScreenRectangleVertexBuffer> GScreenRectangleVertexBuffer;
inline TGlobalResource<FScreenRectangleIndexBuffer> GScreenRectangleIndexBuffer;
