// Contents of the common vertex and index buffers. Source: engine CommonRenderResources.cpp for the order of the
// corners.
#include "CommonRenderResources.h"

#include "RenderUtils.h"

#include <cstddef>
#include <cstring>
#include <iterator>

namespace Drydock
{

namespace
{

template<typename T, size_t Count>
FRHIBuffer* MakeBuffer(const T (&Elements)[Count], EBufferUsageFlags Usage, const TCHAR* Name)
{
	FRHIBuffer* const Buffer = new FRHIBuffer(FRHIBufferDesc(sizeof(Elements), sizeof(T), Usage | BUF_Static), Name);
	Buffer->AddRef();
	Buffer->EnsureMemory();
	std::memcpy(Buffer->GetData(), Elements, sizeof(Elements));
	return Buffer;
}

} // namespace

FRHIVertexDeclaration* GetFilterVertexDeclaration()
{
	static FRHIVertexDeclaration* const Declaration = PipelineStateCache::GetOrCreateVertexDeclaration(
		{FVertexElement(0, offsetof(FFilterVertex, Position), VET_Float4, 0, sizeof(FFilterVertex)),
			FVertexElement(0, offsetof(FFilterVertex, UV), VET_Float2, 1, sizeof(FFilterVertex))});
	return Declaration;
}

FRHIVertexDeclaration* GetTileVertexDeclaration()
{
	static FRHIVertexDeclaration* const Declaration =
		PipelineStateCache::GetOrCreateVertexDeclaration({FVertexElement(0, 0, VET_Float2, 0, sizeof(FVector2f))});
	return Declaration;
}

FRHIVertexDeclaration* GetEmptyVertexDeclaration()
{
	static FRHIVertexDeclaration* const Declaration = PipelineStateCache::GetOrCreateVertexDeclaration({});
	return Declaration;
}

FRHIBuffer* GetScreenRectangleVertexBuffer()
{
	const auto Make = []
	{
		constexpr float Corners[][2] = {{1, 1}, {0, 1}, {1, 0}, {0, 0}, {-1, 1}, {1, -1}};
		FFilterVertex Vertices[std::size(Corners)];
		for (size_t i = 0; i < std::size(Corners); ++i)
		{
			Vertices[i].Position = FVector4f(Corners[i][0], Corners[i][1], 0.0f, 1.0f);
			Vertices[i].UV = FVector2f(Corners[i][0], Corners[i][1]);
		}
		return MakeBuffer(Vertices, BUF_VertexBuffer, TEXT("FScreenRectangleVertexBuffer"));
	};
	static FRHIBuffer* const Buffer = Make();
	return Buffer;
}

FRHIBuffer* GetScreenRectangleIndexBuffer()
{
	constexpr uint16 Indices[] = {0, 1, 2, 2, 1, 3, 0, 4, 5};
	static FRHIBuffer* const Buffer =
		MakeBuffer(Indices, EBufferUsageFlags::IndexBuffer, TEXT("FScreenRectangleIndexBuffer"));
	return Buffer;
}

FRHIBuffer* GetScreenSpaceVertexBuffer()
{
	const FVector2f Corners[] = {FVector2f(-1, -1), FVector2f(-1, 1), FVector2f(1, -1), FVector2f(1, 1)};
	static FRHIBuffer* const Buffer = MakeBuffer(Corners, BUF_VertexBuffer, TEXT("FScreenSpaceVertexBuffer"));
	return Buffer;
}

FRHIBuffer* GetTwoTrianglesIndexBuffer()
{
	constexpr uint16 Indices[] = {0, 1, 3, 0, 3, 2};
	static FRHIBuffer* const Buffer =
		MakeBuffer(Indices, EBufferUsageFlags::IndexBuffer, TEXT("FTwoTrianglesIndexBuffer"));
	return Buffer;
}

} // namespace Drydock

FVertexDeclarationRHIRef& GetVertexDeclarationFVector2()
{
	static FVertexDeclarationRHIRef Declaration =
		PipelineStateCache::GetOrCreateVertexDeclaration({FVertexElement(0, 0, VET_Float2, 0, sizeof(FVector2f))});
	return Declaration;
}

FVertexDeclarationRHIRef& GetVertexDeclarationFVector3()
{
	static FVertexDeclarationRHIRef Declaration =
		PipelineStateCache::GetOrCreateVertexDeclaration({FVertexElement(0, 0, VET_Float3, 0, sizeof(FVector3f))});
	return Declaration;
}

FVertexDeclarationRHIRef& GetVertexDeclarationFVector4()
{
	static FVertexDeclarationRHIRef Declaration =
		PipelineStateCache::GetOrCreateVertexDeclaration({FVertexElement(0, 0, VET_Float4, 0, sizeof(FVector4f))});
	return Declaration;
}
