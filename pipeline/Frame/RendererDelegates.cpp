// Fills a view's part of the delegates' arguments from the view and the scene textures.
#include "Frame/RendererDelegates.h"

#include "EngineModule.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "SceneTextureParameters.h"

namespace Drydock
{

bool HasRendererDelegates()
{
	IRendererModule& Renderer = GetRendererModule();
	return Renderer.GetPostOpaqueRender().IsBound() || Renderer.GetOverlayRender().IsBound() ||
		   Renderer.GetResolvedSceneColorCallbacks().IsBound();
}

void CallRendererDelegates(
	FRDGBuilder& GraphBuilder, const std::vector<FNamedView>& Views, const FSceneTextures& SceneTextures)
{
	IRendererModule& Renderer = GetRendererModule();
	for (const FOnPostOpaqueRender* const Registered : {&Renderer.GetPostOpaqueRender(), &Renderer.GetOverlayRender()})
	{
		for (size_t Index = 0; Registered->IsBound() && Index < Views.size(); ++Index)
		{
			FViewInfo& View = *Views[Index].View;
			FPostOpaqueRenderParameters Parameters;
			Parameters.ViewportRect = View.ViewRect;
			Parameters.ViewMatrix = View.ViewMatrices.GetViewMatrix();
			Parameters.ProjMatrix = View.ViewMatrices.GetProjectionMatrix();
			Parameters.ColorTexture = SceneTextures.Color.Target;
			Parameters.DepthTexture = SceneTextures.Depth.Target;
			Parameters.NormalTexture = SceneTextures.GBufferA;
			Parameters.VelocityTexture = SceneTextures.Velocity;
			Parameters.GraphBuilder = &GraphBuilder;
			Parameters.View = &View;
			Parameters.SceneTexturesUniformParams = CreateSceneTextureUniformBuffer(GraphBuilder, &SceneTextures);
			Parameters.GlobalShaderMap = View.ShaderMap;
			Parameters.Uid = &View;
			Registered->Broadcast(Parameters);
		}
	}
	Renderer.GetResolvedSceneColorCallbacks().Broadcast(GraphBuilder, SceneTextures);
}

} // namespace Drydock
