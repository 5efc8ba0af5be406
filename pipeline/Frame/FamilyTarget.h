// The texture that a frame's views are drawn to, as the view family shows it to plugins.
#pragma once

#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "UnrealClient.h"

namespace Drydock
{

/** The family's texture, of the output's size in pixels and its display format. It is a texture of the graph, which may
 * alias it, until a plugin calls GetRenderTargetTexture. From then on it is an external texture, and a pass that
 * registers and draws it draws into the final picture. Error: a first call inside a running pass is DD2004. */
class FFamilyTarget final : public FRenderTarget
{
public:
	using FRenderTarget::GetRenderTargetTexture;

	/** Must come before the first GetRenderTargetTexture. */
	void SetDesc(const FRHITextureDesc& InDesc) { Desc = InDesc; }

	const FTextureRHIRef& GetRenderTargetTexture() const override
	{
		if (!Texture && InGraph == nullptr)
		{
			Texture = new FRHITexture(Desc, Name);
			Texture->EnsureMemory();
		}
		else if (!Texture)
		{
			Texture = Graph->ConvertToExternalTexture(InGraph)->GetRHI();
		}
		return Texture;
	}
	FIntPoint GetSizeXY() const override { return Desc.Extent; }

	FRDGTextureRef AddTo(FRDGBuilder& GraphBuilder, const FRDGTextureDesc& GraphDesc)
	{
		Graph = &GraphBuilder;
		InGraph = Texture ? RegisterExternalTexture(GraphBuilder, Texture, Name)
						  : GraphBuilder.CreateTexture(GraphDesc, Name);
		return InGraph;
	}

private:
	static constexpr const TCHAR* Name = TEXT("ViewFamilyTexture");

	FRHITextureDesc Desc;
	mutable FTextureRHIRef Texture;
	FRDGBuilder* Graph = nullptr;
	FRDGTextureRef InGraph = nullptr;
};

} // namespace Drydock
