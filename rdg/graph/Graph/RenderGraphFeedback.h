// A raster pass whose shader reads what the pass renders to. In the engine the graph lets it through, and what such a
// read finds is up to the GPU. Here it finds what was there before the pass, for any number of threads: the pass draws
// to a copy.
#pragma once

#include "RHICommandList.h"
#include "RenderGraphCompiled.h"

#include <vector>

namespace Drydock
{

/** Whether one of the two is a colour target and the other reads texels of it in a shader. */
bool IsFeedback(const FRDGUse& A, const FRDGUse& B);

class FRDGFeedbackTargets
{
public:
	/** Puts copies in the place of those colour targets of Info that the pass reads. GetTexture: of a resource, by its
	 * position in the graph. */
	FRDGFeedbackTargets(
		const FRDGPassDescription& Pass, TFunctionRef<FRHITexture*(int32)> GetTexture, FRHIRenderPassInfo& Info);

	/** Called after the render pass: copies the drawn texels to their target, where they count as drawn. */
	void PutBack(FRHICommandListImmediate& RHICmdList);

private:
	struct FTarget
	{
		FRHITexture* Texture;
		FTextureRHIRef Copy;
	};

	void Redirect(FRHITexture* Texture, FRHIRenderPassInfo& Info);

	std::vector<FTarget> Targets;
};

} // namespace Drydock
