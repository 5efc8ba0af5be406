// The texture that a frame's views are drawn to, as the view family shows it to plugins.
#pragma once

#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "UnrealClient.h"

namespace Drydock
{

/** A texture of the graph, which the graph may place as it likes, until somebody asks for it: from then on it is one
 * from outside, and whatever registers it draws into the final picture. */
class FFamilyTarget final : public FRenderTarget
{
public:
	using FRenderTarget::GetRenderTargetTexture;

	/** Before anybody asks. */
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
